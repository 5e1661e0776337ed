//! The wheel whose motion is baked.

use crate::bake::RequestedPoints;
use crate::commands::bake::baking::{Baking, Variables};
use crate::kinematics::Kinematics;
use crate::mechanism::{Place, Wheel, listed};

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
    let drives = drives(mechanism, variables);
    let travels = |drive: &usize| {
        let mut wheels = names.wheels.iter();
        wheels.position(|wheel| wheel.travel == Some(*drive))
    };
    let moves = |drive: &usize| are_moved(mechanism, *drive).iter().position(|moved| *moved);
    let found = drives.iter().find_map(travels);
    Ok(found.or_else(|| drives.iter().find_map(moves)).unwrap_or(0))
}

/// A note that none of the drives moves the wheel that is baked.
pub(super) fn note_on_still(baking: &Baking<'_>) -> Option<String> {
    let mechanism = baking.mechanism;
    let RequestedPoints::Wheel(wheel) = baking.points else {
        return None;
    };
    let drives = drives(mechanism, &baking.variables);
    let is_moved = |drive: &usize| are_moved(mechanism, *drive).get(wheel) != Some(&false);
    if drives.iter().any(is_moved) {
        return None;
    }
    let names = &mechanism.names;
    let called = drives.iter().map(|drive| names.drives[*drive].name.clone());
    Some(format!(
        "{} {} not move the {}: what is baked is constant",
        listed(called),
        if drives.len() == 1 { "does" } else { "do" },
        names.wheels.get(wheel)?.title("wheel")
    ))
}

/// The drives that move. The names of those that do not exist are refused with their ranges.
fn drives(mechanism: &dyn Kinematics, variables: &Variables) -> Vec<usize> {
    let drives = variables.drives().into_iter();
    let known = drives.filter_map(|drive| mechanism.names.chosen_drive(drive).ok());
    known.collect()
}

/// Whether a drive moves each wheel at the first instant.
fn are_moved(mechanism: &dyn Kinematics, drive: usize) -> Vec<bool> {
    /// A part of the largest velocity of a point.
    const ROUNDING: f64 = 1e-9;
    let mut read = |place: &dyn Place| {
        let velocities = place.per(drive)?.points.rate;
        let largest = velocities.iter().map(|velocity| velocity.norm());
        let least = ROUNDING * largest.fold(0.0, f64::max);
        let moves = |point: usize| velocities[point].norm() > least;
        let is_moved = |wheel: &Wheel| wheel.points.axis.into_iter().any(moves);
        Some(mechanism.names.wheels.iter().map(is_moved).collect())
    };
    mechanism.at_start(&mut read).flatten().unwrap_or_default()
}
