//! Which forms chassis points of one kind move: those that drives move, or the others.

use super::{Body, Coordinate, Distance};

/// The forms that some chassis points are part of.
#[derive(Clone, Debug)]
pub(crate) struct Moving {
    /// Distances from such a point.
    pub(crate) distances: Vec<u16>,
    /// Bodies with such points in their frame, and which.
    pub(crate) bodies: Vec<(u16, [bool; 3])>,
    /// For each coordinate, which of its points.
    pub(crate) coordinates: Vec<[bool; 2]>,
}

impl Moving {
    pub(crate) fn new(
        distances: &[Distance],
        bodies: &[Body],
        coordinates: &[Coordinate],
        moves: impl Fn(u16) -> bool,
    ) -> Self {
        let of_distances = (0..).zip(distances).filter(|(_, distance)| moves(distance.from));
        let of_bodies = (0..).zip(bodies).filter_map(|(index, body)| {
            let moved = body.frame.map(&moves);
            moved.contains(&true).then_some((index, moved))
        });
        Self {
            distances: of_distances.map(|(index, _)| index).collect(),
            bodies: of_bodies.collect(),
            coordinates: coordinates.iter().map(|coordinate| coordinate.moves(&moves)).collect(),
        }
    }
}
