//! Statements of a motion file for single analyses: load cases, sensitivities, tolerances, tuning.

pub(super) mod combined_changes;
mod load_cases;
mod tolerances;
mod tuning;

use std::ops::Range;

use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::loads::Case;
use crate::mechanism::Description;
use crate::prepare::analyses::load_cases::cases;
use crate::prepare::analyses::tolerances::tolerances;
use crate::prepare::analyses::tuning::{one_sided_moves, tuning};
use crate::prepare::loaded::Loaded;
use crate::prepare::notes::length;
use crate::sensitivities::{self, Change, coordinates};
use crate::tolerances::Tolerance;
use crate::tune::{Move, Target};

/// The usual widths of the boxes of moves, in metres.
const BOX: Range<f64> = 5e-4..1.0;

/// The usual standard deviations of hardpoints, in metres.
const TOLERANCE: Range<f64> = 1e-6..0.02;

impl Loaded<'_> {
    /// The load cases of the file, in its order.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at an entry that is not a load of the mechanism.
    pub fn load_cases(&self, mechanism: &Description) -> Result<Vec<Case>, Failure> {
        cases(self.source, &self.file, self.listing(), mechanism)
    }

    /// The tolerances of the file's points and links.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at an entry that is not a tolerance, or not of a part of the mechanism.
    pub fn tolerances(&self, mechanism: &Description) -> Result<Vec<Tolerance>, Failure> {
        tolerances(self.source, &self.file, mechanism)
    }

    /// A note on the first tolerance that seems to be in another unit.
    pub fn doubtful_tolerance(&self) -> Option<String> {
        let stated = self.file.tolerances.as_ref()?.get_ref();
        let note = stated.iter().find_map(|(name, deviation)| {
            let what = format!("the tolerance of `{}`", name.get_ref());
            let deviation = *deviation.get_ref();
            let stated = (deviation > 0.0).then_some(deviation)?;
            length(self.file.length, &what, stated, TOLERANCE)
        })?;
        Some(format!("{}: {note}", self.source.name()))
    }

    /// The changes of `suspension sensitivities`: the coordinates of all points, the lengths of links, and the moves
    /// of `[tune]`.
    ///
    /// # Errors
    ///
    /// As [`tuning`](Self::tuning).
    pub fn changes(&self, mechanism: &dyn Kinematics) -> Result<Vec<Change>, Failure> {
        let names = &mechanism.names;
        let followers = self.file.followers(&names.points);
        let points = 0..names.points.len();
        let coordinates = points.flat_map(|point| coordinates(mechanism, point, &followers));
        let lengths = names
            .links
            .iter()
            .map(|link| sensitivities::length(mechanism, *link));
        let mut changes: Vec<Change> = coordinates.chain(lengths).collect();
        if self.file.tune.is_some() {
            let (moves, _) = self.tuning(mechanism)?;
            let named = moves.into_iter();
            changes.extend(named.map(|Move { name, per_unit, .. }| Change { name, per_unit }));
        }
        Ok(changes)
    }

    /// The moves and targets in the file for `suspension tune`, in its order.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at a name that is not in the mechanism, and if nothing is stated.
    pub fn tuning(&self, mechanism: &dyn Kinematics) -> Result<(Vec<Move>, Vec<Target>), Failure> {
        tuning(self.source, &self.file, mechanism)
    }

    /// Notes on moves of one side of the vehicle only.
    pub fn one_sided_moves(&self, mechanism: &Description) -> Vec<String> {
        let name = self.source.name();
        let notes = self.file.tune.iter();
        let notes =
            notes.flat_map(|table| one_sided_moves::notes(table.get_ref(), &mechanism.names));
        notes.map(|note| format!("{name}: {note}")).collect()
    }

    /// Notes on boxes of moves that seem to be in another unit.
    pub fn doubtful_boxes(&self, moves: &[Move]) -> Vec<String> {
        let name = self.source.name();
        let boxes = moves.iter().filter_map(|each| {
            let [least, greatest] = each.by;
            let what = format!("the width of the box of [tune.moves.{}]", each.name);
            length(self.file.length, &what, greatest - least, BOX)
        });
        boxes.map(|note| format!("{name}: {note}")).collect()
    }
}
