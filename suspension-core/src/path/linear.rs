//! The equations linearised at one configuration: the matrix of a local parametrisation.
//!
//! One of the `N + 1` entries is the parameter, and its column leaves the `N x (N + 1)` derivative:
//! with the drive as parameter what stays is the Jacobian `J`; with an unknown, `J` where the
//! unknown's column is replaced by the drive's (W. C. Rheinboldt and J. V. Burkardt, A locally
//! parameterized continuation process, ACM Transactions on Mathematical Software 9(2), 1983). It is
//! regular wherever the curve is and its tangent has an entry in the parameter, turning points of
//! the drive included.

use nalgebra::SVector;

use crate::error::SolveError;
use crate::linkage::Factors as _;
use crate::listing::Part;
use crate::lu::Lu;
use crate::magnitude::magnitude;
use crate::path::configuration::Configuration;
use crate::scalar::Real;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Linear<T, const N: usize> {
    pub(crate) lu: Lu<T, N>,
    pub(crate) parameter: usize,
    /// The tangent whose entry `parameter` is 1.
    pub(crate) tangent: Configuration<T, N>,
}

impl<T: Real, const N: usize> Linear<T, N> {
    /// From the factored matrix and the parameter's column, its sign changed.
    pub(crate) fn new(
        lu: Lu<T, N>,
        parameter: usize,
        minus_column: &SVector<T, N>,
    ) -> Result<Self, SolveError<T>> {
        let along = lu.solve(minus_column);
        magnitude(&along).map_err(SolveError::overflow)?;
        Ok(Self {
            lu,
            parameter,
            tangent: placed(&along, parameter, T::one()),
        })
    }

    /// A solution as a change of configuration: the parameter's entry is zero.
    pub(crate) fn along(&self, solution: &SVector<T, N>) -> Configuration<T, N> {
        placed(solution, self.parameter, T::zero())
    }

    /// The unit tangent that points as `before` does.
    pub(crate) fn unit_tangent(&self, before: &Configuration<T, N>) -> Configuration<T, N> {
        let length = self.tangent.norm();
        let forwards = self.tangent.dot(before) >= T::zero();
        self.tangent * (if forwards { T::one() } else { -T::one() } / length)
    }

    /// Whether the determinant of all columns with the tangent as last row is positive. By Cramer's
    /// rule it has the sign of the matrix' determinant times the tangent's entry at the parameter,
    /// the other one where an unknown's column was replaced. It changes along the curve only where
    /// the derivative loses rank: where another curve crosses.
    pub(crate) fn is_positive(&self, tangent: &Configuration<T, N>) -> bool {
        let determinant = self.lu.determinant_sign() * tangent.entry(self.parameter);
        (determinant > T::zero()) == (self.parameter >= N)
    }

    /// The health of the pivots: the norm of their inverses.
    pub(crate) fn growth(&self) -> T {
        self.lu.growth_squared().sqrt()
    }
}

/// An error of solving with the matrix, which names the unknown of a column: that of the parameter is
/// the free drive's.
pub(crate) fn of_drive<T>(
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

/// A solution as a configuration: its entry at the parameter is the drive's, where `value` comes.
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
