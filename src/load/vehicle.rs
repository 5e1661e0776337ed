//! What a motion file says of the vehicle.

use toml::Spanned;

use crate::failure::Failure;
use crate::file::VehicleTable;
use crate::load::task::Task;
use crate::mechanism::{Car, Vehicle};

/// The drives of travel and of steering where the file does not name them.
const TRAVEL: &str = "bump";
const STEER: &str = "steer";

/// What the file says, the drives by number; without a word those of the usual names.
///
/// # Errors
///
/// At a length that is not positive and finite, at a share that is none, at a name that is no drive's, and where a
/// car is described in part.
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
    Ok(Vehicle {
        wheel_radius: length(task, "wheel_radius", stated.wheel_radius.as_ref())?,
        travel: drive(&stated.travel, TRAVEL)?,
        steer: drive(&stated.steer, STEER)?,
        car: car(task, &stated)?,
    })
}

/// The car; `None` where the file says nothing of it.
fn car(task: &Task<'_>, stated: &VehicleTable) -> Result<Option<Car>, Failure> {
    let wheelbase = length(task, "wheelbase", stated.wheelbase.as_ref())?;
    let cg_height = length(task, "cg_height", stated.cg_height.as_ref())?;
    let brake_share = share(task, "brake_share", stated.brake_share.as_ref())?;
    let drive_share = share(task, "drive_share", stated.drive_share.as_ref())?;
    let VehicleTable {
        axle: Some(axle), ..
    } = stated
    else {
        return match wheelbase.or(cg_height).or(brake_share).or(drive_share) {
            None => Ok(None),
            Some(_) => Err(incomplete(task, "axle = \"front\" or \"rear\"")),
        };
    };
    Ok(Some(Car {
        axle: *axle,
        wheelbase: wheelbase.ok_or_else(|| incomplete(task, "wheelbase"))?,
        cg_height: cg_height.ok_or_else(|| incomplete(task, "cg_height"))?,
        brake_share,
        drive_share,
    }))
}

fn incomplete(task: &Task<'_>, missing: &str) -> Failure {
    let message = format!(
        "[vehicle] is incomplete: anti-dive, anti-lift and anti-squat need axle, wheelbase, cg_height and brake_share or \
         drive_share; {missing} is missing"
    );
    task.source.refuse(&(0..0), message)
}

/// A length in the unit of the file.
fn length(
    task: &Task<'_>,
    name: &str,
    stated: Option<&Spanned<f64>>,
) -> Result<Option<f64>, Failure> {
    let is_length = |length: f64| length > 0.0 && length.is_finite();
    checked(task, stated, is_length, || {
        format!("{name} is not a positive finite number; give it in the unit of the file")
    })
}

/// A part of a whole.
fn share(
    task: &Task<'_>,
    name: &str,
    stated: Option<&Spanned<f64>>,
) -> Result<Option<f64>, Failure> {
    checked(
        task,
        stated,
        |share| (0.0..=1.0).contains(&share),
        || format!("{name} is the axle's share of the force, from 0 to 1"),
    )
}

fn checked(
    task: &Task<'_>,
    stated: Option<&Spanned<f64>>,
    will_do: impl Fn(f64) -> bool,
    message: impl Fn() -> String,
) -> Result<Option<f64>, Failure> {
    match stated {
        Some(number) if !will_do(*number.get_ref()) => {
            Err(task.source.refuse(&number.span(), message()))
        }
        _ => Ok(stated.map(|number| *number.get_ref())),
    }
}
