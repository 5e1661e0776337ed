//! Following a motion by its series alone: one factorisation per step and no iteration.

use super::{ChassisSeries, InputSeries, Jet, PrescribedSeries, Series};
use crate::arithmetic::entrywise::difference;
use crate::arithmetic::magnitude::{index_of_largest, largest, magnitude};
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::model::handedness;
use crate::solve::factored::with_factors_for_rates;
use crate::solve::motion::{Motion, Prescribed};
use crate::solve::newton::rounding_at;
use crate::solve::report::Report;
use crate::solve::tolerance::Tolerance;
use crate::step::tracker::guard::change_of_jacobian;

/// Settings for following a motion by its series to order `K`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeriesTracker<T, const K: usize> {
    /// The largest residual of a result; rounding as for [`Newton`](crate::solve::newton::Newton).
    ///
    /// It applies to positions. A truncated series of order `K` has about `K / dt` times their error in velocities,
    /// and `K^2 / dt^2` times in accelerations.
    pub tolerance: Tolerance<T>,
    /// The longest step, as a fraction of the radius of convergence. The radius is the [estimate](Series::radius)
    /// from the coefficients. Below order 4, where that estimate does not exist or rests on two of them, the estimate
    /// from the change of the Jacobian over the step is used too.
    pub part_of_radius: T,
}

impl<T: Real, const K: usize> SeriesTracker<T, K> {
    /// Settings for steps of up to half the radius of convergence, to residuals of this length.
    pub fn within(length: T) -> Self {
        Self {
            tolerance: Tolerance::Length(length),
            part_of_radius: T::constant(0.5),
        }
    }

    /// Makes one step of length `dt`, in either direction, by the series of the motion.
    ///
    /// `inputs` start at the instant of `motion`. If the position solves them only nearly, one correction with the
    /// factors of this step comes first, so that errors do not add up from step to step.
    ///
    /// # Errors
    ///
    /// [`SolveError::StepTooLong`] and [`SolveError::NotConverged`] according to the fields, the others as for a
    /// [`Tracker`](crate::Tracker); the motion is then unchanged.
    pub fn step<L, C, const N: usize>(
        &self,
        linkage: &L,
        inputs: &InputSeries<C, L::Drives, K>,
        dt: T,
        motion: &mut Motion<T, N>,
    ) -> Result<Report<T>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisSeries<T, L::Fixed, K>,
    {
        const {
            assert!(
                K >= 2,
                "of order 2 or more: the acceleration is the second term"
            )
        };
        let (series, turning) = series_from::<T, L, C, N, K>(linkage, inputs, dt, motion)
            .map_err(|error| error.of_step(dt))?;
        self.check_length(&series, turning, dt)?;
        let [error] = difference(&motion.position, &series.unknowns.value).data.0;
        let error = largest(error);
        let next = series.motion(dt);
        for rates in [&next.velocity, &next.acceleration] {
            magnitude(rates).map_err(|unknown| SolveError::overflow(unknown).of_step(dt))?;
        }
        let Prescribed { fixed, drives } = Prescribed::new(linkage, &inputs.at(dt));
        let residual = linkage.residual(&next.position, &fixed.value, &drives.value);
        let size = magnitude(&residual).map_err(SolveError::not_finite)?;
        let tolerance = self.tolerance.length(rounding_at(linkage, &next.position));
        if size <= tolerance {
            handedness::check(linkage, &next.position, &fixed.value)?;
            *motion = next;
            Ok(Report {
                tolerance,
                residual_squared: size * size,
                error_squared: error * error,
                growth_squared: series.growth * series.growth,
                steps: 1,
                iterations: 1,
            })
        } else {
            Err(SolveError::NotConverged {
                part: Part::Equation(index_of_largest(&residual)),
                residual: size,
                tolerance,
                iterations: 1,
            })
        }
    }

    fn check_length<const N: usize>(
        &self,
        series: &Series<T, N, K>,
        turning: Option<T>,
        dt: T,
    ) -> Result<(), SolveError<T>> {
        let radii = series.radius().into_iter().chain(turning);
        let radius = radii.reduce(|a, b| a.min(b));
        let bound = radius.map(|radius| radius * self.part_of_radius);
        match (bound, series.unknowns.terms.last()) {
            (Some(bound), Some(last)) if dt.abs() > bound => Err(SolveError::StepTooLong {
                part: Part::Unknown(index_of_largest(last)),
                step: dt.abs(),
                bound,
            }),
            _ => Ok(()),
        }
    }
}

/// The order from which the coefficients alone determine the radius. In 75,600 steps of random suspensions beyond a
/// turning point, of orders 1 to 3 with tolerances of 1 and 10 cm, the coefficients and the residual alone accepted
/// 37,121, and with the change of the Jacobian 40; of orders from 4, none were accepted.
const TELLING_ORDER: usize = 4;

/// The series from a motion's position after one correction with the factors that it needs anyway. Below
/// [`TELLING_ORDER`] also an estimate of the radius from the change of the Jacobian over the step `dt`: with `d` the
/// move and `w` as for [`guard`](crate::step::tracker::guard), a motion that turns like a square root has
/// `|w| / |d| = |dt| / (2 R)` to first order.
#[cfg_attr(not(debug_assertions), inline(always))]
fn series_from<T, L, C, const N: usize, const K: usize>(
    linkage: &L,
    inputs: &InputSeries<C, L::Drives, K>,
    dt: T,
    motion: &Motion<T, N>,
) -> Result<(Series<T, N, K>, Option<T>), SolveError<T>>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
    C: ChassisSeries<T, L::Fixed, K>,
{
    let prescribed = PrescribedSeries::new(linkage, inputs);
    let (fixed, drives) = (&prescribed.fixed.value, &prescribed.drives.value);
    let start = &motion.position;
    let (series, turning) = with_factors_for_rates(linkage, start, fixed, |factors| {
        let position = start - factors.solve(&linkage.residual(start, fixed, drives));
        let series = Series::expand::<L, C>(linkage, &prescribed, position, factors)?;
        let turning = (K < TELLING_ORDER).then(|| {
            let moves = difference(&series.unknowns.at(dt).value, &position);
            let chassis = Jet {
                value: L::Fixed::default(),
                ..prescribed.fixed
            };
            let chassis = chassis.signal(dt).value;
            let (change, moved) =
                change_of_jacobian::<L, C::At, N>(linkage, &moves, &chassis, factors);
            let [change] = change.data.0;
            dt.abs() * moved / (largest(change) * T::constant(2.0))
        });
        Ok((series, turning))
    })??;
    match motion.positive_determinant {
        Some(positive) if positive != series.positive_determinant => {
            let moves = series.motion(T::zero()).velocity;
            Err(SolveError::CrossedSingularity {
                part: Part::Unknown(index_of_largest(&moves)),
            })
        }
        _ => Ok((series, turning)),
    }
}
