//! Random geometries near the published one: a residual at rounding level or an error, never a
//! panic or a NaN. Failing cases print their values; proptest keeps their seeds.

mod support;

use nalgebra::{SVector, Vector3};
use proptest::prelude::*;
use suspension_core::{
    Build, GeometryError, Inputs, Linkage, Motion, Named, Newton, Real, Signal, Tracker, assemble,
};

/// Displaces each point by up to 3 cm.
fn displaced<P: Named<Vector3<T>>, T: Real>(points: &P, by: &[f64]) -> P {
    let mut values = points.values().zip(by.chunks_exact(3));
    P::from_fn(|_| match values.next() {
        Some((point, by)) => point + Vector3::new(by[0], by[1], by[2]).map(T::constant),
        None => Vector3::zeros(),
    })
}

/// Builds, assembles and drives a displaced geometry; whatever succeeds must be a root.
fn check<T: Real, L: Build<15, Scalar = T>>(
    rough: &L::Points,
    by: &[f64],
    theta: f64,
) -> Result<(), TestCaseError> {
    let design = displaced(rough, by);
    let model = match L::new(&design) {
        Ok(model) => model,
        Err(GeometryError::Collinear { .. }) => return Ok(()),
        Err(error) => return Err(TestCaseError::fail(error.to_string())),
    };
    let drives = |theta: f64| L::Drives::from_fn(|_| T::constant(theta));
    let inputs = |t: T| {
        let speed = T::constant(0.5);
        let value = drives(theta).map(|theta| theta + speed * t);
        Inputs::still(Signal {
            value,
            rate: drives(0.5),
            second_rate: drives(0.0),
        })
    };
    let guess = L::unknowns(rough);
    let mut q = guess;
    match assemble(&Newton::from_afar(), &model, &inputs(T::zero()), &mut q) {
        Ok(converged) => {
            prop_assert!(converged.residual <= converged.tolerance);
            is_root(&model, &inputs(T::zero()), &q)?;
        }
        Err(_) => {
            prop_assert_eq!(q, guess);
            return Ok(());
        }
    }
    let mut motion = Motion::at_rest(q);
    let end = T::constant(0.2);
    let reached = match Tracker::default().advance(&model, inputs, T::zero(), end, &mut motion) {
        Ok(_) => end,
        Err(stopped) => stopped.reached,
    };
    is_root(&model, &inputs(reached), &motion.position)?;
    prop_assert!(motion.acceleration.iter().all(|a| a.is_finite()));
    Ok(())
}

fn is_root<T: Real, L: Linkage<15, Scalar = T>>(
    model: &L,
    inputs: &Inputs<suspension_core::Still, L::Drives>,
    q: &SVector<T, 15>,
) -> Result<(), TestCaseError> {
    let drives = model.coordinates(&inputs.drives).value;
    let residual = model.residual(q, model.fixed(), &drives);
    let bound = T::EPSILON * Newton::<T>::near_by().tolerance * model.size().max(q.amax());
    prop_assert!(
        residual.iter().all(|r| r.abs() <= bound),
        "{residual} > {bound}"
    );
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_root_or_an_error(
        by in prop::collection::vec(-0.03_f64..0.03, 33),
        theta in 0.3_f64..2.6,
    ) {
        use suspension_core::linkages::{attia2003::Model as Listed, five_link::Model as Rigid};
        check::<f64, Listed<f64>>(&support::attia_rough(), &by, theta)?;
        check::<f32, Listed<f32>>(&support::attia_rough(), &by, theta)?;
        check::<f64, Rigid<f64>>(&support::five_link_rough(), &by, theta)?;
        check::<f32, Rigid<f32>>(&support::five_link_rough(), &by, theta)?;
    }

    #[test]
    fn numbers_that_are_none_are_refused(which in 0_usize..33, bad in prop::sample::select(vec![
        f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300,
    ])) {
        use suspension_core::linkages::five_link::Model;
        let mut by = [0.0; 33];
        by[which] = bad;
        let design = displaced(&support::five_link_rough::<f64>(), &by);
        if let Ok(model) = Model::new(&design) {
            let inputs = support::five_link_inputs(0.5);
            let mut q = Model::unknowns(&support::five_link_rough());
            let start = q;
            match assemble(&Newton::from_afar(), &model, &inputs, &mut q) {
                Ok(_) => is_root(&model, &inputs, &q)?,
                Err(_) => prop_assert_eq!(q, start),
            }
        }
    }
}
