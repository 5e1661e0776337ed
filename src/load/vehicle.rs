//! What a motion file says of the vehicle.

use std::collections::BTreeMap;

use toml::Spanned;

use crate::failure::Failure;
use crate::file::{DriveOf, VehicleTable};
use crate::load::task::Task;
use crate::mechanism::{Car, Names, Vehicle, Wheel};

/// The drives of travel and of steering where the file does not name them.
const TRAVEL: &str = "bump";
const STEER: &str = "steer";

/// The names with what the file says, the drives by number; without a word those of the usual names.
///
/// # Errors
///
/// At a length that is not positive and finite, at a share that is none, at a name that is no drive's or no wheel's,
/// and where a car is described in part.
pub(super) fn with_vehicle(task: &Task<'_>) -> Result<Names, Failure> {
    let stated = task.file.vehicle.clone().unwrap_or_default();
    let travel = drives(task, stated.travel.as_ref(), TRAVEL)?;
    let steer = drives(task, stated.steer.as_ref(), STEER)?;
    let mut names = task.names.clone();
    for (wheel, (travel, steer)) in names.wheels.iter_mut().zip(travel.iter().zip(&steer)) {
        (wheel.travel, wheel.steer) = (*travel, *steer);
    }
    let wheelbase = length(task, "wheelbase", stated.wheelbase.as_ref())?;
    names.vehicle = Vehicle {
        wheel_radius: length(task, "wheel_radius", stated.wheel_radius.as_ref())?,
        travel: distinct(travel),
        steer: distinct(steer),
        wheelbase,
        car: car(task, &stated, wheelbase)?,
    };
    Ok(names)
}

fn distinct(drives: Vec<Option<usize>>) -> Vec<usize> {
    let mut distinct = Vec::new();
    for drive in drives.into_iter().flatten() {
        if !distinct.contains(&drive) {
            distinct.push(drive);
        }
    }
    distinct
}

/// The drive of each wheel; of a linkage without a wheel as of one without a name.
fn drives(
    task: &Task<'_>,
    stated: Option<&Spanned<DriveOf>>,
    usual: &str,
) -> Result<Vec<Option<usize>>, Failure> {
    let known = task.names.of_drives();
    let number = |wanted: &str| known.iter().position(|drive| *drive == wanted);
    let checked = |wanted: &str, place: std::ops::Range<usize>| {
        number(wanted).ok_or_else(|| {
            let known = known.join(", ");
            let message = format!("unknown drive `{wanted}`; known are {known}");
            task.source.refuse(&place, message)
        })
    };
    let unnamed = [Wheel::default()];
    let wheels = match task.names.wheels.as_slice() {
        [] => &unnamed,
        wheels => wheels,
    };
    match stated.map(|stated| (stated.get_ref(), stated.span())) {
        None => {
            let of_wheel = |wheel: &Wheel| number(&format!("{usual}_{}", wheel.name));
            let each = wheels.iter();
            Ok(each
                .map(|wheel| of_wheel(wheel).or(number(usual)))
                .collect())
        }
        Some((DriveOf::All(name), place)) => {
            let drive = checked(name, place)?;
            Ok(vec![Some(drive); wheels.len()])
        }
        Some((DriveOf::Each(drives), place)) => {
            check_wheels(task, drives, &place)?;
            let of_wheel = |wheel: &Wheel| {
                let name = drives.get(&wheel.name);
                name.map(|name| checked(name.get_ref(), name.span()))
                    .transpose()
            };
            wheels.iter().map(of_wheel).collect()
        }
    }
}

/// Checks that a table of drives names wheels.
fn check_wheels(
    task: &Task<'_>,
    drives: &BTreeMap<String, Spanned<String>>,
    place: &std::ops::Range<usize>,
) -> Result<(), Failure> {
    let wheels = task.names.wheels.iter().map(|wheel| wheel.name.as_str());
    let named: Vec<&str> = wheels.filter(|name| !name.is_empty()).collect();
    let Some(unknown) = drives.keys().find(|name| !named.contains(&name.as_str())) else {
        return Ok(());
    };
    let message = if named.is_empty() {
        format!(
            "unknown wheel `{unknown}`; the listing names no wheels: write the drive alone, as \"NAME\""
        )
    } else {
        format!("unknown wheel `{unknown}`; known are {}", named.join(", "))
    };
    Err(task.source.refuse(place, message))
}

/// The car; `None` where the file says no more of it than the wheelbase.
fn car(
    task: &Task<'_>,
    stated: &VehicleTable,
    wheelbase: Option<f64>,
) -> Result<Option<Car>, Failure> {
    let cg_height = length(task, "cg_height", stated.cg_height.as_ref())?;
    let brake_share = share(task, "brake_share", stated.brake_share.as_ref())?;
    let drive_share = share(task, "drive_share", stated.drive_share.as_ref())?;
    let Some(axle) = stated.axle else {
        return match cg_height.or(brake_share).or(drive_share) {
            None => Ok(None),
            Some(_) => Err(incomplete(task, "axle = \"front\" or \"rear\"")),
        };
    };
    wheelbase.ok_or_else(|| incomplete(task, "wheelbase"))?;
    Ok(Some(Car {
        axle,
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
