//! Random geometries near the published one: a residual at rounding level or an error, never a
//! panic or a NaN. Failing cases print their values.

use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::{SVector, Vector3};
use proptest::prelude::*;
use suspension_core::{
    Build, GeometryError, Inputs, Linkage, Motion, Newton, Real, Signal, Tracker, Values, assemble,
};

use crate::support;

/// Displaces each point by up to 3 cm.
fn displaced<P: Values<Vector3<T>>, T: Real>(points: &P, by: &[f64]) -> P {
    let values = points.values().zip(by.chunks_exact(3));
    P::from_values(
        values.map(|(point, by)| point + Vector3::new(by[0], by[1], by[2]).map(T::constant)),
    )
}

/// Builds, assembles and drives a displaced geometry; whatever succeeds must be a root. Tells
/// whether it did assemble.
fn check<T: Real, L: Build<15, Scalar = T, Listing: Default>>(
    rough: &L::Points,
    by: &[f64],
    theta: f64,
) -> Result<bool, TestCaseError> {
    let design = displaced(rough, by);
    let model = match L::of(L::Listing::default(), &design) {
        Ok(model) => model,
        Err(GeometryError::Collinear { .. } | GeometryError::Flat { .. }) => return Ok(false),
        Err(error) => return Err(TestCaseError::fail(error.to_string())),
    };
    let drives = |theta: f64| L::Drives::from_values(std::iter::repeat(T::constant(theta)));
    let inputs = |t: T| {
        let speed = T::constant(0.5);
        let value = drives(theta).map(|theta| theta + speed * t);
        Inputs::still(Signal {
            value,
            rate: drives(0.5),
            second_rate: drives(0.0),
        })
    };
    let guess = model.unknowns(rough);
    let mut q = guess;
    let newton = Newton::from_afar();
    match assemble(&newton, &model, &inputs(T::zero()), &mut q) {
        Ok(converged) => {
            prop_assert!(converged.report.residual() <= converged.report.tolerance());
            is_root(&model, &inputs(T::zero()), &q)?;
            let stretched = q * T::constant(1.001);
            prop_assert!(!newton.is_root(&model, &inputs(T::zero()), &stretched));
        }
        Err(_) => {
            prop_assert_eq!(q, guess);
            return Ok(false);
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
    Ok(true)
}

fn is_root<T: Real, L: Linkage<15, Scalar = T>>(
    model: &L,
    inputs: &Inputs<suspension_core::Still, L::Drives>,
    q: &SVector<T, 15>,
) -> Result<(), TestCaseError> {
    prop_assert!(Newton::near_by().is_root(model, inputs, q));
    let drives = model.coordinates(&inputs.drives).value;
    let residual = model.residual(q, model.fixed(), &drives);
    let bound = Newton::<T>::near_by()
        .tolerance
        .length(T::EPSILON * model.size().max(q.amax()));
    prop_assert!(
        residual.iter().all(|r| r.abs() <= bound),
        "{residual} > {bound}"
    );
    Ok(())
}

/// Counts of geometries tried and assembled, over all threads and cases.
static TRIED: AtomicUsize = AtomicUsize::new(0);
static ASSEMBLED: AtomicUsize = AtomicUsize::new(0);

/// Drives the random geometries, and then demands that enough of them could be.
#[test]
fn random_geometries_give_a_root_or_an_error() {
    use suspension_core::linkages::{attia2003::Model as Listed, five_link::Model as Rigid};
    let config = crate::config(500);
    let cases = (prop::collection::vec(-0.03_f64..0.03, 33), 0.8_f64..2.0);
    proptest!(config, |((by, theta) in cases)| {
        let assembled = [
            check::<f64, Listed<f64>>(&support::attia_rough(), &by, theta)?,
            check::<f32, Listed<f32>>(&support::attia_rough(), &by, theta)?,
            check::<f64, Rigid<f64>>(&support::five_link_rough(), &by, theta)?,
            check::<f32, Rigid<f32>>(&support::five_link_rough(), &by, theta)?,
        ];
        TRIED.fetch_add(assembled.len(), Ordering::Relaxed);
        let successes = assembled.into_iter().filter(|assembled| *assembled).count();
        ASSEMBLED.fetch_add(successes, Ordering::Relaxed);
    });
    let (tried, assembled) = (
        TRIED.load(Ordering::Relaxed),
        ASSEMBLED.load(Ordering::Relaxed),
    );
    println!("{assembled} of {tried} geometries assembled");
    assert!(2 * assembled > tried, "{assembled} of {tried}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..Default::default() })]

    #[test]
    fn non_finite_points_are_refused(which in 0_usize..33, bad in prop::sample::select(vec![
        f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300,
    ])) {
        use suspension_core::linkages::five_link::Model;
        let mut by = [0.0; 33];
        by[which] = bad;
        let design = displaced(&support::five_link_rough::<f64>(), &by);
        if let Ok(model) = Model::new(&design) {
            let inputs = support::five_link_inputs(0.5);
            let mut q = model.unknowns(&support::five_link_rough());
            let start = q;
            match assemble(&Newton::from_afar(), &model, &inputs, &mut q) {
                Ok(_) => is_root(&model, &inputs, &q)?,
                Err(_) => prop_assert_eq!(q, start),
            }
        }
    }

    #[test]
    fn non_finite_rates_leave_the_motion_unchanged(which in 0_usize..2, bad in prop::sample::select(vec![
        f64::NAN, f64::INFINITY, 1e160, 1e300,
    ])) {
        let model = support::five_link_model::<f64>();
        let start = support::motions(&model, &support::five_link_rough(), support::five_link_inputs)[3];
        let mut inputs = support::five_link_inputs(support::INSTANTS[3] + 1e-3);
        let rate = if which == 0 { &mut inputs.drives.rate } else { &mut inputs.drives.second_rate };
        rate.theta = bad;
        let mut motion = start;
        match Tracker::default().step(&model, &inputs, 1e-3, &mut motion) {
            Ok(_) => prop_assert!(motion.acceleration.iter().all(|a| a.is_finite())),
            Err(_) => prop_assert_eq!(motion, start),
        }
    }
}
