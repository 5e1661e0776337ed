//! The points of a mechanism, as equations name them.

use crate::name::Name;

/// A point of the mechanism and how it moves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Site {
    pub name: Name,
    /// Its index among the chassis points, or among the free points.
    pub index: usize,
    pub motion: SiteMotion,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SiteMotion {
    Free,
    /// A point on the chassis.
    Anchor,
    /// A point on the chassis with a coordinate that a drive prescribes.
    DrivenAnchor,
}

impl Site {
    pub fn is_free(&self) -> bool {
        self.motion == SiteMotion::Free
    }

    /// The column of its first coordinate, if it is free.
    pub fn first_column(&self) -> Option<usize> {
        self.is_free().then_some(3 * self.index)
    }
}
