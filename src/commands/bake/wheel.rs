//! The wheel whose motion is baked.

use crate::commands::bake::baking::Variables;
use crate::kinematics::Kinematics;
use crate::mechanism::{Place, Wheel};

/// The number of the wheel that is `wanted` by its name, or else of the first that one of the drives moves up and down, or
/// else of the first that one of them moves at all.
///
/// # Errors
///
/// A sentence about a name that no wheel has.
pub(super) fn chosen(
    mechanism: &dyn Kinematics,
    variables: &Variables,
    wanted: Option<&str>,
) -> Result<usize, String> {
    let names = &mechanism.names;
    if let Some(wanted) = wanted.filter(|_| !names.wheels.is_empty()) {
        return names.chosen_wheel(wanted);
    }
    // The names of drives that do not exist are refused with their ranges.
    let drives = variables.drives().into_iter();
    let drives = drives.filter_map(|drive| names.chosen_drive(drive).ok());
    let drives: Vec<usize> = drives.collect();
    let travels = |drive: &usize| {
        let mut wheels = names.wheels.iter();
        wheels.position(|wheel| wheel.travel == Some(*drive))
    };
    let moves = |drive: &usize| first_moved(mechanism, *drive);
    let found = drives.iter().find_map(travels);
    Ok(found.or_else(|| drives.iter().find_map(moves)).unwrap_or(0))
}

/// The first wheel that a drive moves at the first instant.
fn first_moved(mechanism: &dyn Kinematics, drive: usize) -> Option<usize> {
    /// A part of the largest velocity of a point.
    const ROUNDING: f64 = 1e-9;
    let mut read = |place: &dyn Place| {
        let velocities = place.per(drive)?.points.rate;
        let largest = velocities.iter().map(|velocity| velocity.norm());
        let least = ROUNDING * largest.fold(0.0, f64::max);
        let moves = |point: usize| velocities[point].norm() > least;
        let is_moved = |wheel: &Wheel| wheel.points.axis.into_iter().any(moves);
        mechanism.names.wheels.iter().position(is_moved)
    };
    mechanism.at_start(&mut read).flatten()
}
