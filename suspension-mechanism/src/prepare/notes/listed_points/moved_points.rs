//! The positions of the listing's points in a file, and the points that the file moves.

use nalgebra::Vector3;
use suspension_runtime::Listing;

use crate::file::{MotionFile, Offset, Position};
use crate::mechanism::Axes;
use crate::prepare::listing::points::point_names;

/// The distance, in metres, below which points are in the same place.
const SAME: f64 = 1e-6;

/// The points of a listing, in its order.
pub(super) struct Points<'a> {
    pub(super) names: Vec<&'a str>,
    /// Their positions in the listing.
    pub(super) listed: Vec<Option<Vector3<f64>>>,
    /// The positions of points that the file moves; `None` for the same position.
    pub(super) moved: Vec<Option<Vector3<f64>>>,
    /// The positions of points that the file does not state.
    pub(super) unstated: Vec<Option<Vector3<f64>>>,
    /// Whether `[tune]` moves each point.
    tuned: Vec<bool>,
    /// The distance below which points are in the same place, in the unit of the file.
    same: f64,
}

impl<'a> Points<'a> {
    /// `axes` are those of the listing.
    pub(super) fn new(listing: &'a Listing, file: &MotionFile, axes: Axes) -> Self {
        let names: Vec<&str> = point_names(listing).collect();
        let mut listed = vec![None; names.len()];
        for (point, at) in listing.stated() {
            listed[point] = Some(axes.turned(at));
        }
        let stated = file.points.get_ref();
        let place = |name: &str| {
            let listed = listing.point(name).and_then(|point| listed[point]);
            match stated.get(name).map(toml::Spanned::get_ref) {
                Some(Position::At(at)) => Some(Vector3::from(*at)),
                _ => listed,
            }
        };
        let same = SAME * file.length.metre();
        let each = names.iter().zip(&listed);
        let moved = each.clone().map(|(name, listed)| {
            let at = match stated.get(name)?.get_ref() {
                Position::At(at) => Vector3::from(*at),
                Position::Off(Offset { from, offset }) => {
                    place(from.get_ref())? + Vector3::from(*offset.get_ref())
                }
            };
            ((at - (*listed)?).norm() > same).then_some(at)
        });
        let unstated = each.map(|(name, listed)| listed.filter(|_| !stated.has(name)));
        Self {
            moved: moved.collect(),
            unstated: unstated.collect(),
            tuned: names.iter().map(|name| is_tuned(file, name)).collect(),
            same,
            names,
            listed,
        }
    }

    /// The displacement by the file of a point that `[tune]` does not move.
    pub(super) fn moved_by_hand(&self, point: usize) -> Option<f64> {
        let off = (self.moved[point]? - self.listed[point]?).norm();
        (!self.tuned[point]).then_some(off)
    }

    /// Whether two positions are the same.
    pub(super) fn are_same(&self, [a, b]: [Vector3<f64>; 2]) -> bool {
        (a - b).norm() <= self.same
    }
}

fn is_tuned(file: &MotionFile, name: &str) -> bool {
    let moves = file.tune.iter();
    let moves = moves.flat_map(|tune| tune.get_ref().moves.get_ref().values());
    let mut points =
        moves.flat_map(|each| each.get_ref().points.iter().chain(&each.get_ref().mirrored));
    points.any(|point| point.get_ref() == name)
}
