//! The equations of a linkage with one drive set free: `N` equations, `N + 1` unknowns.

use nalgebra::SVector;

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::{Factors as _, Linkage, Values};
use crate::listing::Kind;
use crate::path::configuration::Configuration;
use crate::path::drive_coordinate::DriveCoordinate;
use crate::path::linear::{Linear, name_free_drive};
use crate::signal::{ChassisMotion, Inputs, Signal};
use crate::solve::lu::Lu;
use crate::solve::motion::Prescribed;

/// The pivot growth up to which the factors of the Jacobian are used on a curve: its rates may have this much more
/// rounding error than with partial pivoting.
const GROWTH: f64 = 50.0;

/// The curve of a linkage's configurations with one drive free, while the other drives and the chassis points are
/// held where the inputs have them.
pub struct Curve<'a, L: Linkage<N>, const N: usize> {
    pub(crate) linkage: &'a L,
    pub(crate) drive: usize,
    pub(crate) prescribed: Prescribed<L::Fixed, L::Drives>,
}

impl<'a, T, L, const N: usize> Curve<'a, L, N>
where
    T: Real,
    L: Linkage<N, Scalar = T>,
{
    /// Sets the drive with this index free; `None` if there is none.
    pub fn new<C>(linkage: &'a L, inputs: &Inputs<C, L::Drives>, drive: usize) -> Option<Self>
    where
        C: ChassisMotion<L::Fixed>,
    {
        let exists = drive < linkage.count(Kind::Drive);
        exists.then(|| Self::with_free_drive(linkage, inputs, drive))
    }

    /// [`new`](Self::new) with the index of a drive that exists.
    pub(crate) fn with_free_drive<C>(
        linkage: &'a L,
        inputs: &Inputs<C, L::Drives>,
        drive: usize,
    ) -> Self
    where
        C: ChassisMotion<L::Fixed>,
    {
        let Signal {
            value,
            rate,
            second_rate,
        } = inputs.drives;
        let drives = Signal {
            value,
            rate: rate.with(drive, T::zero()),
            second_rate: second_rate.with(drive, T::zero()),
        };
        let chassis = inputs.chassis;
        Self {
            linkage,
            drive,
            prescribed: Prescribed::new(linkage, &Inputs { chassis, drives }),
        }
    }

    /// The configuration with the unknowns `q` and the free drive where the inputs have it.
    pub fn configuration(&self, q: &SVector<T, N>) -> Configuration<T, N> {
        let mut values = self.prescribed.drives.value.values();
        Configuration {
            unknowns: *q,
            drive: values.nth(self.drive).unwrap_or_default(),
        }
    }

    /// The drive's value (an angle in radians, or the coordinate itself) and its rates, from those of its coordinate.
    /// At an angle of 0 or pi, or about an axis at a whole turn, its rates are infinite or NaN.
    pub fn value(&self, coordinate: &Signal<T>) -> Signal<T> {
        self.drive_coordinate().value(coordinate)
    }

    /// The drive's value at a coordinate.
    pub(crate) fn value_at(&self, coordinate: T) -> T {
        self.drive_coordinate().value_at(coordinate)
    }

    /// The coordinate at a value of the drive.
    pub(crate) fn coordinate(&self, value: T) -> T {
        self.drive_coordinate().coordinate(value)
    }

    /// The entry that changes fastest along the curve, at a configuration near it.
    pub(crate) fn steepest(&self, at: &Configuration<T, N>) -> Result<usize, SolveError<T>> {
        // Any regular choice of the parameter gives the tangent.
        if let Some((_, tangent)) = self.factor_jacobian(at) {
            return Ok(tangent.largest_entry());
        }
        // The choice with the healthiest pivots is sure to be regular.
        let mut best = self.linear(at, N);
        for parameter in 0..self.linkage.count(Kind::Unknown) {
            best = match (best, self.linear(at, parameter)) {
                (Ok(best), Ok(next)) if best.growth_squared() <= next.growth_squared() => Ok(best),
                (_, Ok(next)) => Ok(next),
                (best, Err(_)) => best,
            };
        }
        best.map(|linear| linear.tangent.largest_entry())
    }

    /// The relation between the free drive's coordinate and its value.
    pub(crate) fn drive_coordinate(&self) -> DriveCoordinate<T> {
        DriveCoordinate::new(self.linkage, self.drive)
    }

    /// All points.
    pub fn points(&self, at: &Configuration<T, N>) -> L::Points {
        self.linkage.points(&at.unknowns, &self.fixed(at))
    }

    /// All points with their first and second derivatives, from those of the configuration with respect to the same
    /// variable. The chassis points and the other drives are held.
    pub fn moving_points(&self, along: &Signal<Configuration<T, N>>) -> Signal<L::Points> {
        let still = Signal {
            value: self.prescribed.fixed.value,
            rate: L::Fixed::default(),
            second_rate: L::Fixed::default(),
        };
        self.points_with(along, &still)
    }

    /// [`moving_points`](Self::moving_points) with rates of the chassis points.
    pub(crate) fn points_with(
        &self,
        along: &Signal<Configuration<T, N>>,
        chassis: &Signal<L::Fixed>,
    ) -> Signal<L::Points> {
        let value = self.points(&along.value);
        let rate = self.linkage.velocities(
            &value,
            &along.rate.unknowns,
            &self.driven(chassis.rate, along.rate.drive),
        );
        let second_rate = self.linkage.accelerations(
            &value,
            &rate,
            &along.second_rate.unknowns,
            &self.driven(chassis.second_rate, along.second_rate.drive),
        );
        Signal {
            value,
            rate,
            second_rate,
        }
    }

    /// The chassis points in a configuration.
    pub(crate) fn fixed(&self, at: &Configuration<T, N>) -> L::Fixed {
        self.linkage
            .drive_anchors(self.prescribed.fixed.value, &self.drives(at))
    }

    /// The coordinates of all drives in a configuration.
    pub(crate) fn drives(&self, at: &Configuration<T, N>) -> L::Drives {
        self.prescribed.drives.value.with(self.drive, at.drive)
    }

    /// Rates of the chassis points: those of `chassis`, plus those due to the rate `drive` of the free drive.
    pub(crate) fn driven(&self, chassis: L::Fixed, drive: T) -> L::Fixed {
        // `chassis` includes the rates of the other drives' anchors; the free drive's share is added.
        let share = self.drive_share(drive);
        let pairs = chassis.values().zip(share.values());
        L::Fixed::from_values(pairs.map(|(a, b)| a + b))
    }

    /// Rates of the chassis points that the free drive alone moves.
    pub(crate) fn drive_share(&self, rate: T) -> L::Fixed {
        self.linkage.drive_anchors(
            L::Fixed::default(),
            &L::Drives::default().with(self.drive, rate),
        )
    }

    pub(crate) fn residual(&self, at: &Configuration<T, N>) -> SVector<T, N> {
        self.linkage
            .residual(&at.unknowns, &self.fixed(at), &self.drives(at))
    }

    /// `-dF/dh`.
    fn minus_of_drive(&self, at: &Configuration<T, N>) -> SVector<T, N> {
        let unit = L::Drives::default().with(self.drive, T::one());
        let share = self.drive_share(T::one());
        self.linkage
            .drive_rate(&at.unknowns, &self.fixed(at), &share, &unit)
    }

    /// The factors of the Jacobian in the macro's order, and the tangent whose entry of the drive is 1; `None` if
    /// rounding errors would grow by more than [`GROWTH`] with them.
    fn factor_jacobian(
        &self,
        at: &Configuration<T, N>,
    ) -> Option<(L::Factors, Configuration<T, N>)> {
        let factors = self.linkage.factor(&at.unknowns, &self.fixed(at));
        let is_accurate = factors.growth_squared() <= T::constant(GROWTH * GROWTH);
        is_accurate.then(|| {
            let tangent = Configuration {
                unknowns: factors.solve(&self.minus_of_drive(at)),
                drive: T::one(),
            };
            (factors, tangent)
        })
    }

    /// The equations linearised at a configuration, with entry `parameter` held.
    pub(crate) fn linear(
        &self,
        at: &Configuration<T, N>,
        parameter: usize,
    ) -> Result<Linear<L, N>, SolveError<T>> {
        if let Some((factors, tangent)) = self.factor_jacobian(at)
            && let Some(linear) = Linear::from_jacobian(factors, parameter, &tangent)
        {
            return Ok(linear);
        }
        let [minus_of_drive] = self.minus_of_drive(at).data.0;
        let mut matrix = self.linkage.jacobian(&at.unknowns, &self.fixed(at));
        let mut minus_of_parameter = minus_of_drive;
        if let Some(column) = matrix.data.0.get_mut(parameter) {
            minus_of_parameter = column.map(|entry| -entry);
            *column = minus_of_drive.map(|entry| -entry);
        }
        Lu::factor(&matrix)
            .and_then(|lu| Linear::from_matrix(lu, parameter, &SVector::from(minus_of_parameter)))
            .map_err(name_free_drive(parameter, self.drive))
    }
}
