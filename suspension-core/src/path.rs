//! Following a mechanism where its drive cannot: through turning points, round closed curves, up
//! to bifurcations.
//!
//! One drive is set free. With its coordinate `h` the configurations `(q, h)` form a
//! [`Curve`]: `N` equations in `N + 1` unknowns. A predictor and a corrector follow it in a
//! local parametrisation (W. C. Rheinboldt and J. V. Burkardt, ACM Transactions on Mathematical
//! Software 9(2), 1983). The parameter is the entry that moves fastest, the predictor is the curve's Taylor series
//! in it, and the corrector is Newton's method with the parameter held. All entries are in units of
//! length. The series is exact because the equations are quadratic in the entries.
//!
//! Along the tangent `t`, oriented by continuity,
//!
//! - the sign of `t_h` changes where the drive turns: there the mechanism, moved by this drive, locks. Two turns within
//!   one stretch are not detected; shorter stretches ([`Continuation::longest`]) separate them;
//! - the sign of `det [J, dF/dh; t^T]` changes where the derivative loses rank, because another
//!   curve crosses (a simple bifurcation). A path ends there and never steps across. An even
//!   number of crossings within one step is not detected.

mod arc;
mod configuration;
mod correct;
mod curve;
mod drive_coordinate;
mod extreme;
mod lead;
mod leader;
mod led;
mod led_step;
mod linear;
mod place;
mod quantity;
mod step;
mod turning;

use nalgebra::SVector;

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::solve::newton::Newton;
use crate::step::tracker::CORRECTION_OF_MOVE;

pub use configuration::Configuration;
pub use curve::Curve;
pub(crate) use drive_coordinate::DriveCoordinate;
pub use lead::measured;
pub use leader::Leader;
pub use led::Led;
use linear::Linear;
pub use place::{End, Place, Stretch, Turning};

/// The number of terms of the predictor.
const ORDER: usize = 4;

/// Settings for following a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Continuation<T> {
    /// The settings with which each place is corrected.
    pub newton: Newton<T>,
    /// The longest step of the parameter, as a fraction of the linkage's size.
    pub longest: T,
    /// The size of the predictor's last term, as a fraction of the linkage's size.
    pub precision: T,
    /// The number of steps that a path may make.
    pub max_steps: usize,
    /// The range within which the drive's value must stay; `None` for no limit.
    pub range: Option<[T; 2]>,
}

impl<T: Real> Default for Continuation<T> {
    fn default() -> Self {
        Self {
            newton: Newton::near_by(),
            longest: T::constant(0.1),
            precision: T::constant(1e-4),
            max_steps: 10_000,
            range: None,
        }
    }
}

/// A path along a curve: an iterator over its stretches. It ends with the first stretch that has an [`End`], or with
/// an error if no step succeeds, however short.
pub struct Path<'a, L: Linkage<N>, const N: usize> {
    curve: Curve<'a, L, N>,
    settings: Continuation<L::Scalar>,
    start: Place<L::Scalar, N>,
    here: Place<L::Scalar, N>,
    /// The equations linearised here, with the parameter that was used up to here.
    linear: Linear<L, N>,
    /// The last step of the parameter.
    last_step: L::Scalar,
    steps: usize,
    ended: bool,
}

impl<T: Real> Continuation<T> {
    /// The path that starts at the configuration with the unknowns `q`, which is corrected first, in the direction in
    /// which the drive's value at first increases, or decreases.
    ///
    /// # Errors
    ///
    /// [`SolveError`] if `q` is not a configuration, or [`SolveError::Singular`] if it is a bifurcation.
    pub fn path<'a, L, const N: usize>(
        &self,
        curve: Curve<'a, L, N>,
        q: &SVector<T, N>,
        increasing: bool,
    ) -> Result<Path<'a, L, N>, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
    {
        let (start, linear) = self.start(&curve, q, increasing)?;
        let last_step = self.longest * curve.linkage.size();
        Ok(Path {
            curve,
            settings: *self,
            start,
            here: start,
            linear,
            last_step,
            steps: 0,
            ended: false,
        })
    }

    fn start<L, const N: usize>(
        &self,
        curve: &Curve<'_, L, N>,
        q: &SVector<T, N>,
        increasing: bool,
    ) -> Result<(Place<T, N>, Linear<L, N>), SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
    {
        let size = curve.linkage.size();
        let guess = curve.configuration(q);
        let parameter = curve.steepest(&guess)?;
        let bound = T::constant(CORRECTION_OF_MOVE) * size;
        let (configuration, report) = curve.correct(&self.newton, guess, parameter, bound)?;
        let linear = curve.linear(&configuration, parameter)?;
        // An angle from an axis increases as its cosine decreases.
        let sign = increasing == curve.drive_coordinate().is_increasing();
        let forwards = Configuration {
            drive: if sign { T::one() } else { -T::one() },
            ..Configuration::zero()
        };
        let tangent = linear.unit_tangent(&forwards);
        let place = curve.place(configuration, &linear, tangent, report.residual());
        Ok((place, linear))
    }
}

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Iterator for Path<'_, L, N> {
    type Item = Result<Stretch<T, N>, SolveError<T>>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.ended {
            return None;
        }
        let stretch = if self.is_out_of_range() {
            Ok(Stretch {
                turning: None,
                place: self.here,
                end: Some(End::OutOfRange),
            })
        } else {
            self.step()
        };
        self.ended = !matches!(stretch, Ok(Stretch { end: None, .. }));
        Some(stretch)
    }
}

impl<'a, T: Real, L: Linkage<N, Scalar = T>, const N: usize> Path<'a, L, N> {
    /// The curve.
    pub fn curve(&self) -> &Curve<'a, L, N> {
        &self.curve
    }

    /// The place that the path has reached; at first its start.
    pub fn here(&self) -> &Place<T, N> {
        &self.here
    }
}

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Curve<'_, L, N> {
    fn place(
        &self,
        configuration: Configuration<T, N>,
        linear: &Linear<L, N>,
        tangent: Configuration<T, N>,
        residual: T,
    ) -> Place<T, N> {
        Place {
            configuration,
            tangent,
            value: self.value_at(configuration.drive),
            residual,
            parameter: tangent.largest_entry(),
            positive: linear.is_positive(&tangent),
        }
    }
}
