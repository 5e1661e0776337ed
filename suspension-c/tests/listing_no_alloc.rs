//! Only the calls that make and free a suspension from text allocate.
#![allow(unsafe_code, reason = "an allocator, and what C would pass")]

#[path = "../../tests/counting/mod.rs"]
mod counting;
mod text;

use counting::{Counting, allocations};
use suspension_c::listing;
use suspension_c::shared::{Mass, Masses};
use suspension_c::{InOut, Status};
use text::{PART, from, made, pushrod, to};

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// A body.
const BODY: &[Mass<f64>] = &[Mass {
    count: 3,
    points: [10, 12, 13],
    mass: 20.0,
    centre: [0.0, 0.7, 0.3],
    inertia: [0.5, 0.9, 0.6, 0.0, 0.0, 0.0],
}];

#[test]
fn moving_and_reading_a_corner_does_not_allocate() {
    let listing = pushrod();
    let design = listing.design();
    let before = allocations();
    let mut corner = listing.place(&design).expect("a geometry");
    assert!(allocations() > before, "an allocation is seen");

    let parts = listing.count(PART);
    let (mut drives, mut forces) = ([0.0; 2], [1.0; 3 * 20]);
    let masses = Masses::new(BODY, [0.0, 0.0, -9.81]);
    let mut state = corner.state();
    let (mut tensions, mut reactions) = (vec![0.0; parts], vec![0.0; 3 * 20 * parts]);
    let before = allocations();
    let [bump, steer] = corner.drives();
    corner.step([bump + 0.02, steer], true).expect("a step");
    corner.step([bump + 0.05, steer], false).expect("a step");
    corner
        .step([bump + 9.0, steer], true)
        .expect_err("beyond reach");
    corner
        .step([bump + 9.0, steer], false)
        .expect_err("beyond reach");
    assert!(corner.time() > 1.0);
    let count = state.len();
    assert_eq!(corner.set_state(&state), Status::Ok);
    let read = listing::corner_read_state(corner.get(), to(&mut state), count);
    assert_eq!((read, corner.time()), (Status::Ok, 0.0));
    let (mut points, mut measures, change) = ([0.0; 9 * 20], [0.0; 6], [1.0, 0.0]);
    // SAFETY: the array has 60 numbers, the count that the call gets.
    let both = unsafe { InOut::from_raw(forces.as_mut_ptr()) };
    let added =
        listing::corner_add_masses(corner.get(), (&masses).into(), from(&design), 60, both, 60);
    let statuses = [
        added,
        listing::listing_design(listing.get(), to(&mut points), 3 * 20),
        listing::corner_read_points(corner.get(), to(&mut points), 9 * 20),
        listing::corner_read_measures(corner.get(), to(&mut measures), 6),
        listing::corner_read_derivatives(
            corner.get(),
            from(&change),
            2,
            to(&mut points),
            9 * 20,
            to(&mut measures),
            6,
            None.into(),
        ),
        listing::corner_read_loads(
            corner.get(),
            from(&forces),
            3 * 20,
            to(&mut drives),
            2,
            to(&mut tensions),
            parts,
            to(&mut reactions),
            3 * 20 * parts,
            None.into(),
        ),
    ];
    made(|wheel| listing::corner_read_wheel(corner.get(), wheel)).expect("a wheel");
    made(|kingpin| listing::corner_read_kingpin(corner.get(), kingpin)).expect("a kingpin");
    made(|rotation| listing::corner_read_rotation(corner.get(), rotation)).expect("a wheel");
    made(|wheel| listing::corner_read_wheel_at(corner.get(), 0, wheel)).expect("a wheel");
    made(|wheel| listing::corner_read_wheel_rates(corner.get(), 0, wheel)).expect("a wheel");
    let made = allocations() - before;
    assert_eq!(made, 0, "{made} allocations");
    assert_eq!(statuses, [Status::Ok; 6]);
}
