//! The stack that steps take on a host: see docs/limits.md.

use std::thread;

use suspension_core::path::{Continuation, Curve};
use suspension_core::{Inputs, Signal, Values};
use suspension_runtime::{Listing, Room, Size};

/// Both corners of an axle: 60 unknowns.
const AXLE: &str = include_str!("../../suspension-runtime/benches/run_time/axle.linkage");

/// The four corners of a car: 108 unknowns.
const CAR: &str = include_str!("../data/car.linkage");

/// The stack that a thread takes for itself, in bytes.
const THREAD: usize = 64 * 1024;

/// Does it in a thread whose stack has so many bytes for each entry of the Jacobian; it ends the process where that is too little.
fn with_stack<const N: usize>(bytes: usize, work: impl FnOnce() + Send + 'static) {
    let size = bytes * N * N + THREAD;
    let thread = thread::Builder::new().stack_size(size).spawn(work);
    thread.expect("a thread").join().expect("no panic");
}

fn refuse_a_step<const N: usize>(text: &str)
where
    Room<N>: Size,
{
    let listing = Listing::parse(text).expect("a listing");
    with_stack::<N>(100, move || {
        let mut corner = listing
            .corner::<N>(&listing.design().expect("points"))
            .expect("a corner");
        let drives = corner.drives();
        corner
            .step(1e-3, Signal::still(drives))
            .expect("the design");
        let far = drives.with(0, 10.0);
        assert!(corner.step(1e-3, Signal::still(far)).is_err());
    });
}

fn follow_a_curve<const N: usize>(text: &str)
where
    Room<N>: Size,
{
    let listing = Listing::parse(text).expect("a listing");
    with_stack::<N>(200, move || {
        let corner = listing
            .corner::<N>(&listing.design().expect("points"))
            .expect("a corner");
        let inputs = Inputs::still(Signal::still(corner.drives()));
        let curve = Curve::new(corner.model(), &inputs, 0).expect("a drive");
        let path = Continuation::default().path(curve, &corner.motion().position, true);
        let steps = path
            .expect("a start")
            .take(20)
            .filter(|step| step.is_ok())
            .count();
        assert!(steps > 2, "{steps}");
    });
}

#[test]
fn a_refused_step_takes_100_bytes_of_stack_per_jacobian_entry() {
    refuse_a_step::<60>(AXLE);
    refuse_a_step::<120>(CAR);
}

#[test]
fn following_a_curve_takes_200_bytes_of_stack_per_jacobian_entry() {
    follow_a_curve::<60>(AXLE);
    follow_a_curve::<120>(CAR);
}

/// Two points on links: few unknowns in a model with room for fifteen.
#[test]
fn making_a_corner_takes_the_stack_of_its_capacity_and_200_kb() {
    const ROOM: usize = 15;
    let text = "fixed: front at [0.2, 0.3, 0.2], rear at [-0.2, 0.3, 0.2];\nfree: hub at [0.0, 0.7, 0.3];\n\
                hinge arm: front, rear -> hub;\ndrive bump: hub.z;";
    let size = 200 * 1024 + 100 * ROOM * ROOM;
    let make = move || {
        let listing = Listing::parse(text).expect("a listing");
        let mut corner = listing
            .corner::<ROOM>(&listing.design().expect("points"))
            .expect("a corner");
        let far = corner.drives().with(0, 10.0);
        assert!(corner.step(1e-3, Signal::still(far)).is_err());
    };
    let thread = thread::Builder::new().stack_size(size).spawn(make);
    thread.expect("a thread").join().expect("no panic");
}
