//! The requirements for every result.

use nalgebra::SVector;
use suspension_core::signal::ChassisMotion;
use suspension_core::{Inputs, Linkage, Motion, Newton, Real, SolveError};

/// The residual that rounding leaves at a position, as [`Newton`] accepts it.
pub(crate) fn rounding<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
    model: &L,
    q: &SVector<T, N>,
) -> T {
    let rounding = T::EPSILON * model.size().max(q.amax());
    Newton::<T>::near_by().tolerance.length(rounding)
}

/// The largest residual of a position, NaN if one is NaN.
pub(crate) fn residual<T, L, C, const N: usize>(
    model: &L,
    inputs: &Inputs<C, L::Drives>,
    q: &SVector<T, N>,
) -> T
where
    T: Real,
    L: Linkage<N, Scalar = T>,
    C: ChassisMotion<L::Fixed>,
{
    let drives = model.coordinates(&inputs.drives).value;
    let chassis = inputs.chassis.signal(model.fixed()).value;
    let left = model.residual(q, &model.drive_anchors(chassis, &drives), &drives);
    // A number that is not finite times zero is NaN, which the largest entry alone would hide.
    let finite = left.iter().fold(T::zero(), |sum, r| sum + *r * T::zero());
    left.amax() + finite
}

/// Demands finite numbers and a residual within `allowed`.
pub(crate) fn demand_root<T, L, C, const N: usize>(
    model: &L,
    inputs: &Inputs<C, L::Drives>,
    motion: &Motion<T, N>,
    allowed: T,
) where
    T: Real,
    L: Linkage<N, Scalar = T>,
    C: ChassisMotion<L::Fixed>,
{
    let rates = [&motion.velocity, &motion.acceleration];
    assert!(
        rates
            .into_iter()
            .chain([&motion.position])
            .flat_map(|vector| vector.iter())
            .all(|number| number.is_finite()),
        "success with numbers that are none: {motion:?}"
    );
    let left = residual(model, inputs, &motion.position);
    assert!(
        left <= allowed,
        "success with a residual of {left} > {allowed}, size {}, at {:?}",
        model.size(),
        motion.position
    );
}

/// Demands that an error's numbers bear out what it says, and that it names a culprit.
pub(crate) fn demand_cause<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
    model: &L,
    error: &SolveError<T>,
) {
    let name = error.part().map(|part| model.name(part));
    assert!(
        name.is_some_and(|name| name != "?") || matches!(error, SolveError::StepNotFinite),
        "{error:?}"
    );
    let holds = match *error {
        SolveError::Singular {
            pivot, threshold, ..
        } => pivot <= threshold,
        SolveError::Diverging { step, bound, .. } | SolveError::StepTooLong { step, bound, .. } => {
            step > bound
        }
        SolveError::NotConverged {
            residual,
            tolerance,
            ..
        } => residual > tolerance,
        _ => true,
    };
    assert!(holds, "an error that is none: {error:?}");
}

/// Demands that a motion is the same, bit for bit.
pub(crate) fn demand_untouched<T: Real, const N: usize>(
    before: &Motion<T, N>,
    after: &Motion<T, N>,
) {
    demand_same(&before.position, &after.position);
    demand_same(&before.velocity, &after.velocity);
    demand_same(&before.acceleration, &after.acceleration);
    assert_eq!(before.positive_determinant, after.positive_determinant);
}

/// Demands the same bits: NaN is no other number than itself.
pub(crate) fn demand_same<T: Real, const N: usize>(before: &SVector<T, N>, after: &SVector<T, N>) {
    let bits = |vector: &SVector<T, N>| {
        vector.map(|x| -> u64 {
            let wide: f64 = x.to_subset_unchecked();
            wide.to_bits()
        })
    };
    assert_eq!(bits(before), bits(after), "a failure changed its state");
}
