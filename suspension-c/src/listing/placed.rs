//! A suspension together with the listing that it borrows.

use std::boxed::Box;
use std::sync::Arc;

use suspension_core::nalgebra::Vector3;
use suspension_runtime::{Fitted, ModelError, Room, Size, Work};

use super::moving::{Counted, Moving};
use super::parsed::Parsed;
use crate::failure::Trouble;
use crate::status::Status;

/// A listing with hardpoints, in motion.
pub struct Placed {
    // Dropped before `parsed`, from which it borrows.
    moving: Box<dyn Moving>,
    parsed: Arc<Parsed>,
}

impl Placed {
    /// Makes the suspension at rest at the points.
    #[allow(unsafe_code, reason = "no type says: as long as the field beside it")]
    pub(super) fn new(parsed: &Parsed, points: &[Vector3<f64>]) -> Result<Self, Trouble> {
        let parsed = Arc::new(parsed.ordered_at(points));
        let borrowing = parsed.listing.in_its_size(Place {
            parsed: &parsed,
            points,
        })?;
        // SAFETY: the types differ only in the lifetime of the borrow. It borrows the content of an `Arc`,
        // which neither moves nor changes, and which this object keeps longer than `moving` and its copies;
        // nobody else has access to these. The methods of `Moving` return nothing that borrows.
        let moving = unsafe {
            core::mem::transmute::<Box<dyn Moving + '_>, Box<dyn Moving + 'static>>(borrowing)
        };
        Ok(Self { moving, parsed })
    }

    /// Returns a copy, which shares the listing.
    pub(super) fn copied(&self) -> Self {
        Self {
            moving: self.moving.copied(),
            parsed: Arc::clone(&self.parsed),
        }
    }

    /// Returns the suspension, to move it, and its listing.
    pub(super) fn parts_mut(&mut self) -> (&mut dyn Moving, &Parsed) {
        (&mut *self.moving, &self.parsed)
    }

    /// Returns the suspension and its listing.
    pub(super) fn parts(&self) -> (&dyn Moving, &Parsed) {
        (&*self.moving, &self.parsed)
    }

    pub(super) fn moving(&self) -> &dyn Moving {
        &*self.moving
    }

    pub(super) fn parsed(&self) -> &Parsed {
        &self.parsed
    }
}

/// The work that makes a suspension from a listing.
struct Place<'a> {
    parsed: &'a Parsed,
    points: &'a [Vector3<f64>],
}

impl<'a> Work for Place<'a> {
    type Answer = Result<Box<dyn Moving + 'a>, Trouble>;

    fn on<const N: usize>(self, _: Fitted<'_, N>) -> Self::Answer
    where
        Room<N>: Size,
    {
        let Self { parsed, points } = self;
        match parsed.listing.corner::<N>(points) {
            Ok(corner) => Ok(Box::new(Counted {
                corner,
                counts: parsed.counts(),
            })),
            Err(ModelError::Geometry { error, .. }) => Err(error.into()),
            Err(ModelError::TooSmall { .. } | ModelError::Hardpoints { .. }) => {
                Err(Status::Size.into())
            }
        }
    }
}
