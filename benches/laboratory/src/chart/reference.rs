//! The reference motion to about 30 digits, from which errors are measured.

use std::iter::repeat;

use nalgebra::SVector;
use suspension_core::listing::DriveKind;
use suspension_core::solve::lu::Lu;
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Inputs, Linkage, Motion, Signal, SolveError, Tracker, Values};

use super::course::{Course, Given, cast_drives};
use super::method::Coordinates;
use suspension_double_double::DoubleDouble;

/// Position, velocity and acceleration of the free points' coordinates.
pub type Exact<const N: usize> = [SVector<DoubleDouble, N>; 3];

/// A motion in double-double numbers, at each instant of a course.
#[derive(Clone, Debug)]
pub struct Reference<const N: usize> {
    instants: Vec<Exact<N>>,
}

impl<const N: usize> Reference<N> {
    /// Follows the motion from `start`, near the first instant, in `f64` and refines each instant.
    ///
    /// # Errors
    ///
    /// The instant, s, and why there is no motion there.
    pub fn new<L, M, D>(
        model: &L,
        exact: &M,
        start: &Motion<f64, N>,
        course: &Course<D>,
    ) -> Result<Self, (f64, SolveError<f64>)>
    where
        L: Linkage<N, Scalar = f64>,
        M: Linkage<N, Scalar = DoubleDouble>,
        D: Values<f64>,
    {
        let mut motion = *start;
        let mut last = course.times.first().copied().unwrap_or_default();
        let mut instants = Vec::with_capacity(course.times.len());
        for (t, Given { signal, .. }) in course.times.iter().zip(&course.drives) {
            let refined = Tracker::default()
                .step(
                    model,
                    &Inputs::still(cast_drives(signal)),
                    t - last,
                    &mut motion,
                )
                .and_then(|_| refine(model, exact, &motion, &cast_drives(signal)));
            instants.push(refined.map_err(|cause| (*t, cause))?);
            last = *t;
        }
        Ok(Self { instants })
    }

    /// The motion at each instant.
    pub fn instants(&self) -> &[Exact<N>] {
        &self.instants
    }

    /// The coordinates at the first instant.
    pub fn start(&self) -> SVector<f64, N> {
        self.instants[0][0].map(DoubleDouble::nearest)
    }

    /// The largest distance of position, velocity and acceleration from the motion at an instant.
    pub fn distance(&self, index: usize, from: &Coordinates<N>) -> [f64; 3] {
        let exact = &self.instants[index];
        std::array::from_fn(|order| {
            let pairs = exact[order].iter().zip(&from[order]);
            pairs.fold(0.0, |worst: f64, (exact, found)| {
                let off = (*exact - DoubleDouble::from(*found)).nearest().abs();
                if off.is_nan() { off } else { worst.max(off) }
            })
        })
    }
}

/// Corrections to a number known to 13 digits: each gains about as many again.
const CORRECTIONS: usize = 4;

/// Refines a motion near `exact` for the values `drives`: residuals in double-double numbers, corrections with factors in
/// `f64`.
///
/// # Errors
///
/// [`SolveError::Singular`].
pub fn refine<L, M, const N: usize>(
    model: &L,
    exact: &M,
    near: &Motion<f64, N>,
    drives: &Signal<M::Drives>,
) -> Result<Exact<N>, SolveError<f64>>
where
    L: Linkage<N, Scalar = f64>,
    M: Linkage<N, Scalar = DoubleDouble>,
{
    let Prescribed { fixed, drives } = prescribed(exact, drives);
    let points = fixed.value.values();
    let nearest = L::Fixed::from_values(points.map(|point| point.map(DoubleDouble::nearest)));
    let lu = Lu::factor(&model.jacobian(&near.position, &nearest))?;
    let corrected = |from: &SVector<f64, N>, residual: &dyn Fn(&SVector<_, N>) -> SVector<_, N>| {
        let mut x = from.map(DoubleDouble::from);
        for _ in 0..CORRECTIONS {
            let correction = lu.solve(&residual(&x).map(DoubleDouble::nearest));
            x -= correction.map(DoubleDouble::from);
        }
        x
    };
    let position = corrected(&near.position, &|q| {
        exact.residual(q, &fixed.value, &drives.value)
    });
    let jacobian = exact.jacobian(&position, &fixed.value);
    let velocity = corrected(&near.velocity, &|v| {
        jacobian * v - exact.drive_rate(&position, &fixed.value, &fixed.rate, &drives.rate)
    });
    let acceleration = corrected(&near.acceleration, &|a| {
        let (at, second) = (&fixed.value, &fixed.second_rate);
        let driven = exact.drive_rate(&position, at, second, &drives.second_rate);
        let curvature = exact.curvature(&velocity, &fixed.rate, &velocity, &fixed.rate);
        jacobian * a + curvature - driven
    });
    Ok([position, velocity, acceleration])
}

/// Chassis points at rest and the coordinates that drives prescribe. Cosines are of all digits.
fn prescribed<M, const N: usize>(
    exact: &M,
    drives: &Signal<M::Drives>,
) -> Prescribed<M::Fixed, M::Drives>
where
    M: Linkage<N, Scalar = DoubleDouble>,
{
    // At an angle of zero the coordinate of a link is its length, and the rate of an angle about an axis a quarter of it.
    let [zero, one] = [0.0, 1.0].map(DoubleDouble::from);
    let [zeros, ones] = [zero, one].map(|number| M::Drives::from_values(repeat(number)));
    let at_zero = exact.coordinates(&Signal {
        value: zeros,
        rate: ones,
        second_rate: zeros,
    });
    let quarters = at_zero.rate.values();
    let lengths = at_zero.value.values().zip(quarters);
    let mut coordinates = Vec::new();
    let each = lengths.zip(drives.value.values());
    let rates = drives.rate.values().zip(drives.second_rate.values());
    for (drive, (((length, quarter), value), (rate, second_rate))) in each.zip(rates).enumerate() {
        coordinates.push(match exact.drive_kind(drive) {
            DriveKind::Coordinate => [value, rate, second_rate],
            DriveKind::Angle => {
                let (sine, cosine) = value.sine_cosine();
                let second = cosine * rate * rate + sine * second_rate;
                [cosine, -sine * rate, -second].map(|of_one| length * of_one)
            }
            DriveKind::Turn => {
                let four = DoubleDouble::from(4.0);
                let [value, rate, second_rate] = [value, rate, second_rate].map(|of| of / four);
                let (sine, cosine) = value.sine_cosine();
                let second = cosine * second_rate - sine * rate * rate;
                [sine, cosine * rate, second].map(|of_one| quarter * four * of_one)
            }
        });
    }
    let [value, rate, second_rate] =
        [0, 1, 2].map(|order| M::Drives::from_values(coordinates.iter().map(|all| all[order])));
    let at_rest = M::Fixed::default();
    Prescribed {
        fixed: Signal {
            value: exact.drive_anchors(*exact.fixed(), &value),
            rate: exact.drive_anchors(at_rest, &rate),
            second_rate: exact.drive_anchors(at_rest, &second_rate),
        },
        drives: Signal {
            value,
            rate,
            second_rate,
        },
    }
}
