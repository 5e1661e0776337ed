//! Locks that are nearer to the design than the travel of any suspension.

use suspension_core::listing::DriveKind;

use crate::file::Dimension;
use crate::kinematics::Kinematics;
use crate::mechanism::{DriveAtDesign, from_design};
use crate::reach::{DriveRange, Limit, RangeEnd};

/// How near is noted: as a part of the suspension's size, or as an angle in radians.
const NEAR: f64 = 1e-3;

/// A note on each lock that is so near.
pub(super) fn notes(
    mechanism: &dyn Kinematics,
    ranges: &[DriveRange],
) -> impl Iterator<Item = String> {
    let (unit, size) = (mechanism.unit, DriveAtDesign::extent(mechanism.points()));
    let ends = ranges
        .iter()
        .flat_map(|range| range.ends.iter().map(move |end| (range, end)));
    let near = ends.filter(move |(range, end)| {
        let part = match range.kind {
            DriveKind::Coordinate => size,
            DriveKind::Angle | DriveKind::Turn => 1.0,
        };
        is_lock(end) && (end.value - range.start).abs() < NEAR * part
    });
    near.map(move |(range, end)| {
        let dimension = Dimension::from(range.kind);
        let change = (end.value - range.start) * dimension.in_file(unit);
        let change = from_design(change, &dimension.symbol(unit));
        format!(
            "`{}` reaches a lock {change}, which tolerances of hardpoints alone may use up; move hardpoints so that it is further away",
            range.name
        )
    })
}

/// Not the end of an angle, at which a design may well stand.
fn is_lock(end: &RangeEnd) -> bool {
    matches!(
        end.limit,
        Limit::Locks { .. } | Limit::ZeroLength(_) | Limit::Bifurcation(_)
    )
}
