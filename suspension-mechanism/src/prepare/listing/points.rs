//! The points of a listing, by name.

use nalgebra::Vector3;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_runtime::Listing;
use toml::Spanned;

use crate::file::{Offset, Position, Table};

/// The points' names, in the order of the listing.
pub fn point_names(listing: &Listing) -> impl Iterator<Item = &str> {
    let count: usize = Kind::POINTS.map(|kind| listing.count(kind)).iter().sum();
    (0..count).map(|point| listing.name(Part::Point(point)))
}

/// The coordinates that a file states for a point, also by an offset from another one; NaN where it states none.
pub(crate) fn stated_at(points: &Table<Position>, name: &str) -> Vector3<f64> {
    let stated = |name: &str| points.get_ref().get(name).map(Spanned::get_ref);
    let coordinates = |position: Option<&Position>| match position {
        Some(Position::At(at)) => Vector3::from(*at),
        _ => Vector3::repeat(f64::NAN),
    };
    match stated(name) {
        Some(Position::Off(Offset { from, offset })) => {
            coordinates(stated(from.get_ref())) + Vector3::from(*offset.get_ref())
        }
        position => coordinates(position),
    }
}
