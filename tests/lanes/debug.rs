//! A simulator prints what it steps while it is developed.

use suspension_core::linkages::double_wishbone::{Corner, Listing};
use suspension_lanes::Lanes;

#[derive(Debug)]
struct Car {
    _front: Corner,
    _lanes: Lanes<Listing, f64, 12, 4>,
}

#[test]
fn a_struct_with_a_corner_and_lanes_is_printed_with_their_states() {
    let front: Corner = Corner::design().expect("a design");
    let car = Car {
        _lanes: Lanes::<Listing, f64, _, 4>::new([*front.model(); 4], &[*front.motion(); 4]),
        _front: front,
    };
    let printed = format!("{car:?}");
    let position = format!("{:?}", front.motion().position);
    assert_eq!(printed.matches(&position).count(), 5, "{printed}");
}
