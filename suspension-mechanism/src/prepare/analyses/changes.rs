//! The changes of a design whose effects can be computed.

use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::prepare::loaded::Loaded;
use crate::sensitivities::{self, Change, coordinates};
use crate::tune::Move;

impl Loaded<'_> {
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
}
