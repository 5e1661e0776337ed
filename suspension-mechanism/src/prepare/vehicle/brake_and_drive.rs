//! The shares of the axles in the forces of brakes and drive, and the parts that bear their torques.

use toml::Spanned;

use crate::failure::Failure;
use crate::file::{PerWheel, VehicleTable};
use crate::mechanism::{Axle, Torque, Wheel};
use crate::number::number;
use crate::prepare::task::Task;
use crate::prepare::vehicle::per_wheel::{checked, for_each_wheel};

/// Sets the axle of each wheel, from its name if the file does not state it, and its shares of the forces, if the file
/// describes a car.
pub(super) fn car(
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
    let brakes = for_each_wheel(task, wheels, brake_share)?;
    let drives = for_each_wheel(task, wheels, drive_share)?;
    // An axle alone tells which way is away from the other one.
    let is_described = stated.cg_height.is_some() || brake_share.is_some() || drive_share.is_some();
    // A wheel between the axles of a longer vehicle belongs to neither.
    let is_named = |wheel: &Wheel| Axle::from_wheel_name(&wheel.name).is_some();
    let needs_axle = !wheels.iter().any(is_named);
    let refuse = |message: String| task.source.refuse(&table.span(), message);
    for (wheel, (brake, drive)) in wheels.iter_mut().zip(brakes.into_iter().zip(drives)) {
        wheel.axle = axle_of(wheel, stated).map_err(refuse)?;
        if !is_described {
            continue;
        }
        wheel.brake_share = share(task, "brake_share", brake.as_ref())?;
        wheel.drive_share = share(task, "drive_share", drive.as_ref())?;
        let lacks_axle = needs_axle && wheel.axle.is_none();
        if let Some(missing) = what_is_missing(stated, lacks_axle) {
            return Err(refuse(incomplete(missing)));
        }
    }
    check_sum(task, wheels, ("brake_share", brake_share), |wheel| {
        wheel.brake_share
    })?;
    check_sum(task, wheels, ("drive_share", drive_share), |wheel| {
        wheel.drive_share
    })
}

/// The axle of a wheel, from the file or else from the wheel's name.
///
/// # Errors
///
/// A sentence, if these contradict each other.
fn axle_of(wheel: &Wheel, stated: &VehicleTable) -> Result<Option<Axle>, String> {
    match (stated.axle, Axle::from_wheel_name(&wheel.name)) {
        (Some(stated), Some(named)) if stated != named => Err(format!(
            "`axle` contradicts the name of the wheel `{}`; leave it out",
            wheel.name
        )),
        (stated, named) => Ok(stated.or(named)),
    }
}

/// The first line that `[vehicle]` lacks for support angles.
fn what_is_missing(stated: &VehicleTable, lacks_axle: bool) -> Option<&'static str> {
    let needed = [
        (lacks_axle, "axle = \"front\" or \"rear\""),
        (stated.wheelbase.is_none(), "wheelbase"),
        (stated.cg_height.is_none(), "cg_height"),
    ];
    let missing = needed.into_iter().find(|(is_missing, _)| *is_missing);
    missing.map(|(_, line)| line)
}

fn incomplete(missing: &str) -> String {
    format!(
        "[vehicle] is incomplete: anti-dive, anti-lift and anti-squat need axle, wheelbase, cg_height and brake_share or \
         drive_share; {missing} is missing"
    )
}

/// Sets the parts that bear the torques of each wheel. The drive torque is borne by the body that carries wheels on
/// both sides, which usually contains the differential, or by the chassis.
pub(super) fn torques(
    task: &Task<'_>,
    wheels: &mut [Wheel],
    stated: &VehicleTable,
) -> Result<(), Failure> {
    let brakes = for_each_wheel(task, wheels, &stated.brake_torque)?;
    let drives = for_each_wheel(task, wheels, &stated.drive_torque)?;
    let is_of_axle = |number| Wheel::shares_its_carrier(wheels, number);
    let are_of_axle: Vec<bool> = (0..wheels.len()).map(is_of_axle).collect();
    let stated = brakes.into_iter().zip(drives).zip(are_of_axle);
    for (wheel, ((brake, drive), is_of_axle)) in wheels.iter_mut().zip(stated) {
        let usual = if is_of_axle {
            Torque::Carrier
        } else {
            Torque::Chassis
        };
        wheel.brake_torque = brake.map_or(Torque::Carrier, Spanned::into_inner);
        wheel.drive_torque = drive.map_or(usual, Spanned::into_inner);
    }
    Ok(())
}

/// The amount by which rounding may make shares exceed the whole.
const ROUNDING: f64 = 1e-9;

/// Refuses shares of axles whose sum is more than the whole.
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
         for example {{ front = 0.6, rear = 0.4 }}",
        number(front),
        number(rear)
    );
    Err(task.source.refuse(&stated.span(), message))
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
        || format!("{name} must be the axle's share of the force, from 0 to 1"),
    )
}
