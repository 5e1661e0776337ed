//! No solving call on a model that was read at run time allocates, whether it succeeds or fails; nor does a corner with
//! other hardpoints.

use std::hint::black_box;

use suspension_core::linkages::LISTINGS;
use suspension_core::{Bounded, Build, Inputs, Motion, Signal, Still, Tracker, Values};
use suspension_runtime::{Fitted, Listing, Room, Size, Work};

use crate::counting::{Counting, allocations};

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// A step, in seconds.
const STEP: f64 = 1e-3;

/// The speed of the first drive, per second; each further drive has half the speed in the other direction.
const SPEED: f64 = 0.1;

/// The result of `work`, which must not allocate.
fn without_allocating<R>(what: &str, work: impl FnOnce() -> R) -> R {
    let before = allocations();
    let result = black_box(work());
    let made = allocations() - before;
    assert_eq!(made, 0, "{what} allocates");
    result
}

/// Steps of a model at its design position.
struct Steps<'a>(&'a Listing);

impl Work for Steps<'_> {
    type Answer = ();

    fn on<const N: usize>(self, _: Fitted<'_, N>)
    where
        Room<N>: Size,
    {
        let hardpoints = self.0.design().expect("a design");
        let model = self.0.model::<N>(&hardpoints).expect("a geometry");
        follow(&model, &Values::from_values(hardpoints));
    }
}

/// Makes a corner with hardpoints that differ from the design: a larger suspension of the same shape.
struct Corners<'a>(&'a Listing);

impl Work for Corners<'_> {
    type Answer = ();

    fn on<const N: usize>(self, _: Fitted<'_, N>)
    where
        Room<N>: Size,
    {
        let mut hardpoints = self.0.design().expect("a design");
        hardpoints.iter_mut().for_each(|point| *point *= 1.01);
        let corner = without_allocating("Listing::corner", || self.0.corner::<N>(&hardpoints));
        assert!(corner.is_ok());
    }
}

/// The drives some time after rest.
fn moved<L: Build<N, Scalar = f64>, const N: usize>(
    rest: &L::Drives,
    time: f64,
) -> Inputs<Still, L::Drives> {
    let speeds = std::iter::successors(Some(SPEED), |last| Some(-0.5 * last));
    let values = rest.values().zip(speeds.clone());
    let rates = rest.values().zip(speeds).map(|(_, speed)| speed);
    Inputs::still(Signal {
        value: L::Drives::from_values(values.map(|(rest, speed)| rest + time * speed)),
        rate: L::Drives::from_values(rates),
        ..Signal::default()
    })
}

fn follow<L: Build<N, Scalar = f64>, const N: usize>(model: &L, design: &L::Points) {
    let rest = without_allocating("drives_at", || model.drives_at(design));
    let q = without_allocating("unknowns", || model.unknowns(design));
    let (mut bounded, mut tracked) = (Motion::at_rest(q), Motion::at_rest(q));
    for step in 0..3 {
        let dt = if step == 0 { 0.0 } else { STEP };
        let time = STEP * f64::from(step);
        let inputs = without_allocating("inputs", || moved::<L, N>(&rest, time));
        without_allocating("Bounded::step", || {
            Bounded::<f64>::default().step(model, &inputs, dt, &mut bounded)
        })
        .expect("a regular motion");
        without_allocating("Tracker::step", || {
            Tracker::default().step(model, &inputs, dt, &mut tracked)
        })
        .expect("a regular motion");
        without_allocating("readings", || {
            let points = tracked.points(model, &inputs);
            (model.measures(&points), model.wheel_axis(&points.value))
        });
    }
    fail(model, &rest, &mut tracked);
}

/// Steps that are refused, also after another attempt with partial pivoting.
fn fail<L: Build<N, Scalar = f64>, const N: usize>(
    model: &L,
    rest: &L::Drives,
    motion: &mut Motion<f64, N>,
) {
    for time in [100.0, f64::NAN] {
        let inputs = moved::<L, N>(rest, time);
        without_allocating("Bounded::step that fails", || {
            Bounded::<f64>::default().step(model, &inputs, STEP, motion)
        })
        .expect_err("beyond reach");
        without_allocating("Tracker::step that fails", || {
            Tracker::default().step(model, &inputs, STEP, motion)
        })
        .expect_err("beyond reach");
    }
}

/// Calls `work` with each listing that states a design.
fn for_each_design(work: impl Fn(&Listing)) {
    let texts = LISTINGS.iter().map(|(_, text)| *text);
    let axle = include_str!("../../suspension-runtime/benches/run_time/axle.linkage");
    let mut checked = 0;
    for text in texts.chain([axle]) {
        let listing = Listing::parse(text).expect("a listing");
        if listing.design().is_some() {
            work(&listing);
            checked += 1;
        }
    }
    assert!(checked >= 3, "{checked} listings with a design");
}

#[test]
fn solving_a_model_from_text_does_not_allocate() {
    for_each_design(|listing| listing.in_its_size(Steps(listing)));
}

#[test]
fn a_corner_with_other_hardpoints_does_not_allocate() {
    for_each_design(|listing| listing.in_its_size(Corners(listing)));
}

#[test]
#[should_panic(expected = "a box allocates")]
fn an_allocation_is_detected() {
    without_allocating("a box", || Box::new(black_box(1.0)));
}
