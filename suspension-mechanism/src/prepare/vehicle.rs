//! The vehicle data of a motion file.

mod brake_and_drive;
pub(super) mod coupling;
pub(super) mod masses;
mod per_wheel;
pub(super) mod springs;
pub(super) mod steering_wheel;
pub(super) mod usual_drives;

use nalgebra::Vector3;
use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::PerWheel;
use crate::mechanism::{Names, Vehicle, Wheel, is_within};
use crate::prepare::task::Task;
use brake_and_drive::{car, torques};
use per_wheel::for_each_wheel;
pub(super) use per_wheel::{checked, is_positive, is_stated, length};

/// The names of the drives of travel and of steering if the file does not name them.
const TRAVEL: &str = "bump";
const STEER: &str = "steer";

/// The names with the statements of the file, drives by number; drives that it does not state are those with the
/// usual names. The wheels are where `given` has all points.
///
/// # Errors
///
/// At a length that is not positive and finite, at a number that is not a share, at a name that is not that of a
/// drive or a wheel, and if a car is described in part only.
pub(super) fn names_with_vehicle(
    task: &Task<'_>,
    given: &[Vector3<f64>],
) -> Result<Names, Failure> {
    let table = &task.file.vehicle;
    let stated = table.get_ref();
    let mut names = task.names.clone().designed(given);
    // A linkage without a wheel is treated as one with an unnamed wheel.
    let mut unnamed = [Wheel::default()];
    let wheels = match names.wheels.as_mut_slice() {
        [] => &mut unnamed,
        wheels => wheels,
    };
    let of_wheels = [
        drives(task, wheels, (TRAVEL, &stated.travel), |wheel| {
            &mut wheel.travel
        }),
        drives(task, wheels, (STEER, &stated.steer), |wheel| {
            &mut wheel.steer
        }),
        radii(task, wheels, &stated.wheel_radius),
        car(task, wheels, table),
        torques(task, wheels, stated),
    ];
    let lengths = Failure::both(
        length(task, "wheelbase", stated.wheelbase.as_ref()),
        length(task, "cg_height", stated.cg_height.as_ref()),
    );
    let (_, (wheelbase, cg_height)) = Failure::both(Failure::all(of_wheels), lengths)?;
    let each = |drive: fn(&Wheel) -> Option<usize>| distinct(wheels.iter().filter_map(drive));
    names.vehicle = Vehicle {
        travel: each(|wheel| wheel.travel),
        steer: each(|wheel| wheel.steer),
        steering_wheel: None,
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

/// Sets the drive of each wheel.
fn drives(
    task: &Task<'_>,
    wheels: &mut [Wheel],
    (usual, stated): (&str, &Option<Spanned<PerWheel<String>>>),
    drive_of: fn(&mut Wheel) -> &mut Option<usize>,
) -> Result<(), Failure> {
    let known = task.names.drive_names();
    let stated = for_each_wheel(task, wheels, stated)?;
    for (wheel, stated) in wheels.iter_mut().zip(stated) {
        *drive_of(wheel) = match stated {
            None => usual_drive(&known, usual, &wheel.name),
            Some(stated) => {
                let wanted = stated.get_ref();
                let drive = task.names.drive(wanted).ok_or_else(|| {
                    let message = unknown("drive", wanted, &known);
                    task.source.refuse(&stated.span(), message)
                })?;
                Some(drive)
            }
        };
    }
    Ok(())
}

/// Sets the radius of each wheel.
fn radii(
    task: &Task<'_>,
    wheels: &mut [Wheel],
    stated: &Option<Spanned<PerWheel<f64>>>,
) -> Result<(), Failure> {
    let radii = for_each_wheel(task, wheels, stated)?;
    for (wheel, radius) in wheels.iter_mut().zip(radii) {
        wheel.radius = length(task, "wheel_radius", radius.as_ref())?;
    }
    Ok(())
}

/// The drive whose name has the usual word, the most words of the wheel's name, and no others.
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
