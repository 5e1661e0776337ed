//! What a motion file says of the vehicle.

use toml::Spanned;

use crate::failure::Failure;
use crate::load::task::Task;
use crate::mechanism::Vehicle;

/// The drives of travel and of steering where the file does not name them.
const TRAVEL: &str = "bump";
const STEER: &str = "steer";

/// What the file says, the drives by number; without a word those of the usual names.
///
/// # Errors
///
/// At a radius that is not positive and finite, and at a name that is no drive's.
pub(super) fn vehicle(task: &Task<'_>) -> Result<Vehicle, Failure> {
    let stated = task.file.vehicle.clone().unwrap_or_default();
    let drives = task.names.of_drives();
    let number = |wanted: &str| drives.iter().position(|drive| *drive == wanted);
    let drive = |stated: &Option<Spanned<String>>, usual: &str| match stated {
        None => Ok(number(usual)),
        Some(name) => match number(name.get_ref()) {
            Some(drive) => Ok(Some(drive)),
            None => {
                let known = drives.join(", ");
                let message = format!("unknown drive `{}`; known are {known}", name.get_ref());
                Err(task.source.refuse(&name.span(), message))
            }
        },
    };
    if let Some(radius) = &stated.wheel_radius
        && !(*radius.get_ref() > 0.0 && radius.get_ref().is_finite())
    {
        let message =
            "wheel_radius is not a positive finite number; give it in the unit of the file";
        return Err(task.source.refuse(&radius.span(), message));
    }
    Ok(Vehicle {
        wheel_radius: stated.wheel_radius.map(Spanned::into_inner),
        travel: drive(&stated.travel, TRAVEL)?,
        steer: drive(&stated.steer, STEER)?,
    })
}
