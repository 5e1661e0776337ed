//! How the words of a file that name a corner are read: as a part of names, or not.

use std::cmp::Reverse;

use super::Arguments;
use super::hardpoints::{Hardpoint, Hardpoints};
use super::layout_choice::lacking;
use super::names::Names;
use crate::failure::Failure;

impl Arguments {
    /// Returns the points of the wanted axle, in the first reading that is a suspension, or else in the one that lacks the fewest
    /// points of a layout. A reading counts only if its layout uses no fewer points than those of the readings before it.
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
        // Whichever corner the points are of.
        let lacking = readings.iter().map(|reading| {
            let points: Vec<&Hardpoint> = reading.points.iter().collect();
            lacking(&points, names, self.linkage.as_deref())
        });
        let lacking: Vec<_> = lacking.collect();
        let used = |it: usize| lacking[it].map_or(0, |(_, _, Reverse(found))| found);
        let uses_most = |it: &usize| (0..*it).all(|before| used(before) <= used(*it));
        let most = || (0..readings.len()).filter(uses_most);
        let suspension = most().find(|&it| is_suspension(&readings[it]));
        let nearest = || most().min_by_key(|&it| lacking[it]);
        let best = suspension.or_else(nearest);
        readings
            .swap_remove(best.unwrap_or_default())
            .of_end(self.end)
    }
}
