//! How the words of a file that name a corner are read: as a part of names, or not.

use std::cmp::Reverse;

use super::Arguments;
use super::choice::candidates;
use super::hardpoints::{Hardpoint, Hardpoints};
use super::names::Names;
use crate::failure::Failure;

impl Arguments {
    /// Returns the points of the wanted axle, in the first reading that is a suspension, or else in the one that lacks the fewest
    /// points of a layout.
    pub(super) fn of_axle<'a>(
        &self,
        stated: Hardpoints<'a>,
        names: &Names,
    ) -> Result<Hardpoints<'a>, Failure> {
        let apart = stated.with_corners_apart(names);
        let of_both_sides = stated.with_sides_in_names(names);
        let readings = [stated, apart, of_both_sides].map(|reading| {
            let lacking = self.lacking(&reading, names);
            let reading = reading.of_end(self.end);
            let corner = reading
                .as_ref()
                .map(|reading| self.corner(reading, names, self.first_side()));
            let is_suspension = matches!(corner, Ok(Ok(_)));
            ((!is_suspension, lacking), reading)
        });
        let [mut best, others @ ..] = readings;
        for other in others {
            if other.0 < best.0 {
                best = other;
            }
        }
        best.1
    }

    /// Returns how much the nearest layout lacks in a reading, of which corner ever its points are: first whether it has none of
    /// its points, then how many are missing, then how many there are.
    fn lacking(
        &self,
        reading: &Hardpoints<'_>,
        names: &Names,
    ) -> Option<(bool, usize, Reverse<usize>)> {
        let points: Vec<&Hardpoint> = reading.points.iter().collect();
        let candidates = candidates(&points, names, self.linkage.as_deref());
        candidates.first().map(|nearest| {
            let found = nearest.found.len();
            (found == 0, nearest.needed().len(), Reverse(found))
        })
    }
}
