//! Locks so near to the design position that any suspension's travel passes them.

use crate::kinematics::Kinematics;
use crate::mechanism::{describe_change_from_design, extent};
use crate::reach::{DriveRange, Limit, RangeEnd};

/// Locks within this distance are noted: a part of the suspension's size, or an angle in radians.
const NEAR: f64 = 1e-3;

/// Returns a note for each lock that is near the design position.
pub(super) fn notes(
    mechanism: &dyn Kinematics,
    ranges: &[DriveRange],
) -> impl Iterator<Item = String> {
    let (unit, size) = (mechanism.unit, extent(mechanism.points()).norm());
    let ends = ranges
        .iter()
        .flat_map(|range| range.ends.iter().map(move |end| (range, end)));
    let near = ends.filter(move |(range, end)| {
        let part = if range.kind.is_angle() { 1.0 } else { size };
        is_lock(end) && (end.value - range.start).abs() < NEAR * part
    });
    near.map(move |(range, end)| {
        let change = describe_change_from_design(end.value - range.start, range.kind, unit);
        format!(
            "`{}` reaches a lock {change}, which tolerances of hardpoints alone may use up; move hardpoints so that it is further away",
            range.name
        )
    })
}

/// Returns whether the range ends at a lock. The end of an angle is none: a design may well stand there.
fn is_lock(end: &RangeEnd) -> bool {
    matches!(
        end.limit,
        Limit::Locks { .. } | Limit::ZeroLength(_) | Limit::Bifurcation(_)
    )
}
