//! From hardpoints to a model, and to a moving suspension.

use core::fmt;

use nalgebra::Vector3;
use suspension_core::listing::{Kind, Parts};
use suspension_core::solve::pivots::check_regular;
use suspension_core::{Build, Corner, GeometryError, Values};

use crate::listing::Listing;
use crate::model::Model;
use crate::size::{LARGEST, Points, Room, Size};

/// Why there is no model of a listing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ModelError {
    /// Models of this size have no room for the listing: it has `count` of one kind of part, of which there may be at
    /// most `most`.
    TooSmall {
        /// The number that the listing has.
        count: usize,
        /// The number that there is room for.
        most: usize,
        /// The kind of part.
        what: &'static str,
    },
    /// There are more or fewer hardpoints than points in the listing.
    Hardpoints {
        /// The number given.
        given: usize,
        /// The number required.
        wanted: usize,
    },
    /// The hardpoints make no linkage.
    Geometry {
        /// The mistake, with the numbers of the parts concerned.
        error: GeometryError,
        /// The mistake in words, with their names.
        message: String,
    },
}

impl Listing {
    /// The listing with the order of elimination chosen by the positions around these hardpoints, one for each point.
    /// A listing that states its design itself is returned unchanged if its order suits them.
    #[must_use]
    pub fn ordered_at(self, hardpoints: &[Vector3<f64>]) -> Self {
        let (fixed, free) = (self.system().fixed.len(), self.system().free.len());
        let places: Vec<[f64; 3]> = hardpoints.iter().map(|point| (*point).into()).collect();
        let (Some(fixed), Some(free)) = (places.get(..fixed), places.get(fixed..fixed + free))
        else {
            return self;
        };
        if self.system().design().is_some() && self.suits(hardpoints) {
            return self;
        }
        let design = self.system().positions(fixed.to_vec(), free.to_vec());
        let order = suspension_listing::order_at(self.system(), design);
        self.with_order(&order)
    }

    /// Whether the order of elimination suits hardpoints, if these are a valid geometry.
    fn suits(&self, hardpoints: &[Vector3<f64>]) -> bool {
        let model = self.built::<LARGEST>(hardpoints);
        let small = |error| {
            matches!(
                error,
                ModelError::Geometry {
                    error: GeometryError::SmallPivot { .. },
                    ..
                }
            )
        };
        !model.is_err_and(small)
    }

    /// A model with these hardpoints: chassis points, free points and markers in the order of the listing.
    ///
    /// # Errors
    ///
    /// [`ModelError`]. With [`GeometryError::SmallPivot`] the order of elimination does not suit the hardpoints:
    /// [`ordered_at`](Self::ordered_at) gives one that does, and [`Build::of`] builds the model nevertheless.
    pub fn model<const N: usize>(
        &self,
        hardpoints: &[Vector3<f64>],
    ) -> Result<Model<'_, f64, N>, ModelError>
    where
        Room<N>: Size,
    {
        let wanted = Kind::POINTS.map(|kind| self.count(kind)).iter().sum();
        if hardpoints.len() == wanted {
            self.built(hardpoints)
        } else {
            let given = hardpoints.len();
            Err(ModelError::Hardpoints { given, wanted })
        }
    }

    /// A model with these hardpoints, whose number is not checked: missing ones are at the origin.
    fn built<const N: usize>(
        &self,
        hardpoints: &[Vector3<f64>],
    ) -> Result<Model<'_, f64, N>, ModelError>
    where
        Room<N>: Size,
    {
        let Some(listing) = self.fitted() else {
            let exceeded = self.plan().exceeded::<N>();
            let (count, most, what) = exceeded.map_or((self.size(), N, "unknowns"), |exceeded| {
                (exceeded.count, exceeded.most, exceeded.what)
            });
            return Err(ModelError::TooSmall { count, most, what });
        };
        let points = Points::<Vector3<f64>, N>::from_values(hardpoints.iter().copied());
        let model = Model::of(listing, &points).map_err(|error| self.refused(error))?;
        let checked = model.check_pivots(&points);
        checked.map_err(|error| self.refused(error))?;
        Ok(model)
    }

    fn refused(&self, error: GeometryError) -> ModelError {
        ModelError::Geometry {
            error,
            message: error.named(self).to_string(),
        }
    }

    /// A suspension at rest with these hardpoints, ready to be moved. It borrows the listing, and so do its failures,
    /// which print the listing's names: convert a failure to text if it leaves the function that has the listing.
    ///
    /// Other hardpoints make another corner, also while a program runs: neither this call nor a step allocates, except for
    /// the message where hardpoints are refused. The time of the new corner is zero, and it steps to the present drives:
    ///
    /// ```
    /// use suspension_runtime::{Listing, catalogue};
    ///
    /// let listing = Listing::parse(catalogue::listing("double_wishbone").unwrap())?;
    /// let mut hardpoints = listing.design().unwrap();
    /// let mut corner = listing.corner::<15>(&hardpoints)?;
    ///
    /// hardpoints[listing.point("rack").unwrap()].z += 0.005;
    /// let mut changed = listing.corner(&hardpoints)?;
    /// changed.step(1e-3, corner.drive_signal()).map_err(|failure| failure.to_string())?;
    /// corner = changed; // where hardpoints or the step are refused, the old one goes on
    /// let toe = corner.wheel().map_or(0.0, |wheel| wheel.toe.to_degrees());
    /// assert!(toe.abs() < 1e-9); // as the hardpoints are drawn
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ModelError`]. With [`GeometryError::Singular`] the mechanism locks at the hardpoints or a drive has no effect:
    /// there may be a [`model`](Self::model), but no drive leads from there.
    pub fn corner<const N: usize>(
        &self,
        hardpoints: &[Vector3<f64>],
    ) -> Result<Corner<Model<'_, f64, N>, N>, ModelError>
    where
        Room<N>: Size,
    {
        let points = Points::from_values(hardpoints.iter().copied());
        let model = self.model(hardpoints)?;
        check_regular(&model, &points).map_err(|error| self.refused(error))?;
        Ok(Corner::of(model, &points))
    }
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooSmall { count, most, what } => write!(
                f,
                "the listing has {count} {what}, and a model of this size has room for {most}; take a larger size"
            ),
            Self::Hardpoints { given, wanted } => write!(
                f,
                "the listing has {wanted} chassis points, free points and markers, and {given} hardpoints are given; give one for \
                 each, in the order of the listing"
            ),
            Self::Geometry { message, .. } => f.write_str(message),
        }
    }
}

impl core::error::Error for ModelError {}
