//! Steps that are refused: the reason is named, and no bit of the motion changes.

use nalgebra::SVector;
use suspension_core::linkages::five_link;
use suspension_core::listing::Part;
use suspension_core::solve::tolerance::Tolerance;
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Inputs, Linkage, Motion, SolveError, Still, Tracker};

use super::case::{Case, attia, five_link};
use crate::support::{self, differences};

const STEP: f64 = 1e-3;

/// Returns the bits of all numbers, and the sign of the determinant.
fn bits(motion: &Motion<f64, 15>) -> ([SVector<u64, 15>; 3], Option<bool>) {
    let of = |vector: &SVector<f64, 15>| vector.map(f64::to_bits);
    let all = [&motion.position, &motion.velocity, &motion.acceleration];
    (all.map(of), motion.positive_determinant)
}

/// Returns the reason of a refusal.
fn refused<L: Linkage<15, Scalar = f64>, const CORRECTIONS: usize>(
    case: &Case<L>,
    bounded: &Bounded<f64, CORRECTIONS>,
    inputs: &Inputs<Still, L::Drives>,
    dt: f64,
) -> SolveError<f64> {
    let mut motion = case.start;
    let error = bounded
        .step(&case.model, inputs, dt, &mut motion)
        .expect_err("no step");
    assert_eq!(bits(&motion), bits(&case.start));
    error
}

fn too_few_corrections<L: Linkage<15, Scalar = f64>>(case: &Case<L>) {
    let dt = 20e-3;
    let error = refused(case, &Bounded::<f64>::default(), &(case.inputs)(dt), dt);
    let SolveError::NotConverged {
        part,
        residual,
        tolerance,
        iterations: 1,
    } = error
    else {
        panic!("{error}");
    };
    assert!(residual > tolerance && tolerance < 1e-14);
    println!("{}: {error}", case.model.name(part));
    // The message names the equation with the largest residual.
    let open = Bounded::<f64> {
        tolerance: Tolerance::Roundings(1e12),
        ..Bounded::new()
    };
    let mut motion = case.start;
    let inputs = (case.inputs)(dt);
    open.step(&case.model, &inputs, dt, &mut motion)
        .expect("any residual passes");
    let drives = case.model.coordinates(&inputs.drives).value;
    let left = case
        .model
        .residual(&motion.position, case.model.fixed(), &drives);
    assert_eq!(part, Part::Equation(left.iamax()));
    assert!((left.norm() / residual - 1.0).abs() < 1e-3);
}

#[test]
fn a_residual_above_tolerance_names_its_equation() {
    too_few_corrections(&attia());
    too_few_corrections(&five_link());
}

#[test]
fn a_nan_or_negative_tolerance_accepts_nothing() {
    let case = five_link();
    for tolerance in [f64::NAN, -64.0] {
        let bounded = Bounded::<f64> {
            tolerance: Tolerance::Roundings(tolerance),
            ..Bounded::new()
        };
        let error = refused(&case, &bounded, &(case.inputs)(STEP), STEP);
        assert!(matches!(error, SolveError::NotConverged { .. }), "{error}");
    }
}

