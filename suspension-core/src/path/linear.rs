//! The equations linearised at one configuration: the matrix of a local parametrisation.
//!
//! One of the `N + 1` entries is the parameter. Its column is removed from the `N x (N + 1)` derivative:
//! with the drive as parameter this leaves the Jacobian `J`; with an unknown as parameter it leaves `J` with the
//! unknown's column replaced by the drive's (W. C. Rheinboldt and J. V. Burkardt, A locally
//! parameterized continuation process, ACM Transactions on Mathematical Software 9(2), 1983). It is
//! regular wherever the curve is and its tangent has an entry in the parameter, turning points of
//! the drive included.
//!
//! If the Jacobian itself is regular, its factors in the macro's order serve for every parameter, at a
//! fifth of the work. With `u = dq/dh` and an unknown `p` as parameter, `M x = b` is
//! `J x + dF/dh x_h = b` with `x_p = 0`, so that from `J y = b`
//!
//! ```text
//! x = y + u x_h,   x_h = -y_p / u_p,   det M = -u_p det J.
//! ```

use nalgebra::SVector;

use crate::arithmetic::entrywise::plus_multiple;
use crate::arithmetic::magnitude::magnitude;
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::path::configuration::Configuration;
use crate::solve::factored::Factored;
use crate::solve::lu::Lu;

/// The largest entry of the tangent, as a multiple of the parameter's entry, up to which the factors of the Jacobian
/// are used.
const STEEP: f64 = 16.0;

pub(crate) struct Linear<L: Linkage<N>, const N: usize> {
    factored: Factored<L::Factors, L::Scalar, N>,
    /// `u`, if an unknown is the parameter and the factors are those of the Jacobian.
    by_drive: Option<SVector<L::Scalar, N>>,
    pub(crate) parameter: usize,
    /// The tangent whose entry `parameter` is 1.
    pub(crate) tangent: Configuration<L::Scalar, N>,
}

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Linear<L, N> {
    /// Linearises from the factored matrix and the parameter's column with its sign changed.
    pub(crate) fn from_matrix(
        lu: Lu<T, N>,
        parameter: usize,
        minus_column: &SVector<T, N>,
    ) -> Result<Self, SolveError<T>> {
        let along = lu.solve(minus_column);
        magnitude(&along).map_err(SolveError::overflow)?;
        Ok(Self {
            factored: Factored::WithPivoting(lu),
            by_drive: None,
            parameter,
            tangent: placed(&along, parameter, T::one()),
        })
    }

    /// Linearises from the factors of the Jacobian and the tangent with respect to the drive; `None` if the
    /// parameter's entry in the tangent is too small.
    pub(crate) fn from_jacobian(
        factors: L::Factors,
        parameter: usize,
        by_drive: &Configuration<T, N>,
    ) -> Option<Self> {
        let largest = by_drive.entry(by_drive.largest_entry()).abs();
        let entry = by_drive.entry(parameter);
        (largest <= entry.abs() * T::constant(STEEP)).then(|| Self {
            factored: Factored::InFixedOrder(factors),
            by_drive: (parameter < N).then_some(by_drive.unknowns),
            parameter,
            tangent: (*by_drive * (T::one() / entry)).with_entry(parameter, T::one()),
        })
    }

    /// The solution of the linearised equations as a change of configuration, in which the parameter's entry is zero.
    pub(crate) fn solve(&self, right: &SVector<T, N>) -> Configuration<T, N> {
        let solution = self.factored.factors().solve(right);
        let Some(by_drive) = &self.by_drive else {
            return placed(&solution, self.parameter, T::zero());
        };
        let [at_parameter, of_drive] = [&solution, by_drive].map(|x| x.get(self.parameter));
        let drive = match (at_parameter, of_drive) {
            (Some(y), Some(u)) => -*y / *u,
            _ => T::zero(),
        };
        Configuration {
            unknowns: plus_multiple(&solution, by_drive, drive),
            drive,
        }
        .with_entry(self.parameter, T::zero())
    }

    /// The unit tangent, oriented as `before`.
    pub(crate) fn unit_tangent(&self, before: &Configuration<T, N>) -> Configuration<T, N> {
        let length = self.tangent.norm();
        let forwards = self.tangent.dot(before) >= T::zero();
        self.tangent * (if forwards { T::one() } else { -T::one() } / length)
    }

    /// Whether the determinant of all columns with the tangent as last row is positive. By Cramer's rule it has the
    /// sign of the matrix's determinant times the tangent's entry at the parameter, or the opposite sign if an
    /// unknown's column was replaced. It changes along the curve only where the derivative loses rank, which is where
    /// another curve crosses.
    pub(crate) fn is_positive(&self, tangent: &Configuration<T, N>) -> bool {
        let of_drive = self.by_drive.and_then(|u| u.get(self.parameter).copied());
        let of_matrix = self.factored.factors().determinant_sign() * -of_drive.unwrap_or(-T::one());
        let determinant = of_matrix * tangent.entry(self.parameter);
        (determinant > T::zero()) == (self.parameter >= N)
    }

    /// See [`Factors::growth_squared`](crate::linkage::Factors::growth_squared).
    pub(crate) fn growth_squared(&self) -> T {
        self.factored.factors().growth_squared()
    }
}

/// Converts an error of solving with the matrix, which names the unknown of a column: the parameter's column belongs
/// to the free drive.
pub(crate) fn name_free_drive<T>(
    parameter: usize,
    drive: usize,
) -> impl Fn(SolveError<T>) -> SolveError<T> {
    move |mut error| {
        if let SolveError::Singular { part, .. }
        | SolveError::Overflow { part }
        | SolveError::Diverging { part, .. } = &mut error
            && *part == Part::Unknown(parameter)
        {
            *part = Part::Drive(drive);
        }
        error
    }
}

/// A solution as a configuration: its entry at the parameter is the drive's, and `value` takes its place.
fn placed<T: Real, const N: usize>(
    solution: &SVector<T, N>,
    parameter: usize,
    value: T,
) -> Configuration<T, N> {
    let solved = Configuration {
        unknowns: *solution,
        drive: value,
    };
    if parameter >= N {
        return solved;
    }
    let drive = solved.entry(parameter);
    Configuration { drive, ..solved }.with_entry(parameter, value)
}
