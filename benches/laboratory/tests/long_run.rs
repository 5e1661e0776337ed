//! Many steps back and forth over the published motion.

#[path = "../../../tests/counting/mod.rs"]
mod counting;
#[path = "../../../tests/support/mod.rs"]
mod support;

use counting::{Counting, allocations};
use suspension::mechanism::DriveLaws;
use suspension::mechanism::Law;
use suspension_core::Real;
use suspension_core::linkages::five_link;
use suspension_laboratory::failures::long_run::{LongRun, Stretch, Way};
use suspension_laboratory::failures::truth::Truth;

#[global_allocator]
static ALLOCATOR: Counting = Counting;

type Model<T> = five_link::Model<T>;

fn drives() -> DriveLaws {
    DriveLaws::new([Law::Polynomial(vec![0.7, 0.5, 0.125])])
}

/// The first thousand steps, then three times as many as `later`, each with its allocations.
fn stretches<T: Real>(model: &Model<T>, way: Way, later: u64) -> [(Stretch, usize); 4] {
    let exact = support::five_link_model::<f64>();
    let drives = drives();
    let start = support::motions(
        &exact,
        &support::five_link_rough(),
        support::five_link_inputs,
    )[0];
    let truth = Truth::new(&exact, &drives, &start.position, [0.0, 1.95]).expect("a motion");
    let mut run = LongRun::new(way, model, &truth);
    [1000, later, later, later].map(|steps| {
        let before = allocations();
        let stretch = run.advance(steps);
        assert_eq!(stretch.steps, steps, "no step fails");
        (stretch, allocations() - before)
    })
}

fn assert_no_drift<T: Real>(model: &Model<T>, bound: f64) {
    let [(first, _), later @ ..] = stretches(model, Way::Tracked, 150_000);
    for (stretch, allocations) in later {
        println!("{stretch:?}");
        assert_eq!(allocations, 0);
        assert!(stretch.drift <= bound, "{stretch:?} after {first:?}");
    }
    // The same legs repeatedly: the last one takes no more iterations than the first.
    let [(early, _), _, (late, _)] = later;
    let slack = early.steps / 1000;
    assert!(
        late.iterations <= early.iterations + slack,
        "{early:?} {late:?}"
    );
}

#[test]
fn the_tracker_does_not_drift_over_many_passes_of_the_motion() {
    assert_no_drift(&support::five_link_model::<f64>(), 5e-16);
    assert_no_drift(&support::five_link_model::<f32>(), 3e-7);
}

/// The tracker is compared with integrated velocities.
#[test]
fn integrating_velocities_drifts_over_many_passes_of_the_motion() {
    let model = support::five_link_model::<f64>();
    let drifts = stretches(&model, Way::Integrated, 200_000).map(|(stretch, _)| stretch.drift);
    println!("{drifts:?}");
    assert!(drifts[1] > 1e-13);
    assert!(drifts[3] > 2.0 * drifts[1], "{drifts:?}");
}
