//! Notes on points of a listing that a file does not state.

mod moved_points;
mod unmirrored;
mod unstated;

use suspension_runtime::Listing;

use crate::file::{MotionFile, Source};
use crate::mechanism::Axes;
use moved_points::Points;

/// The notes of a file and its listing, with the name of the listing in them and the axes of its coordinates.
pub(in crate::prepare) fn notes(
    (listing, called): (&Listing, &str),
    source: &Source,
    file: &MotionFile,
    axes: Axes,
) -> Vec<String> {
    let points = Points::new(listing, file, axes);
    let kept = unstated::kept(listing, file, &points);
    let unstated = unstated::note(&kept, &points, (listing, called), file);
    let notes = [unstated, unmirrored::note(&points, &kept)]
        .into_iter()
        .flatten();
    notes
        .map(|note| format!("{}: {note}", source.name()))
        .collect()
}
