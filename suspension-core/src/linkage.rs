//! The contract between models, which `linkage!` writes or a program makes at run time, and the solvers.

mod build;

use nalgebra::{SMatrix, SVector, Vector3};

use crate::arithmetic::scalar::{Real, Scalar};
use crate::listing::Parts;
use crate::signal::Signal;
pub use crate::values::{Named, Values};
pub use build::{Build, Designed};

/// A factored Jacobian.
pub trait Factors<T, const N: usize> {
    /// Solves `J x = right`.
    fn solve(&self, right: &SVector<T, N>) -> SVector<T, N>;

    /// Solves `J^T y = right`. If `right` holds the forces on the unknowns, `y` holds the multipliers of the
    /// equations.
    fn solve_transposed(&self, right: &SVector<T, N>) -> SVector<T, N>;

    /// A number with the sign of the Jacobian's determinant. The sign changes only where the Jacobian is singular, so
    /// it tells assemblies apart.
    fn determinant_sign(&self) -> T;

    /// Pivot growth, squared: the sum of the squares of the pivots' inverses. Rounding errors grow with its square
    /// root if one pivot is small, and with this number itself if a second small pivot is in the rows of the first.
    /// Entries of the Jacobian are of the order of 1.
    fn growth_squared(&self) -> T;
}

/// A listing: its parts, and its types over any number type.
pub trait Listing<const N: usize>: Parts + Copy {
    /// The geometry.
    type Model<T: Scalar>: Linkage<
            N,
            Scalar = T,
            Fixed = Self::Fixed<T>,
            Drives = Self::Drives<T>,
            Measures = Self::Measures<T>,
            Points = Self::Points<T>,
            Listing = Self,
        > + Copy
        + Send
        + Sync;
    /// Chassis points.
    type Fixed<T: Scalar>: Values<Vector3<T>> + Default + Send + Sync;
    /// Drives.
    type Drives<T: Scalar>: Values<T> + Default + Send + Sync;
    /// Measures.
    type Measures<T: Scalar>: Values<T> + Default + Send + Sync;
    /// Chassis points, free points and markers.
    type Points<T: Scalar>: Values<Vector3<T>> + Default + Send + Sync;

    /// A model in another number type. `number` makes each of its numbers, from one model or from several: it is
    /// given a function that reads the same number of any model. `like` is one of those models.
    fn gather<S: Scalar, T: Scalar>(
        like: &Self::Model<S>,
        number: impl Fn(&dyn Fn(&Self::Model<S>) -> S) -> T,
    ) -> Self::Model<T>;

    /// A model with each of its numbers converted.
    fn converted<S: Scalar, T: Scalar>(
        model: &Self::Model<S>,
        convert: impl Fn(S) -> T,
    ) -> Self::Model<T> {
        Self::gather(model, |read| convert(read(model)))
    }

    /// A model in a number type of fewer digits: each of its constants is computed in `f64` and rounded once. See
    /// [`local`](crate::model::local).
    fn rounded<T: Scalar>(model: &Self::Model<f64>) -> Self::Model<T> {
        Self::converted(model, T::constant)
    }
}

/// A linkage of `N` equations in `N` unknowns `q`: the coordinates of the free points, x, y and z of each, and then
/// those unknowns that are no coordinates, such as a place along a line.
///
/// Implemented by the `Model` that `linkage!` writes, whose methods are straight-line code, and by that of the crate
/// `suspension-runtime`, whose methods walk a list of equations. Neither allocates on the heap, and neither branches on
/// the data. `fixed` are the positions of the chassis points with the driven coordinates inserted
/// ([`drive_anchors`](Self::drive_anchors)); `drives` are coordinates ([`coordinates`](Self::coordinates)).
pub trait Linkage<const N: usize>: Parts {
    /// The number type.
    type Scalar: Scalar;
    /// The listing of which this is a model.
    type Listing: Listing<N>;
    /// Chassis points.
    type Fixed: Values<Vector3<Self::Scalar>> + Default;
    /// Drives.
    type Drives: Values<Self::Scalar> + Default;
    /// Measures: quantities that the listing reads off the points.
    type Measures: Values<Self::Scalar> + Default;
    /// Chassis points, free points and markers.
    type Points: Values<Vector3<Self::Scalar>>;
    /// The factors of the Jacobian, eliminated in the fixed order ([`pivots`](Self::pivots)), over its non-zero entries
    /// alone.
    type Factors: Factors<Self::Scalar, N> + Copy;

