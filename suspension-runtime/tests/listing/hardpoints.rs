//! Hardpoints that a program gives a listing.

use nalgebra::Vector3;
use suspension_runtime::{Listing, ModelError, catalogue};

#[test]
fn a_corner_needs_exactly_one_hardpoint_per_point() {
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

/// Without positions, the front end samples possible designs, in which a marker has no position of its own.
#[test]
fn a_kingpin_may_begin_at_a_marker_without_position() {
    let listing = Listing::parse(
        "fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
         free: lower_ball, upper_ball, tie_ball, wheel_centre;
         link lower_fore: lower_front -> lower_ball;
         link lower_aft: lower_rear -> lower_ball;
         link upper_fore: upper_front -> upper_ball;
         link upper_aft: upper_rear -> upper_ball;
         link tie_rod: rack -> tie_ball;
         body upright: lower_ball, upper_ball, tie_ball, wheel_centre;
         point axle: upright;
         point low: upright;
         drive bump: wheel_centre.z;
         wheel: axle -> wheel_centre;
         kingpin: low -> upper_ball;",
    );
    assert_eq!(listing.expect("a listing").drive("bump"), Some(0));
}

#[test]
fn hardpoints_that_make_no_linkage_are_refused_by_name() {
    let text = catalogue::listing("double_wishbone").expect("a layout");
    let listing = Listing::parse(text).expect("a listing");
    let mut hardpoints = listing.design().expect("of all points");
    hardpoints[3].y = f64::NAN;
    let error = listing.model::<15>(&hardpoints).expect_err("not finite");
    let message = error.to_string();
    assert!(message.contains("`upper_rear`"), "{message}");
}
