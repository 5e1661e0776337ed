//! Tuning as a motion file states it, with its names replaced by indices.

mod moves;
mod named_parts;
mod one_sided_moves;
mod target_values;
mod targets;

use std::ops::Range;

use crate::failure::Failure;
use crate::file::TuneTable;
use crate::kinematics::Kinematics;
use crate::prepare::loaded::Loaded;
use crate::prepare::notes;
use crate::tune::{Move, Target};
use moves::Moves;
use named_parts::Naming;

/// The usual widths of the boxes of moves, in metres.
const BOX: Range<f64> = 5e-4..1.0;

impl Loaded<'_> {
    /// The moves and targets in the file for `suspension tune`, in its order.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the first name that is not in the mechanism, at a missing entry, at a box without room, and
    /// at a mirrored point of the same side.
    pub fn tuning(&self, mechanism: &dyn Kinematics) -> Result<(Vec<Move>, Vec<Target>), Failure> {
        let source = self.source;
        let Some(table) = &self.file.tune else {
            let message = "nothing to tune: write [tune.moves.NAME] and [tune.targets.NAME], see suspension tune --help";
            return Err(source.refuse(&(0..0), message));
        };
        let naming = Naming { source, mechanism };
        let of_moves = Moves {
            naming,
            followers: self.file.followers(&mechanism.names.points),
            across: mechanism.points().iter().map(|at| at.y).collect(),
        };
        let TuneTable { moves, targets } = table.get_ref();
        let moves = moves
            .get_ref()
            .iter()
            .map(|(name, each)| of_moves.read_move(name, each));
        let targets = targets
            .get_ref()
            .iter()
            .map(|(name, each)| naming.read_target(name, each));
        let (moves, targets) = Failure::both(Failure::all(moves), Failure::all(targets))?;
        match (moves.is_empty(), targets.is_empty()) {
            (false, false) => Ok((moves, targets)),
            (true, _) => Err(source.refuse(&table.span(), "no moves: write [tune.moves.NAME]")),
            (_, true) => Err(source.refuse(&table.span(), "no targets: write [tune.targets.NAME]")),
        }
    }

    /// Notes on boxes of moves that seem to be in another unit.
    pub fn doubtful_boxes(&self, moves: &[Move]) -> Vec<String> {
        let name = self.source.name();
        let boxes = moves.iter().filter_map(|each| {
            let [least, greatest] = each.by;
            let what = format!("the width of the box of [tune.moves.{}]", each.name);
            notes::length(self.file.length, &what, greatest - least, BOX)
        });
        boxes.map(|note| format!("{name}: {note}")).collect()
    }
}
