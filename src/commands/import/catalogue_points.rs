//! The points of the catalogue's listings.

use suspension_listing::text;
use suspension_runtime::{CatalogueAndFiles, Mistakes};

/// Returns the names of a listing's points without the search for an order of elimination.
pub(super) fn points_of(linkage: &str, text: &str) -> Result<Vec<String>, Mistakes> {
    let system = text::parse(text, linkage, &CatalogueAndFiles::beside(linkage))?;
    let points = system.fixed.iter().chain(&system.free);
    let points = points.map(|point| &point.named.name);
    let markers = system.markers.iter().map(|marker| &marker.named.name);
    Ok(points.chain(markers).map(ToString::to_string).collect())
}
