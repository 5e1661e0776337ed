//! Statements of a listing that describe another mechanism in other axes.

use suspension_runtime::Listing;

#[test]
fn sums_and_oblique_directions_are_bound_to_the_axes() {
    let of = |statement: &str| {
        let text = format!(
            "fixed: a at [0.0, 0.0, 0.0], b at [1.0, 0.0, 0.0]; free: tip at [0.3, 0.4, 0.3], end at [0.3, 0.6, 0.3];
             hinge arm: a, b -> tip; link rod: tip -> end; drive turn: angle(a -> tip, z); drive low: end.z; {statement}"
        );
        let listing = Listing::parse(&text).unwrap();
        let sae = listing.bound_to_axes([1.0, -1.0, -1.0]).map(str::to_owned);
        (
            sae,
            listing.bound_to_axes([-1.0, -1.0, 1.0]).map(str::to_owned),
        )
    };
    let side = || Some("side".to_owned());
    assert_eq!(of("drive side: end.x;"), (None, None));
    assert_eq!(of("drive side: end.y + 2 tip.z;"), (None, side()));
    assert_eq!(of("drive side: end.x - end.y;"), (side(), None));
    assert_eq!(of("couple side: end.x = tip.y;"), (side(), None));
    assert_eq!(
        of("drive side: end.x; measure across: tip.x + tip.z;").1,
        Some("across".to_owned())
    );
    let askew = of("drive side: end.x; measure across: tip along [0.0, 1.0, 0.2];");
    assert_eq!(askew, (None, Some("across".to_owned())));
}
