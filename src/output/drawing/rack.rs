//! The steering rack: the line between points that steering alone moves.

use nalgebra::Vector3;
use suspension_core::listing::DriveKind;

use crate::kinematics::Kinematics;
use crate::mechanism::{Place, State};

/// Returns the ends of the rack of each drive that steers, by their indices. There is none where fewer than two points slide
/// with the drive, as in a corner.
pub(super) fn racks(mechanism: &dyn Kinematics) -> Vec<[usize; 2]> {
    let names = &mechanism.names;
    let steer = names.vehicle.steer.iter().copied();
    let slides = |drive: &usize| names.drives[*drive].kind == DriveKind::Coordinate;
    let steer: Vec<usize> = steer.filter(slides).collect();
    let mut read = |place: &dyn Place| {
        let state = place.state();
        let racks = steer.iter().filter_map(|drive| rack(&state, *drive));
        racks.collect()
    };
    mechanism.at_start(&mut read).unwrap_or_default()
}

/// Returns the outermost of the points that a drive moves equally and no other drive of the vehicle moves.
fn rack(state: &State, drive: usize) -> Option<[usize; 2]> {
    /// Relative to the velocity.
    const ROUNDING: f64 = 1e-9;
    let velocities = &state.moved_by(drive)?.value;
    let is_moved_by_another = |point: &usize| {
        let others = (0..state.velocities.len()).filter(|other| *other != drive);
        let mut others = others.filter_map(|other| state.moved_by(other));
        others.any(|moved| moved.value[*point].norm() > ROUNDING)
    };
    let points = 0..velocities.len();
    let alone = points.filter(|point| velocities[*point].norm() > ROUNDING);
    let alone: Vec<usize> = alone.filter(|point| !is_moved_by_another(point)).collect();
    let along: Vector3<f64> = velocities[*alone.first()?];
    let is_alike = |point: &usize| (velocities[*point] - along).norm() < ROUNDING * along.norm();
    let place = |point: &usize| state.points.value[*point].dot(&along);
    let by_place = |a: &usize, b: &usize| place(a).total_cmp(&place(b));
    let rack = || alone.iter().copied().filter(is_alike);
    let ends = [rack().min_by(by_place)?, rack().max_by(by_place)?];
    (ends[0] != ends[1]).then_some(ends)
}
