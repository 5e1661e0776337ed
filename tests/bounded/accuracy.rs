//! The errors of steps, by length, corrections, prediction and outputs.

use suspension_core::linkage::Factors as _;
use suspension_core::solve::tolerance::Tolerance;
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Linkage};

use super::case::{Case, assert_within, attia, five_link, instants, widen};
use crate::support::{INSTANTS, Reference, differences};

/// The largest errors of steps of 1 ms: m, m/s, m/s^2.
const BOUNDS: [f64; 3] = [1e-14, 1e-11, 1e-8];

fn compare_each_millisecond_with_newton<L: Linkage<15, Scalar = f64>>(case: &Case<L>) {
    let found = case.worst(
        &Bounded::<f64>::default(),
        Outputs::Acceleration,
        &instants(1e-3),
    );
    assert_within("1 ms, 1 correction", found, BOUNDS);
}

#[test]
fn one_correction_per_millisecond_is_as_accurate_as_newton() {
    compare_each_millisecond_with_newton(&attia());
    compare_each_millisecond_with_newton(&five_link());
}

/// The health of the pivots of the macro's own order, which a step with partial pivoting hides.
fn worst_growth<L: Linkage<15, Scalar = f64>>(case: &Case<L>) -> f64 {
    let mut motion = case.start;
    let mut worst = 0.0_f64;
    for step in 1..=19_000 {
        let (t, dt) = (f64::from(step) * 1e-4, 1e-4);
        let factors = case.model.factor(&motion.predict(dt), case.model.fixed());
        worst = worst.max(factors.growth_squared().sqrt());
        Bounded::<f64>::default()
            .step(&case.model, &(case.inputs)(t), dt, &mut motion)
            .unwrap_or_else(|error| panic!("at {t} s: {error}"));
    }
    worst
}

/// No pivot is near zero anywhere on the way, so that no step takes the slow path.
#[test]
fn bounded_steps_never_need_partial_pivoting() {
    let growth = [worst_growth(&attia()), worst_growth(&five_link())];
    println!("growth {growth:?}");
    assert!(growth.iter().all(|growth| *growth < 100.0));
}

/// Compares at the instants of Table 2 except the last, which are whole milliseconds.
fn compare_with_reference<L: Linkage<15, Scalar = f64>>(case: &Case<L>) {
    let reference = Reference::load();
    let mut motion = case.start;
    let (mut worst, mut met) = ([0.0; 3], 0);
    for millisecond in 1..=1900 {
        let t = f64::from(millisecond) * 1e-3;
        let inputs = (case.inputs)(t);
        Bounded::<f64>::default()
            .step(&case.model, &inputs, 1e-3, &mut motion)
            .unwrap_or_else(|error| panic!("at {t} s: {error}"));
        let known = INSTANTS
            .iter()
            .position(|instant| (instant - t).abs() < 1e-9);
        if let Some(instant) = known {
            met += 1;
            let mut exact = motion;
            exact.position = reference.unknowns(instant, "");
            exact.velocity = reference.unknowns(instant, "v");
            exact.acceleration = reference.unknowns(instant, "a");
            widen(&mut worst, differences(&motion, &exact));
        }
    }
    assert_eq!(met, INSTANTS.len() - 2, "all but the first and the last");
    assert_within("from 40 digits", worst, BOUNDS);
}

#[test]
fn one_correction_per_millisecond_agrees_with_40_digits() {
    compare_with_reference(&attia());
    compare_with_reference(&five_link());
}

/// With a tolerance that accepts any residual: a further correction reduces the remaining error.
fn compare_corrections<L: Linkage<15, Scalar = f64>>(case: &Case<L>) {
    fn open<const CORRECTIONS: usize>() -> Bounded<f64, CORRECTIONS> {
        let tolerance = 1e12;
        Bounded {
            tolerance: Tolerance::Roundings(tolerance),
            ..Bounded::new()
        }
    }
    let outputs = Outputs::Acceleration;
    let found = |dt| {
        let instants = instants(dt);
        [
            case.worst(&open::<1>(), outputs, &instants),
            case.worst(&open::<2>(), outputs, &instants),
            case.worst(&open::<3>(), outputs, &instants),
            case.worst(&open::<4>(), outputs, &instants),
        ]
    };
    let [one, two, three, _] = found(5e-3);
    assert_within("5 ms, 1 correction", one, [2e-11, 5e-10, 5e-7]);
    assert_within("5 ms, 2 corrections", two, [1e-14, 1e-12, 1e-11]);
    assert_within("5 ms, 3 corrections", three, [1e-14, 1e-12, 1e-11]);
    let [one, two, three, four] = found(2e-2);
    assert_within("20 ms, 1 correction", one, [1e-7, 2e-6, 5e-4]);
    assert_within("20 ms, 2 corrections", two, [1e-10, 2e-9, 5e-7]);
    assert_within("20 ms, 3 corrections", three, [1e-13, 2e-12, 5e-10]);
    assert_within("20 ms, 4 corrections", four, [1e-14, 1e-12, 1e-11]);
}