    /// The indices of the points that are watched for mirror images: points that only links join to three others,
    /// which links join to each other. These points form a shape as rigid as a body, but one that admits a mirror
    /// image.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn linked(&self) -> impl Iterator<Item = usize> {
        core::iter::empty()
    }

    /// The listing.
    fn listing(&self) -> Self::Listing;

    /// The chassis points at rest.
    fn fixed(&self) -> &Self::Fixed;

    /// The longest length in the linkage, as a measure of its size.
    fn size(&self) -> Self::Scalar;

    /// Converts driving angles into the coordinates that they prescribe.
    fn coordinates(&self, drives: &Signal<Self::Drives>) -> Signal<Self::Drives>;

    /// Inserts the coordinates that drives prescribe into chassis points, or their rates into rates.
    fn put_drives(&self, fixed: &mut Self::Fixed, drives: &Self::Drives);

    /// Chassis points, or their rates, with the coordinates that drives prescribe inserted.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn drive_anchors(&self, mut fixed: Self::Fixed, drives: &Self::Drives) -> Self::Fixed {
        self.put_drives(&mut fixed, drives);
        fixed
    }

    /// `F(q)`, in units of length.
    fn residual(
        &self,
        q: &SVector<Self::Scalar, N>,
        fixed: &Self::Fixed,
        drives: &Self::Drives,
    ) -> SVector<Self::Scalar, N>;

    /// `J = dF/dq`; rows are equations.
    fn jacobian(
        &self,
        q: &SVector<Self::Scalar, N>,
        fixed: &Self::Fixed,
    ) -> SMatrix<Self::Scalar, N, N>;

    /// The fixed order of elimination: equation and unknown of each pivot, from the first to the last.
    fn pivots(&self) -> &[[usize; 2]];

    /// The factors of `J`, computed from its non-zero entries only.
    fn factor(&self, q: &SVector<Self::Scalar, N>, fixed: &Self::Fixed) -> Self::Factors;

    /// `C(v, w)`: the constant second derivative of `F`, applied to two rates of all points, including the chassis
    /// points. Attia 2003, eq. (8) is `C(qdot, qdot)`.
    fn curvature(
        &self,
        v: &SVector<Self::Scalar, N>,
        v_fixed: &Self::Fixed,
        w: &SVector<Self::Scalar, N>,
        w_fixed: &Self::Fixed,
    ) -> SVector<Self::Scalar, N>;

    /// `-dF/du udot` of the drives, including driven chassis points.
    fn drive_rate(
        &self,
        q: &SVector<Self::Scalar, N>,
        fixed: &Self::Fixed,
        fixed_rate: &Self::Fixed,
        drive_rate: &Self::Drives,
    ) -> SVector<Self::Scalar, N>;

    /// `-dF/du udot` of the chassis points that no drive moves.
    fn chassis_rate(
        &self,
        q: &SVector<Self::Scalar, N>,
        fixed: &Self::Fixed,
        fixed_rate: &Self::Fixed,
    ) -> SVector<Self::Scalar, N>;

    /// All points, from the unknowns.
    fn points(&self, q: &SVector<Self::Scalar, N>, fixed: &Self::Fixed) -> Self::Points;

    /// Velocities of all points.
    fn velocities(
        &self,
        at: &Self::Points,
        velocity: &SVector<Self::Scalar, N>,
        fixed_rate: &Self::Fixed,
    ) -> Self::Points;

    /// Accelerations of all points.
    fn accelerations(
        &self,
        at: &Self::Points,
        velocities: &Self::Points,
        acceleration: &SVector<Self::Scalar, N>,
        fixed_second_rate: &Self::Fixed,
    ) -> Self::Points;

    /// Adds the effect of forces at markers to the forces at chassis points and free points: each acts on the three points
    /// that carry the marker. Does nothing if the listing has no markers.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn carry_forces(
        &self,
        _q: &SVector<Self::Scalar, N>,
        _fixed: &Self::Fixed,
        _forces: &mut Self::Points,
    ) {
    }

    /// The unknowns of a set of points. Those that are no coordinates follow from the points.
    fn unknowns(&self, points: &Self::Points) -> SVector<Self::Scalar, N>;

    /// The measures of the listing, from the points and their rates by the chain rule.
    fn measures(&self, points: &Signal<Self::Points>) -> Signal<Self::Measures>
    where
        Self::Scalar: Real;

    /// The ends of the wheel's spin axis, the wheel centre last, taken from positions, velocities or accelerations of
    /// points. `None` if the listing states no `wheel`; if it states several, those of the first ([`Parts::wheel`]).
    fn wheel_axis(&self, points: &Self::Points) -> Option<[Vector3<Self::Scalar>; 2]> {
        Some(points.at(self.wheel(0)?.axis))
    }

    /// Three points of the body that carries the wheel, likewise.
    fn wheel_carrier(&self, points: &Self::Points) -> Option<[Vector3<Self::Scalar>; 3]> {
        Some(points.at(self.wheel(0)?.carrier))
    }

    /// The ends of that wheel's kingpin, the lower one first, likewise; `None` if the listing states none.
    fn kingpin(&self, points: &Self::Points) -> Option<[Vector3<Self::Scalar>; 2]> {
        Some(points.at(self.wheel(0)?.kingpin?))
    }

    /// For each of [`linked`](Self::linked) a number that tells the point from its mirror image: if the lengths are
    /// kept, it is 0 on the side of the three others where the model has the point, and 1 on the other side.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mirrored(
        &self,
        _q: &SVector<Self::Scalar, N>,
        _fixed: &Self::Fixed,
    ) -> impl Iterator<Item = Self::Scalar> {
        core::iter::empty()
    }
}

/// Points that include a wheel: positions, velocities or accelerations.
pub trait HasWheel<T> {
    /// Two points on the spin axis, the wheel centre last.
    fn wheel(&self) -> [Vector3<T>; 2];

    /// Three points of the body that carries the wheel.
    fn carrier(&self) -> [Vector3<T>; 3];
}

/// Points that include a kingpin: positions, velocities or accelerations.
pub trait HasKingpin<T> {
    /// Two points on the kingpin, the lower one first.
    fn kingpin(&self) -> [Vector3<T>; 2];
}
