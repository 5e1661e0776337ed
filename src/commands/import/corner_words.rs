//! How the words of a file that name a corner are read: as a part of names, or not.

use super::Arguments;
use super::hardpoints::{Hardpoint, Hardpoints};
use super::layout_choice::lacking;
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
        // Whichever corner the points are of.
        let lacking = |reading: &Hardpoints<'_>| {
            let points: Vec<&Hardpoint> = reading.points.iter().collect();
            lacking(&points, names, self.linkage.as_deref())
        };
        let nearest = || (0..readings.len()).min_by_key(|&it| lacking(&readings[it]));
        let best = readings.iter().position(is_suspension).or_else(nearest);
        readings
            .swap_remove(best.unwrap_or_default())
            .of_end(self.end)
    }
}
