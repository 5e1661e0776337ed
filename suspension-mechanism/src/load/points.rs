//! The points of a listing, by name.

use suspension_core::listing::{Kind, Part, Parts};
use suspension_runtime::Listing;

/// The points' names, in the order of the listing.
pub fn points(listing: &Listing) -> impl Iterator<Item = &str> {
    let kinds = [Kind::ChassisPoint, Kind::FreePoint, Kind::Marker];
    let count: usize = kinds.into_iter().map(|kind| listing.count(kind)).sum();
    (0..count).map(|point| listing.name(Part::Point(point)))
}