#[test]
fn non_finite_inputs_are_refused_by_name() {
    let case = five_link();
    let bounded = Bounded::<f64>::default();
    let spoiled = |spoil: fn(&mut Inputs<Still, five_link::Drives<f64>>, f64), bad: f64| {
        let mut inputs = (case.inputs)(STEP);
        spoil(&mut inputs, bad);
        inputs
    };
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let value = spoiled(|inputs, bad| inputs.drives.value.theta = bad, bad);
        let error = refused(&case, &bounded, &value, STEP);
        // The last equation is the drive's.
        assert_eq!(
            error,
            SolveError::NotFinite {
                part: Part::Equation(14)
            }
        );
        let of_the_drive = SolveError::Overflow {
            part: Part::Drive(0),
        };
        let rate = spoiled(|inputs, bad| inputs.drives.rate.theta = bad, bad);
        assert_eq!(refused(&case, &bounded, &rate, STEP), of_the_drive);
        let second_rate = spoiled(|inputs, bad| inputs.drives.second_rate.theta = bad, bad);
        assert_eq!(refused(&case, &bounded, &second_rate, STEP), of_the_drive);
        let error = refused(&case, &bounded, &(case.inputs)(STEP), bad);
        assert_eq!(error, SolveError::StepNotFinite);
        let mut motion = case.start;
        let stepped = Tracker::default().step(&case.model, &(case.inputs)(STEP), bad, &mut motion);
        assert_eq!(
            (stepped, motion),
            (Err(SolveError::StepNotFinite), case.start)
        );
    }
    for large in [1e160, 1e300, -1e300] {
        let rate = spoiled(|inputs, bad| inputs.drives.rate.theta = bad, large);
        let error = refused(&case, &bounded, &rate, STEP);
        assert!(matches!(error, SolveError::Overflow { .. }), "{error}");
        refused(&case, &bounded, &(case.inputs)(STEP), large);
    }
}

/// The refusal of an attempt does not distinguish a value from its rates.
#[test]
fn a_refused_nan_mentions_inputs_rates_and_forces() {
    let case = five_link();
    let mut motion = case.start;
    let mut inputs = (case.inputs)(STEP);
    inputs.drives.value.theta = f64::NAN;
    let (bounded, all) = (Bounded::<f64>::default(), Outputs::Acceleration);
    let refusal = bounded.attempt(all, &case.model, &inputs, STEP, &mut motion);
    let message = refusal.expect_err("a refusal").to_string();
    assert!(
        message.ends_with("look at the inputs and their rates, or at the forces"),
        "{message}"
    );
}

/// A rate that no requested output depends on is not checked.
#[test]
fn a_nan_rate_that_no_requested_output_needs_is_accepted() {
    let case = five_link();
    let mut inputs = (case.inputs)(STEP);
    inputs.drives.second_rate.theta = f64::NAN;
    let mut motion = case.start;
    let bounded = Bounded::<f64>::default();
    bounded
        .step_to(Outputs::Velocity, &case.model, &inputs, STEP, &mut motion)
        .expect("position and velocity are known");
    let [position, velocity, _] = differences(&motion, &case.solution(STEP, &motion_at(STEP)));
    assert!(position < 1e-14 && velocity < 1e-11);
    inputs.drives.rate.theta = f64::NAN;
    bounded
        .step_to(Outputs::Position, &case.model, &inputs, 0.0, &mut motion)
        .expect("the position is known");
}

fn motion_at(t: f64) -> Motion<f64, 15> {
    let case = five_link();
    let mut motion = case.start;
    Bounded::<f64>::default()
        .step(&case.model, &(case.inputs)(t), t, &mut motion)
        .expect("a regular motion");
    motion
}

/// A step of zero length finds the same motion; steps back end at the start.
#[test]
fn steps_of_zero_and_negative_length_are_accepted() {
    let case = attia();
    let bounded = Bounded::<f64>::default();
    let mut motion = case.start;
    let inputs = (case.inputs)(0.0);
    bounded
        .step(&case.model, &inputs, 0.0, &mut motion)
        .expect("the same motion");
    let near = |motion: &Motion<f64, 15>, expected: &Motion<f64, 15>| {
        let [position, velocity, acceleration] = differences(motion, expected);
        assert!(position < 1e-14 && velocity < 1e-12 && acceleration < 1e-10);
    };
    near(&motion, &case.start);
    let end = support::INSTANTS[4];
    let steps = (end / STEP).round() as i32;
    let mut back = support::motions(&case.model, &support::attia_rough(), case.inputs)[4];
    for step in (0..steps).rev() {
        let t = f64::from(step) * STEP;
        bounded
            .step(&case.model, &(case.inputs)(t), -STEP, &mut back)
            .unwrap_or_else(|error| panic!("back to {t} s: {error}"));
    }
    near(&back, &case.start);
}
