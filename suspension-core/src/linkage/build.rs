//! Building a linkage from positions of points, or from lengths.

use nalgebra::SVector;

use super::{Linkage, Values};
use crate::error::GeometryError;

/// A linkage that can be built from the positions or the lengths of its parts.
pub trait Build<const N: usize>: Linkage<N> + Sized {
    /// The lengths of links and bodies.
    type Lengths: Values<Self::Scalar>;

    /// Builds the linkage of a listing with the lengths that the points give, whether or not the fixed order of
    /// elimination suits them: see [`check_pivots`](Self::check_pivots).
    ///
    /// # Errors
    ///
    /// If a coordinate is not finite, a length is zero, a body's first three points are collinear, or one of
    /// [`linked`](Linkage::linked) lies in the plane of the points that hold it.
    fn of(listing: Self::Listing, design: &Self::Points) -> Result<Self, GeometryError>;

    /// As [`of`](Self::of), for a listing that `linkage!` has written; checks that the fixed order of elimination
    /// suits the points.
    ///
    /// # Errors
    ///
    /// As [`of`](Self::of), and [`check_pivots`](Self::check_pivots).
    fn new(design: &Self::Points) -> Result<Self, GeometryError>
    where
        Self::Listing: Default,
    {
        let linkage = Self::of(Self::Listing::default(), design)?;
        linkage.check_pivots(design)?;
        Ok(linkage)
    }

    /// Checks that the fixed order of elimination suits a position, usually the design. If it does not, a [bounded
    /// attempt](crate::Bounded::attempt) is refused. Everything else that solves for a motion then goes on with
    /// partial pivoting, which takes longer, so that a linkage built with [`of`](Self::of) can still be used.
    ///
    /// # Errors
    ///
    /// [`GeometryError::SmallPivot`] if the [pivots](super::Factors::growth_squared) of the fixed order are too small
    /// and those of partial pivoting are not. Near a singularity of the mechanism both are too small, and there is no
    /// error.
    fn check_pivots(&self, points: &Self::Points) -> Result<(), GeometryError>;

    /// The same linkage with other lengths. Each body keeps its handedness, and so does each cluster of links that is
    /// as rigid as a body.
    ///
    /// A tie rod that becomes half a millimetre longer while the corner moves:
    ///
    /// ```
    /// use suspension_core::linkages::double_wishbone::{Corner, Lengths};
    /// use suspension_core::{Build, Signal};
    ///
    /// let mut corner: Corner = Corner::design()?;
    /// corner.step(1e-3, Signal::still(corner.drives()))?;
    /// let lengths = corner.model().lengths();
    /// let longer = Lengths { tie_rod: lengths.tie_rod + 0.0005, ..lengths };
    /// let model = corner.model().with_lengths(&longer)?;
    /// let found: Corner = Corner::assembled(model, &corner.points().value)?; // at the present drives, at rest and time 0
    /// corner = Corner::resumed(model, *found.motion(), corner.drive_signal(), corner.time());
    /// corner.step(1e-3, Signal::still(corner.drives()))?;
    /// let toe = corner.wheel().map_or(0.0, |wheel| wheel.toe.to_degrees());
    /// assert_eq!(format!("{toe:.3} deg after {:.3} s", corner.time()), "-0.241 deg after 0.002 s");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// If a length is not positive and finite, or no rigid body has the lengths.
    fn with_lengths(self, lengths: &Self::Lengths) -> Result<Self, GeometryError>;

    /// The same linkage with its markers attached as they stand in `points`.
    ///
    /// # Errors
    ///
    /// If a coordinate is not finite or a carrier's points are collinear.
    fn with_markers(self, points: &Self::Points) -> Result<Self, GeometryError>;

    /// The lengths.
    fn lengths(&self) -> Self::Lengths;

    /// The drives' values in a configuration.
    fn drives_at(&self, points: &Self::Points) -> Self::Drives;

    /// The guess `q` with each body, and each cluster of links that is as rigid as a body, replaced by the rigid body
    /// that fits it best.
    fn fit(&self, q: &SVector<Self::Scalar, N>, fixed: &Self::Fixed) -> SVector<Self::Scalar, N>;
}

/// A linkage whose listing states where every point is in the design (`at [x, y, z]`).
///
/// ```
/// use suspension_core::linkage::Designed;
/// use suspension_core::linkages::double_wishbone::{Model, Points};
///
/// let points: Points = Model::<f64>::design();
/// assert_eq!(points.wheel_centre.z, 0.3);
/// ```
#[diagnostic::on_unimplemented(
    message = "the listing does not state where each of its points is in the design",
    label = "needs `at [x, y, z]` behind every chassis point, free point and marker",
    note = "state the missing positions, or start from the program's own: `Corner::new(&Points {{ ... }})`"
)]
pub trait Designed<const N: usize>: Build<N> {
    /// The design positions of the points.
    fn design() -> Self::Points;
}
