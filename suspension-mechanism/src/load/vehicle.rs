//! What a motion file says of the vehicle.

use std::ops::Range;

use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{PerWheel, VehicleTable};
use crate::load::task::Task;
use crate::mechanism::{Axle, Names, Torque, Vehicle, Wheel, is_within};
use crate::number::number;

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
    let table = task.file.vehicle.clone();
    let table = table.unwrap_or_else(|| Spanned::new(0..0, VehicleTable::default()));
    let stated = table.get_ref();
    let mut names = task.names.clone();
    // Of a linkage without a wheel as of one without a name.
    let mut unnamed = [Wheel::default()];
    let wheels = match names.wheels.as_mut_slice() {
        [] => &mut unnamed,
        wheels => wheels,
    };
    drives(task, wheels, (TRAVEL, &stated.travel), |wheel| {
        &mut wheel.travel
    })?;
    drives(task, wheels, (STEER, &stated.steer), |wheel| {
        &mut wheel.steer
    })?;
    let lengths = optional(task, wheels, &stated.wheel_radius)?;
    for (wheel, radius) in wheels.iter_mut().zip(lengths) {
        wheel.radius = checked_length(task, "wheel_radius", radius)?;
    }
    let wheelbase = length(task, "wheelbase", stated.wheelbase.as_ref())?;
    let cg_height = length(task, "cg_height", stated.cg_height.as_ref())?;
    car(task, wheels, &table)?;
    torques(task, wheels, stated)?;
    let each = |drive: fn(&Wheel) -> Option<usize>| distinct(wheels.iter().filter_map(drive));
    names.vehicle = Vehicle {
        travel: each(|wheel| wheel.travel),
        steer: each(|wheel| wheel.steer),
        wheelbase,
        cg_height,
        springs: [].into(),
        masses: [].into(),
    };
    Ok(names)
}

fn distinct(drives: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut distinct = Vec::new();
    for drive in drives {
        if !distinct.contains(&drive) {
            distinct.push(drive);
        }
    }
    distinct
}

/// What is stated, with its place in the file.
type Stated<T> = Option<(T, Range<usize>)>;

/// What is stated of each wheel.
fn of_each<T: Clone>(
    task: &Task<'_>,
    wheels: &[Wheel],
    stated: &Spanned<PerWheel<T>>,
) -> Result<Vec<Stated<T>>, Failure> {
    let of_some = match stated.get_ref() {
        PerWheel::All(all) => return Ok(vec![Some((all.clone(), stated.span())); wheels.len()]),
        PerWheel::Of(some) => some,
    };
    let names: Vec<&str> = wheels.iter().map(|wheel| wheel.name.as_str()).collect();
    let mut keys = of_some.keys();
    if let Some(wanted) = keys.find(|key| !names.iter().any(|name| is_within(key, name))) {
        let message = if names == [""] {
            format!(
                "unknown wheel `{wanted}`; the listing names no wheels: write what stands behind `=` alone"
            )
        } else {
            unknown("wheel", wanted, &names)
        };
        return Err(task.source.refuse(&stated.span(), message));
    }
    // Of several that a wheel's name has, the longest.
    let of_wheel = |name: &&str| {
        let within = of_some.iter().filter(|(key, _)| is_within(key, name));
        let longest = within.max_by_key(|(key, _)| key.split('_').count());
        longest.map(|(_, value)| (value.get_ref().clone(), value.span()))
    };
    Ok(names.iter().map(of_wheel).collect())
}

/// Sets the drive of each wheel.
fn drives(
    task: &Task<'_>,
    wheels: &mut [Wheel],
    (usual, stated): (&str, &Option<Spanned<PerWheel<String>>>),
    of: fn(&mut Wheel) -> &mut Option<usize>,
) -> Result<(), Failure> {
    let known = task.names.of_drives();
    let Some(stated) = stated else {
        for wheel in wheels {
            *of(wheel) = usual_drive(&known, usual, &wheel.name);
        }
        return Ok(());
    };
    let stated = of_each(task, wheels, stated)?;
    for (wheel, stated) in wheels.iter_mut().zip(stated) {
        let Some((wanted, place)) = stated else {
            *of(wheel) = usual_drive(&known, usual, &wheel.name);
            continue;
        };
        let Some(drive) = known.iter().position(|drive| *drive == wanted) else {
            let message = unknown("drive", &wanted, &known);
            return Err(task.source.refuse(&place, message));
        };
        *of(wheel) = Some(drive);
    }
    Ok(())
}

/// The drive whose name has the usual word, and of the wheel's name the most words, and no others.
fn usual_drive(known: &[&str], usual: &str, wheel: &str) -> Option<usize> {
    let is_of_wheel = |drive: &str| {
        let mut words = drive.split('_');
        is_within(usual, drive) && words.all(|word| word == usual || is_within(word, wheel))
    };
    let drives = known.iter().enumerate();
    let of_wheel = drives.filter(|(_, drive)| is_of_wheel(drive));
    let longest = of_wheel.max_by_key(|(_, drive)| drive.split('_').count());
    longest.map(|(drive, _)| drive)
}

