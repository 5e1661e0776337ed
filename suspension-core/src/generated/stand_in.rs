//! The replacement for the code of a listing that has mistakes.

/// `Factors` and the implementations without bodies, for `$n` unknowns, beside the types of the listing, so that code
/// which uses them raises no errors of its own.
#[doc(hidden)]
#[macro_export]
macro_rules! stand_in {
    ($n:literal) => {
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Factors<T>(T);

        impl<T: Scalar> JacobianFactors<T, $n> for Factors<T> {
            fn solve(&self, _: &SVector<T, $n>) -> SVector<T, $n> {
                loop {}
            }
            fn solve_transposed(&self, _: &SVector<T, $n>) -> SVector<T, $n> {
                loop {}
            }
            fn determinant_sign(&self) -> T {
                loop {}
            }
            fn growth_squared(&self) -> T {
                loop {}
            }
        }

        impl<T: Scalar> Linkage<$n> for Model<T> {
            type Scalar = T;
            type Listing = Listing;
            type Fixed = Fixed<T>;
            type Drives = Drives<T>;
            type Measures = Measures<T>;
            type Points = Points<T>;
            type Factors = Factors<T>;

            fn listing(&self) -> Listing {
                loop {}
            }
            fn fixed(&self) -> &Fixed<T> {
                loop {}
            }
            fn size(&self) -> T {
                loop {}
            }
            fn coordinates(&self, _: &Signal<Drives<T>>) -> Signal<Drives<T>> {
                loop {}
            }
            fn put_drives(&self, _: &mut Fixed<T>, _: &Drives<T>) {
                loop {}
            }
            fn residual(&self, _: &SVector<T, $n>, _: &Fixed<T>, _: &Drives<T>) -> SVector<T, $n> {
                loop {}
            }
            fn jacobian(&self, _: &SVector<T, $n>, _: &Fixed<T>) -> SMatrix<T, $n, $n> {
                loop {}
            }
            fn pivots(&self) -> &[[usize; 2]] {
                loop {}
            }
            fn factor(&self, _: &SVector<T, $n>, _: &Fixed<T>) -> Factors<T> {
                loop {}
            }
            fn curvature(
                &self,
                _: &SVector<T, $n>,
                _: &Fixed<T>,
                _: &SVector<T, $n>,
                _: &Fixed<T>,
            ) -> SVector<T, $n> {
                loop {}
            }
            fn drive_rate(
                &self,
                _: &SVector<T, $n>,
                _: &Fixed<T>,
                _: &Fixed<T>,
                _: &Drives<T>,
            ) -> SVector<T, $n> {
                loop {}
            }
            fn chassis_rate(
                &self,
                _: &SVector<T, $n>,
                _: &Fixed<T>,
                _: &Fixed<T>,
            ) -> SVector<T, $n> {
                loop {}
            }
            fn points(&self, _: &SVector<T, $n>, _: &Fixed<T>) -> Points<T> {
                loop {}
            }
            fn velocities(&self, _: &Points<T>, _: &SVector<T, $n>, _: &Fixed<T>) -> Points<T> {
                loop {}
            }
            fn accelerations(
                &self,
                _: &Points<T>,
                _: &Points<T>,
                _: &SVector<T, $n>,
                _: &Fixed<T>,
            ) -> Points<T> {
                loop {}
            }
            fn unknowns(&self, _: &Points<T>) -> SVector<T, $n> {
                loop {}
            }
            fn measures(&self, _: &Signal<Points<T>>) -> Signal<Measures<T>>
            where
                T: Real,
            {
                loop {}
            }
        }

        impl<T: Real> Build<$n> for Model<T> {
            type Lengths = Lengths<T>;

            fn of(_: Listing, _: &Points<T>) -> Result<Self, GeometryError> {
                loop {}
            }
            fn check_pivots(&self, _: &Points<T>) -> Result<(), GeometryError> {
                loop {}
            }
            fn with_lengths(self, _: &Lengths<T>) -> Result<Self, GeometryError> {
                loop {}
            }
            fn with_markers(self, _: &Points<T>) -> Result<Self, GeometryError> {
                loop {}
            }
            fn lengths(&self) -> Lengths<T> {
                loop {}
            }
            fn drives_at(&self, _: &Points<T>) -> Drives<T> {
                loop {}
            }
            fn fit(&self, _: &SVector<T, $n>, _: &Fixed<T>) -> SVector<T, $n> {
                loop {}
            }
        }

        impl<T: Scalar> HasWheel<T> for Points<T> {
            fn wheel(&self) -> [Vector3<T>; 2] {
                loop {}
            }
            fn carrier(&self) -> [Vector3<T>; 3] {
                loop {}
            }
        }

        impl<T: Scalar> HasKingpin<T> for Points<T> {
            fn kingpin(&self) -> [Vector3<T>; 2] {
                loop {}
            }
        }
    };
}
pub use crate::stand_in;
