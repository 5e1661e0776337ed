//! Attempts, which have neither partial pivoting nor detailed reasons, and steps without corrections.

use nalgebra::Vector3;
use suspension_core::linkages::attia2003;
use suspension_core::solve::tolerance::Tolerance;
use suspension_core::step::bounded::{Outputs, Refusal};
use suspension_core::{Bounded, Build, Inputs, Linkage, Motion, Signal, SolveError};

use super::case::{Case, attia, five_link};
use crate::support;

const STEP: f64 = 1e-3;
const OUTPUTS: Outputs = Outputs::Acceleration;

fn compare_attempts_with_steps<L: Linkage<15, Scalar = f64>>(case: &Case<L>) {
    let bounded = Bounded::<f64>::default();
    let (mut stepped, mut attempted) = (case.start, case.start);
    for millisecond in 1..=1900 {
        let inputs = (case.inputs)(f64::from(millisecond) * STEP);
        let settled = bounded
            .step(&case.model, &inputs, STEP, &mut stepped)
            .expect("a regular motion");
        let result = bounded.attempt(OUTPUTS, &case.model, &inputs, STEP, &mut attempted);
        assert_eq!((result, attempted), (Ok(settled), stepped));
    }
}

#[test]
fn an_accepted_attempt_equals_the_step() {
    compare_attempts_with_steps(&attia());
    compare_attempts_with_steps(&five_link());
}

#[test]
fn a_refused_attempt_leaves_the_motion_unchanged() {
    let case = five_link();
    let far = (case.inputs)(20.0 * STEP);
    let mut unknown = (case.inputs)(STEP);
    unknown.drives.value.theta = f64::NAN;
    let mut crossed = case.start;
    crossed.positive_determinant = crossed.positive_determinant.map(|sign| !sign);
    let near = (case.inputs)(STEP);
    let cases = [
        (&far, 20.0 * STEP, case.start, Refusal::NotConverged),
        (&unknown, STEP, case.start, Refusal::NotFinite),
        (&near, STEP, crossed, Refusal::CrossedSingularity),
    ];
    for (inputs, dt, start, expected) in cases {
        let mut motion = start;
        let result =
            Bounded::<f64>::default().attempt(OUTPUTS, &case.model, inputs, dt, &mut motion);
        assert_eq!((result, motion), (Err(expected), start));
    }
}

/// Link 6-1 is square to an axis along which its derivative is a pivot.
#[test]
fn attempts_refuse_small_pivots_where_steps_use_partial_pivoting() {
    let rough = support::attia_rough::<f64>();
    let square_to = [Vector3::new(0.0, 0.3, 0.33), Vector3::new(0.3, 0.0, 0.33)];
    let refused = square_to.into_iter().filter(|link| {
        let design = attia2003::Points {
            p6: rough.p1 + link,
            ..rough
        };
        let model = attia2003::Model::of(attia2003::Listing, &design).expect("a geometry");
        let inputs = Inputs::still(Signal {
            value: model.drives_at(&design),
            ..Signal::default()
        });
        let start = Motion::at_rest(model.unknowns(&design));
        let bounded = Bounded::<f64>::default();
        let mut motion = start;
        let result = bounded.attempt(OUTPUTS, &model, &inputs, 0.0, &mut motion);
        bounded
            .step(&model, &inputs, 0.0, &mut start.clone())
            .expect("a step with partial pivoting");
        // Near a pivot of zero other numbers may be NaN.
        match result {
            Err(Refusal::Unhealthy | Refusal::NotFinite) => motion == start,
            _ => false,
        }
    });
    assert_eq!(refused.count(), 1);
}

/// Without corrections the prediction itself must be within the tolerance: in `f64` it never is.
#[test]
fn without_corrections_a_prediction_beyond_rounding_is_refused() {
    let case = attia::<f32>();
    let bounded = Bounded::<f32, 0>::new();
    let mut motion = case.start;
    let long = (case.inputs)(20e-3);
    let result = bounded.step(&case.model, &long, 20e-3, &mut motion);
    let Err(SolveError::Diverging { step, bound, .. }) = result else {
        panic!("{result:?}");
    };
    assert!(step > bound && bound == 64.0 * f32::EPSILON * case.model.size());
    assert_eq!(motion, case.start);
    let case = attia::<f64>();
    let mut motion = case.start;
    let result =
        Bounded::<f64, 0>::new().step(&case.model, &(case.inputs)(STEP), STEP, &mut motion);
    assert!(
        matches!(result, Err(SolveError::Diverging { .. })),
        "{result:?}"
    );
    assert_eq!(motion, case.start);
}

/// Without corrections the residual is below the reported error, even if the tolerance permits errors larger than rounding.
#[test]
fn without_corrections_the_residual_is_within_the_tolerance() {
    let (case, exact) = (five_link::<f32>(), five_link::<f64>());
    for (tolerance, milliseconds) in [(64.0, 1_u16), (1e5, 50)] {
        let bounded = Bounded::<f32, 0> {
            tolerance: Tolerance::Roundings(tolerance),
            ..Bounded::new()
        };
        let dt = f32::from(milliseconds) * 1e-3;
        let mut motion = case.start;
        for step in 1..=1900 / milliseconds {
            let t = f32::from(step) * dt;
            let settled = bounded
                .attempt(OUTPUTS, &case.model, &(case.inputs)(t), dt, &mut motion)
                .expect("a regular motion");
            let position = motion.position.map(f64::from);
            let drives = (exact.inputs)(f64::from(t)).drives;
            let drives = exact.model.coordinates(&drives).value;
            let residual = exact
                .model
                .residual(&position, exact.model.fixed(), &drives);
            // The effect of rounding of the position adds to the error of the step.
            let rounding = 4.0 * f64::from(f32::EPSILON * motion.position.amax());
            let bound = f64::from(settled.residual()) + rounding;
            assert!(residual.norm() < bound, "at {t} s");
            assert!(
                settled.residual() == settled.error() && settled.error() <= settled.tolerance()
            );
        }
    }
}

/// A program passes a refusal on like any other error.
#[test]
fn each_refusal_is_an_error_with_its_own_message() {
    let sentence = |refusal: Refusal| -> String {
        let error: Box<dyn std::error::Error> = refusal.into();
        error.to_string()
    };
    let all = [
        Refusal::NotFinite,
        Refusal::Diverging,
        Refusal::NotConverged,
        Refusal::CrossedSingularity,
        Refusal::Mirrored,
        Refusal::Unhealthy,
    ];
    let sentences: std::collections::BTreeSet<String> = all.map(sentence).into();
    assert_eq!(sentences.len(), all.len());
    assert!(sentences.iter().all(|sentence| sentence.contains(' ')));
}
