//! Levenberg and Marquardt's method, by the crate `levenberg-marquardt`: a root sought as the least
//! sum of squared residuals.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::SVector;
use nalgebra_034 as older;
use num_traits::Float;
use older::storage::Owned;
use older::{DMatrix, DVector, Dyn};
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Linkage, Real};

/// A number that the core and the crate compute with.
pub trait Number: Real + Float + older::RealField {}

impl<T: Real + Float + older::RealField> Number for T {}

struct Squares<'a, L: Linkage<N>, const N: usize> {
    linkage: &'a L,
    prescribed: &'a Prescribed<L::Fixed, L::Drives>,
    q: SVector<L::Scalar, N>,
}

impl<T: Number, L: Linkage<N, Scalar = T>, const N: usize> LeastSquaresProblem<T, Dyn, Dyn>
    for Squares<'_, L, N>
{
    type ParameterStorage = Owned<T, Dyn>;
    type ResidualStorage = Owned<T, Dyn>;
    type JacobianStorage = Owned<T, Dyn, Dyn>;

    fn set_params(&mut self, q: &DVector<T>) {
        self.q = SVector::from_column_slice(q.as_slice());
    }

    fn params(&self) -> DVector<T> {
        DVector::from_column_slice(self.q.as_slice())
    }

    fn residuals(&self) -> Option<DVector<T>> {
        let Prescribed { fixed, drives } = self.prescribed;
        let residual = self.linkage.residual(&self.q, &fixed.value, &drives.value);
        Some(DVector::from_column_slice(residual.as_slice()))
    }

    fn jacobian(&self) -> Option<DMatrix<T>> {
        let jacobian = self.linkage.jacobian(&self.q, &self.prescribed.fixed.value);
        Some(DMatrix::from_column_slice(N, N, jacobian.as_slice()))
    }
}

/// Returns the result of the method, with the crate's settings, from `start`: a root or not.
pub fn end_of_descent<T, L, const N: usize>(
    linkage: &L,
    prescribed: &Prescribed<L::Fixed, L::Drives>,
    start: &SVector<T, N>,
) -> SVector<T, N>
where
    T: Number,
    L: Linkage<N, Scalar = T>,
{
    let squares = Squares {
        linkage,
        prescribed,
        q: *start,
    };
    LevenbergMarquardt::new().minimize(squares).0.q
}
