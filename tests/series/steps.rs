//! Steps by series alone, and steps that are refused.

use nalgebra::SVector;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::step::series::{InputSeries, Jet, SeriesTracker};
use suspension_core::{Motion, Newton, Real, SolveError, Still, Tracker};

use crate::support::{self, INSTANTS, Reference};

fn inputs_ahead<T: Real, const K: usize>(t: T) -> InputSeries<Still, five_link::Drives<T>, K> {
    InputSeries::still(Jet::of_signal(&support::five_link_inputs(t).drives))
}

fn start<T: Real>(instant: usize) -> (five_link::Model<T>, Motion<T, 15>) {
    let model = support::five_link_model();
    let motions = support::motions(
        &model,
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    (model, motions[instant])
}

/// The worst position at the instants of Table 2 after steps of 1 ms to order `K`.
fn follow<T: Real, const K: usize>(tolerance: f64) -> [f64; 3] {
    let (model, mut motion) = start::<T>(0);
    let tracker = SeriesTracker::within(T::constant(tolerance));
    let reference = Reference::load();
    let (mut worst, mut met) = ([0.0_f64; 3], 0);
    for millisecond in 0..1950_u16 {
        let t = T::constant(f64::from(millisecond) * 1e-3);
        let step = tracker.step(
            &model,
            &inputs_ahead::<_, K>(t),
            T::constant(1e-3),
            &mut motion,
        );
        step.unwrap_or_else(|error| panic!("at {millisecond} ms: {error:?}"));
        let reached = f64::from(millisecond + 1) * 1e-3;
        if let Some(instant) = INSTANTS.iter().position(|instant| *instant == reached) {
            met += 1;
            let pairs = [
                (motion.position, ""),
                (motion.velocity, "v"),
                (motion.acceleration, "a"),
            ];
            for (worst, (found, kind)) in worst.iter_mut().zip(pairs) {
                let found = found.map(|x| x.to_subset().expect("f64"));
                *worst = worst.max((found - reference.unknowns(instant, kind)).amax());
            }
        }
    }
    println!("order {K}: {worst:?}");
    assert_eq!(met, INSTANTS.len() - 1, "all but that of the start");
    worst
}

/// Errors do not add up: 1,950 steps end as near as one.
#[test]
fn steps_by_series_follow_the_published_motion() {
    let [position, velocity, acceleration] = follow::<f64, 8>(1e-14);
    assert!(position < 5e-14 && velocity < 1e-10 && acceleration < 1e-8);
    let [position, ..] = follow::<f64, 4>(1e-8);
    assert!(position < 1e-8);
    let [position, ..] = follow::<f32, 4>(2e-6);
    assert!(position < 1e-5);
}

fn refused<const K: usize>(tolerance: f64, dt: f64) -> SolveError<f64> {
    let (model, before) = start::<f64>(4);
    let mut motion = before;
    let error = SeriesTracker::within(tolerance)
        .step(&model, &inputs_ahead::<_, K>(1.0), dt, &mut motion)
        .expect_err("refused");
    assert_eq!(motion, before, "the state is untouched");
    error
}

#[test]
fn a_step_beyond_the_radius_of_convergence_is_refused() {
    let error = refused::<8>(1.0, 0.6);
    let SolveError::StepTooLong { step, bound, .. } = error else {
        panic!("{error}");
    };
    assert!(step == 0.6 && bound > 0.3 && bound < 0.4, "{error}");
    assert!(
        error.to_string().contains("step 0.600000, allowed 0.3"),
        "{error}"
    );
    assert!(matches!(
        refused::<8>(1.0, -0.6),
        SolveError::StepTooLong { .. }
    ));
}

/// The time at which the published drive turns, s.
const LOCK: f64 = 1.978_367_769_183;

/// Steps by parts of the time to the lock, whatever residual they leave: how many within the radius are
/// taken, and how many beyond the lock.
fn steps_towards_the_lock<const K: usize>() -> [usize; 2] {
    let (model, mut motion) = start::<f64>(4);
    let inputs = support::five_link_inputs;
    let tracker = SeriesTracker::within(1.0);
    let (mut last, mut taken) = (1.0, [0, 0]);
    for t in [1.2, 1.6, 1.9, 1.95, 1.975, 1.978, 1.9783] {
        let followed = Tracker::default().advance(&model, inputs, last, t, &mut motion);
        followed.expect("a regular motion");
        last = t;
        for part in [0.1, 0.2, 0.3, 1.000_1, 1.1, 1.5, 2.0, 3.0] {
            let dt = (LOCK - t) * part;
            let step = tracker.step(&model, &inputs_ahead::<_, K>(t), dt, &mut motion.clone());
            taken[usize::from(part > 1.0)] += usize::from(step.is_ok());
        }
    }
    taken
}

#[test]
fn no_step_by_series_leads_beyond_a_turning_point() {
    let taken = [
        steps_towards_the_lock::<2>(),
        steps_towards_the_lock::<3>(),
        steps_towards_the_lock::<4>(),
        steps_towards_the_lock::<8>(),
    ];
    for [within, beyond] in taken {
        assert!(within >= 20 && beyond == 0, "of 21 and 35: {taken:?}");
    }
}

#[test]
fn a_residual_above_the_tolerance_is_refused() {
    let error = refused::<2>(1e-9, 0.01);
    let SolveError::NotConverged { residual, .. } = error else {
        panic!("{error}");
    };
    assert!(residual > 1e-9 && residual < 1e-5, "{error}");
}

#[test]
fn a_non_finite_step_tolerance_or_input_is_refused() {
    assert_eq!(refused::<6>(1e-9, f64::NAN), SolveError::StepNotFinite);
    assert!(matches!(
        refused::<6>(f64::NAN, 1e-3),
        SolveError::NotConverged { .. }
    ));
    let (model, before) = start::<f64>(4);
    let mut motion = before;
    let mut inputs = inputs_ahead::<f64, 4>(1.0);
    inputs.drives.terms[2].theta = f64::INFINITY;
    let error = SeriesTracker::within(1e-9).step(&model, &inputs, 1e-3, &mut motion);
    assert!(matches!(error, Err(SolveError::Overflow { .. })));
    assert_eq!(motion, before);
}

#[test]
fn a_motion_of_another_assembly_is_refused() {
    let (model, motion) = start::<f64>(4);
    let mut mirrored = Motion {
        positive_determinant: motion.positive_determinant.map(|positive| !positive),
        ..motion
    };
    let before = mirrored;
    let error =
        SeriesTracker::within(1e-9).step(&model, &inputs_ahead::<_, 6>(1.0), 1e-3, &mut mirrored);
    assert!(matches!(error, Err(SolveError::CrossedSingularity { .. })));
    assert_eq!(mirrored, before);
}

/// A root with a mirrored knuckle is no result of a step.
#[test]
fn a_step_by_series_to_a_mirrored_knuckle_is_refused() {
    let model: attia2003::Model<f64> = support::attia_model();
    let plain = Newton {
        max_halvings: 0,
        ..Newton::from_afar()
    };
    let inputs = support::attia_inputs(0.0);
    let mut mirrored = SVector::<f64, 15>::from_iterator(
        (6..=10).flat_map(|number| <[f64; 3]>::from(support::printed_guess(&format!("p{number}")))),
    );
    plain
        .solve(&model, &inputs, &mut mirrored)
        .expect("a root, though not the published one");
    let start = Motion::at_rest(mirrored);
    let mut motion = start;
    let ahead: InputSeries<Still, _, 4> = InputSeries::still(Jet::of_signal(&inputs.drives));
    let step = SeriesTracker::within(1e-12).step(&model, &ahead, 0.0, &mut motion);
    let wrong = SolveError::Mirrored { part: support::P9 };
    assert_eq!((step.expect_err("mirrored"), motion), (wrong, start));
}
