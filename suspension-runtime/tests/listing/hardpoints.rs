//! Hardpoints that a program gives a listing.

use nalgebra::Vector3;
use suspension_runtime::{Listing, ModelError, catalogue};

#[test]
fn each_point_needs_one_hardpoint_and_no_more() {
    let text = catalogue::listing("double_wishbone").expect("a layout");
    let listing = Listing::parse(text).expect("a listing");
    let design = listing.design().expect("of all points");
    let wanted = design.len();
    assert!(listing.corner::<15>(&design).is_ok());
    for given in [0, 1, wanted - 1, wanted + 1, 2 * wanted] {
        let mut hardpoints = design.clone();
        hardpoints.resize(given, Vector3::new(0.0, 1.0, 2.0));
        let error = listing.corner::<15>(&hardpoints).map(|_| ());
        assert_eq!(error, Err(ModelError::Hardpoints { given, wanted }));
    }
    let message = ModelError::Hardpoints {
        given: 9,
        wanted: 10,
    };
    assert_eq!(
        message.to_string(),
        "the listing has 10 chassis points, free points and markers, and 9 hardpoints are given; give one for each, in \
         the order of the listing"
    );
}
