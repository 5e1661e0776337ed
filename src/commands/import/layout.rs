//! The layouts of the catalogue with the names of their points.

use suspension_core::linkages::LISTINGS;
use suspension_listing::{Kind, text};
use suspension_runtime::{CatalogueAndFiles, Mistakes};

/// A layout of the catalogue.
#[derive(Debug)]
pub(super) struct Layout {
    pub(super) name: &'static str,
    /// Its listing.
    pub(super) text: &'static str,
    /// The names of its points, those on the chassis first.
    pub(super) points: Vec<String>,
    /// How many of them are on the chassis.
    chassis: usize,
}

impl Layout {
    /// Reads the names that all layouts declare.
    ///
    /// # Errors
    ///
    /// The mistakes of a listing.
    pub(super) fn read_all() -> Result<Vec<Self>, Mistakes> {
        let layouts = LISTINGS.iter();
        layouts.map(|(name, text)| Self::read(name, text)).collect()
    }

    fn read(name: &'static str, text: &'static str) -> Result<Self, Mistakes> {
        let declared = text::declared(text, name, &CatalogueAndFiles::beside(name))?;
        let kinds = declared.iter().map(|(_, kind)| *kind);
        let chassis = kinds.filter(|kind| *kind == Kind::CHASSIS_POINT).count();
        let points = declared.into_iter().filter(|(_, kind)| {
            [Kind::CHASSIS_POINT, Kind::FREE_POINT, Kind::MARKER].contains(kind)
        });
        Ok(Self {
            name,
            text,
            points: points.map(|(name, _)| name.to_string()).collect(),
            chassis,
        })
    }

    /// Returns whether it has a point.
    pub(super) fn has(&self, point: &str) -> bool {
        self.points.iter().any(|own| own == point)
    }

    /// Returns whether a point is on the chassis.
    pub(super) fn is_on_chassis(&self, point: &str) -> bool {
        self.points[..self.chassis].iter().any(|own| own == point)
    }
}