#[test]
fn errors_of_bounded_steps_decrease_with_corrections() {
    compare_corrections(&attia());
    compare_corrections(&five_link());
}

/// Predictions of each order, with as many corrections as a millisecond takes.
fn compare_orders<L: Linkage<15, Scalar = f64>>(case: &Case<L>) {
    let instants = instants(1e-3);
    let of_last_position = Bounded::<f64, 5, 0>::new();
    let with_velocity = Bounded::<f64, 2, 1>::new();
    let with_acceleration = Bounded::<f64, 2, 2>::new();
    let all = [Outputs::Position, Outputs::Velocity, Outputs::Acceleration];
    for outputs in all {
        let found = [
            case.worst(&of_last_position, outputs, &instants),
            case.worst(&with_velocity, outputs, &instants),
            case.worst(&with_acceleration, outputs, &instants),
        ];
        for (order, found) in found.into_iter().enumerate() {
            // A rate that is not solved for is an estimate, with an error proportional to the step.
            let velocity = match (outputs, order) {
                (Outputs::Position, 2) => 5e-5,
                (Outputs::Position, _) => 5e-3,
                _ => 1e-11,
            };
            let acceleration = if outputs == Outputs::Acceleration {
                1e-8
            } else {
                10.0
            };
            let bounds = [1e-14, velocity, acceleration];
            assert_within(&format!("{outputs:?}, order {order}"), found, bounds);
        }
    }
}

#[test]
fn requested_outputs_are_solved_from_every_order_of_prediction() {
    compare_orders(&attia());
    compare_orders(&five_link());
}

/// Ten thousand steps of 0.2 ms, a second forth and the same second back: steps for the position only stay on the motion,
/// and the rates estimated from them do not diverge.
fn assert_no_drift_forth_and_back<L: Linkage<15, Scalar = f64>>(case: &Case<L>) {
    let instants: Vec<f64> = (0..=10_000_u32)
        .map(|step| f64::from(step.min(10_000 - step)) * 2e-4)
        .collect();
    let (outputs, quadratic) = (Outputs::Position, Bounded::<f64, 2, 2>::new());
    let found = case.worst(&quadratic, outputs, &instants);
    assert_within("forth and back, order 2", found, [1e-12, 2e-6, 5e-2]);
    let found = case.worst(&Bounded::<f64, 2, 1>::new(), outputs, &instants);
    assert_within("forth and back, order 1", found, [1e-12, 1e-3, 5.0]);
    let found = case.worst(&Bounded::<f64, 4, 0>::new(), outputs, &instants);
    assert_within("forth and back, order 0", found, [1e-12, 1e-3, 5.0]);
}

#[test]
fn steps_of_positions_alone_do_not_drift() {
    assert_no_drift_forth_and_back(&attia());
    assert_no_drift_forth_and_back(&five_link());
}

/// f32 about the paper's origin, 1.4 m away: see `tests/reference.rs`.
#[test]
fn f32_steps_of_one_millisecond_follow_the_published_motion() {
    let case = attia::<f32>();
    let mut motion = case.start;
    for millisecond in 1..=1950 {
        let inputs = (case.inputs)(millisecond as f32 * 1e-3);
        Bounded::<f32>::default()
            .step(&case.model, &inputs, 1e-3, &mut motion)
            .unwrap_or_else(|error| panic!("at {millisecond} ms: {error}"));
    }
    let difference = motion.position.map(f64::from) - Reference::load().unknowns(8, "");
    assert!(difference.amax() <= 5e-6, "{:e} m", difference.amax());
}