/// Sets the axle of each wheel and its shares of the forces, where the file describes a car.
fn car(
    task: &Task<'_>,
    wheels: &mut [Wheel],
    table: &Spanned<VehicleTable>,
) -> Result<(), Failure> {
    let stated = table.get_ref();
    let VehicleTable {
        brake_share,
        drive_share,
        ..
    } = stated;
    let brakes = optional(task, wheels, brake_share)?;
    let drives = optional(task, wheels, drive_share)?;
    let is_described = stated.axle.is_some()
        || stated.cg_height.is_some()
        || brake_share.is_some()
        || drive_share.is_some();
    if !is_described {
        return Ok(());
    }
    // A wheel between the axles of a longer vehicle is on neither.
    let tells_no_name = wheels.iter().all(|wheel| Axle::of(&wheel.name).is_none());
    for (wheel, (brake, drive)) in wheels.iter_mut().zip(brakes.into_iter().zip(drives)) {
        let told = Axle::of(&wheel.name);
        if let (Some(_), Some(told)) = (stated.axle, told)
            && stated.axle != Some(told)
        {
            let message = format!(
                "`axle` contradicts the name of the wheel `{}`; leave it out",
                wheel.name
            );
            return Err(task.source.refuse(&table.span(), message));
        }
        wheel.axle = stated.axle.or(told);
        wheel.brake_share = share(task, "brake_share", brake)?;
        wheel.drive_share = share(task, "drive_share", drive)?;
        let missing = [
            (
                wheel.axle.is_none() && tells_no_name,
                "axle = \"front\" or \"rear\"",
            ),
            (stated.wheelbase.is_none(), "wheelbase"),
            (stated.cg_height.is_none(), "cg_height"),
        ];
        if let Some((_, missing)) = missing.into_iter().find(|(is_missing, _)| *is_missing) {
            return Err(task.source.refuse(&table.span(), incomplete(missing)));
        }
    }
    check_sum(task, wheels, ("brake_share", brake_share), |wheel| {
        wheel.brake_share
    })?;
    check_sum(task, wheels, ("drive_share", drive_share), |wheel| {
        wheel.drive_share
    })
}

/// Sets what bears the torques of each wheel. Of the drive it is the body that carries several wheels, which as a rule has the
/// differential in it, or the chassis.
fn torques(task: &Task<'_>, wheels: &mut [Wheel], stated: &VehicleTable) -> Result<(), Failure> {
    let brakes = optional(task, wheels, &stated.brake_torque)?;
    let drives = optional(task, wheels, &stated.drive_torque)?;
    let carriers: Vec<_> = wheels.iter().map(|wheel| wheel.points.carrier).collect();
    for (wheel, (brake, drive)) in wheels.iter_mut().zip(brakes.into_iter().zip(drives)) {
        let carrier = wheel.points.carrier;
        let carries_several = carriers.iter().filter(|other| **other == carrier).count() > 1;
        let usual = if carries_several {
            Torque::Carrier
        } else {
            Torque::Chassis
        };
        wheel.brake_torque = brake.map_or(Torque::Carrier, |(torque, _)| torque);
        wheel.drive_torque = drive.map_or(usual, |(torque, _)| torque);
    }
    Ok(())
}

/// By how much shares may exceed the whole by rounding.
const ROUNDING: f64 = 1e-9;

/// Refuses shares of axles that are more than the whole together.
fn check_sum(
    task: &Task<'_>,
    wheels: &[Wheel],
    (name, stated): (&str, &Option<Spanned<PerWheel<f64>>>),
    of: fn(&Wheel) -> Option<f64>,
) -> Result<(), Failure> {
    let of_axle = |axle| {
        let wheels = wheels.iter().filter(|wheel| wheel.axle == Some(axle));
        wheels.filter_map(of).fold(0.0, f64::max)
    };
    let [front, rear] = [Axle::Front, Axle::Rear].map(of_axle);
    let Some(stated) = stated.as_ref().filter(|_| front + rear > 1.0 + ROUNDING) else {
        return Ok(());
    };
    let message = format!(
        "{name} is {} in front and {} at the rear, more than 1 in all; state how the axles share the force, \
         {{ front = 0.6, rear = 0.4 }} for one",
        number(front),
        number(rear)
    );
    Err(task.source.refuse(&stated.span(), message))
}

fn incomplete(missing: &str) -> String {
    format!(
        "[vehicle] is incomplete: anti-dive, anti-lift and anti-squat need axle, wheelbase, cg_height and brake_share or \
         drive_share; {missing} is missing"
    )
}

/// What is stated of each wheel, where anything is.
fn optional<T: Clone>(
    task: &Task<'_>,
    wheels: &[Wheel],
    stated: &Option<Spanned<PerWheel<T>>>,
) -> Result<Vec<Stated<T>>, Failure> {
    match stated {
        Some(stated) => of_each(task, wheels, stated),
        None => Ok(vec![None; wheels.len()]),
    }
}

/// A length in the unit of the file.
fn length(
    task: &Task<'_>,
    name: &str,
    stated: Option<&Spanned<f64>>,
) -> Result<Option<f64>, Failure> {
    checked_length(
        task,
        name,
        stated.map(|stated| (*stated.get_ref(), stated.span())),
    )
}

fn checked_length(
    task: &Task<'_>,
    name: &str,
    stated: Stated<f64>,
) -> Result<Option<f64>, Failure> {
    let is_length = |length: f64| length > 0.0 && length.is_finite();
    checked(task, stated, is_length, || {
        format!("{name} is not a positive finite number; give it in the unit of the file")
    })
}

/// A part of a whole.
fn share(task: &Task<'_>, name: &str, stated: Stated<f64>) -> Result<Option<f64>, Failure> {
    checked(
        task,
        stated,
        |share| (0.0..=1.0).contains(&share),
        || format!("{name} is the axle's share of the force, from 0 to 1"),
    )
}

fn checked(
    task: &Task<'_>,
    stated: Stated<f64>,
    will_do: impl Fn(f64) -> bool,
    message: impl Fn() -> String,
) -> Result<Option<f64>, Failure> {
    match stated {
        Some((number, place)) if !will_do(number) => Err(task.source.refuse(&place, message())),
        _ => Ok(stated.map(|(number, _)| number)),
    }
}
