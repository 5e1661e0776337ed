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
        let mut readings = vec![stated, apart, of_both_sides];
        let is_suspension = |reading: &Hardpoints<'_>| {
            let reading = reading.clone().of_end(self.end);
            let corner = |reading| self.corner(reading, names, self.first_side());
            matches!(reading.as_ref().map(corner), Ok(Ok(_)))
        };
        let nearest = || (0..readings.len()).min_by_key(|&it| self.lacking(&readings[it], names));
        let best = readings.iter().position(is_suspension).or_else(nearest);
        readings
            .swap_remove(best.unwrap_or_default())
            .of_end(self.end)
    }

    /// Returns how much the nearest layout lacks in a reading, whichever corner the points are of: first whether none of its points
    /// is there, then how many are missing, then how many there are.
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
