//! The layouts of the catalogue with the names of their points.

use suspension_core::linkages::LISTINGS;
use suspension_listing::text;
use suspension_runtime::{CatalogueAndFiles, Mistakes};

/// A layout of the catalogue.
#[derive(Debug)]
pub(super) struct Layout {
    pub(super) name: &'static str,
    /// Its listing.
    pub(super) text: &'static str,
    /// The names of its points.
    pub(super) points: Vec<String>,
}

impl Layout {
    /// Reads all layouts, without the search for an order of elimination.
    ///
    /// # Errors
    ///
    /// The mistakes of a listing.
    pub(super) fn read_all() -> Result<Vec<Self>, Mistakes> {
        let layouts = LISTINGS.iter();
        layouts.map(|(name, text)| Self::read(name, text)).collect()
    }

    fn read(name: &'static str, text: &'static str) -> Result<Self, Mistakes> {
        let system = text::parse(text, name, &CatalogueAndFiles::beside(name))?;
        let points = system.fixed.iter().chain(&system.free);
        let points = points.map(|point| &point.named.name);
        let markers = system.markers.iter().map(|marker| &marker.named.name);
        let points = points.chain(markers).map(ToString::to_string).collect();
        Ok(Self { name, text, points })
    }
}
