//! The steering rack: the line between points that steering alone moves.

use nalgebra::Vector3;
use suspension_core::listing::DriveKind;

use crate::kinematics::Kinematics;
use crate::mechanism::{Place, State};

/// The largest part of a velocity that is rounding; those of points are about one.
const ROUNDING: f64 = 1e-9;

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

/// Returns the outermost of the points that a drive moves equally and no other drive of the vehicle moves: of bell cranks,
/// which steering alone moves too, no two points move equally.
fn rack(state: &State, drive: usize) -> Option<[usize; 2]> {
    let velocities = &state.moved_by(drive)?.value;
    let alone = moved_alone(state, drive);
    let ends = |along: &Vector3<f64>| {
        let is_alike =
            |point: &&usize| (velocities[**point] - along).norm() < ROUNDING * along.norm();
        let place = |point: &usize| state.points.value[*point].dot(along);
        let by_place = |a: &&usize, b: &&usize| place(a).total_cmp(&place(b));
        let alike = || alone.iter().filter(is_alike);
        Some([*alike().min_by(by_place)?, *alike().max_by(by_place)?])
    };
    let length =
        |[from, to]: &[usize; 2]| (state.points.value[*to] - state.points.value[*from]).norm();
    let each = alone.iter().filter_map(|point| ends(&velocities[*point]));
    let longest = each.max_by(|a, b| length(a).total_cmp(&length(b)));
    longest.filter(|[from, to]| from != to)
}

/// Returns the points that a drive moves and no other drive of the vehicle.
fn moved_alone(state: &State, drive: usize) -> Vec<usize> {
    let is_moved = |point: usize, by: usize| {
        let moved = state.moved_by(by);
        moved.is_some_and(|moved| moved.value[point].norm() > ROUNDING)
    };
    let drives = 0..state.velocities.len();
    let is_moved_alone = |point: &usize| {
        drives
            .clone()
            .all(|by| is_moved(*point, by) == (by == drive))
    };
    let points = 0..state.points.value.len();
    points.filter(is_moved_alone).collect()
}
