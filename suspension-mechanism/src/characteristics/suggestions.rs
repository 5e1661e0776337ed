//! Suggestions for a quantity that a design does not have under the given name.

use crate::characteristics::parameters::columns;
use crate::characteristics::title::{Title, as_in_tables};
use crate::mechanism::{Description, Names, SteeringWheel};
use crate::quantities::{
    self, Column, Quantity, STEERING_RATIO, STEERING_WHEEL_ANGLE, catalogue, from_design, of_axles,
};

/// The quantity that is meant by a name which is none of the `known` ones, in quotes, or several that may be; `None` if
/// nothing is near.
///
/// # Errors
///
/// A sentence about a quantity that no hardpoint changes at the design position, or that this mechanism lacks.
pub(crate) fn meant<'a>(
    wanted: &str,
    known: impl IntoIterator<Item = &'a str>,
    mechanism: &Description,
) -> Result<Option<String>, String> {
    if let Some(message) = zero_at_design(wanted, mechanism) {
        return Err(message);
    }
    let named = as_in_tables(wanted);
    let in_reports = named_in_reports(wanted, mechanism).map(|name| format!("`{name}`"));
    let meant = in_reports.or_else(|| suggest_for_wheels(&named, known));
    match meant {
        Some(meant) => Ok(Some(meant)),
        None => not_of_this(&named, mechanism).map_or(Ok(None), Err),
    }
}

/// A sentence about a quantity that no hardpoint changes at the design position, with those of this mechanism that
/// can be named instead; `None` for any other name, and if there are none.
fn zero_at_design(wanted: &str, mechanism: &Description) -> Option<String> {
    let is_called = |quantity: &&Quantity| {
        let wheel = wanted.strip_suffix(quantity.name);
        wheel.is_some_and(|wheel| wheel.is_empty() || wheel.ends_with('_'))
    };
    let mut quantities = from_design();
    let quantity = quantities.find(is_called)?;
    let wheel = wanted.strip_suffix(quantity.name)?;
    let (instead, axis) = quantity.zero_at_design?;
    let columns = columns(mechanism).into_iter();
    let columns = columns.filter(|column| column.is(instead) && column.axis == axis);
    let names = columns.map(|column: Column| column.title());
    let names = listed(names.filter(|name| name.starts_with(wheel)))?;
    let why = if *quantity == STEERING_WHEEL_ANGLE {
        "is set by the drive of steering, whatever the hardpoints"
    } else {
        "counts from the design position and is zero there, whatever the hardpoints"
    };
    Some(format!(
        "`{wanted}` {why}; name in its place {names}, which they change"
    ))
}

/// A sentence about a quantity that mechanisms may have and this one lacks: what it needs, by the line of `[vehicle]`
/// if it is one; or about a derivative that has a name of its own. `None` for any other name.
pub fn not_of_this(wanted: &str, mechanism: &Description) -> Option<String> {
    if let Some((_, quantity)) = DERIVATIVES.iter().find(|(name, _)| *name == wanted) {
        let columns = columns(mechanism).into_iter();
        let columns = columns.filter(|column| column.quantity.name == *quantity);
        let names = listed(columns.map(|column: Column| column.title()))?;
        return Some(format!(
            "`{wanted}` is the derivative of {names} with respect to a drive of travel; name {names} in its place"
        ));
    }
    let of_wheel = remove_wheel(wanted, &mechanism.names);
    let quantity = catalogue().find(|quantity| quantity.name == of_wheel)?;
    let is_known = |column: &Column| column.title() == wanted;
    if columns(mechanism).iter().any(is_known) {
        return None;
    }
    let is_of_axle = of_axles().any(|other| other == quantity);
    let needs = match lines_needed(quantity, &mechanism.names) {
        _ if is_of_axle && mechanism.names.wheels.len() < 2 => {
            "it is a quantity of an axle, with two wheels".to_owned()
        }
        "" if needs_radius(quantity, &mechanism.names) => {
            "it needs wheel_radius under [vehicle], see suspension motion --help".to_owned()
        }
        "" => "suspension motion --help says what it needs, the wheel's name before it, an axis behind it, or a line under [vehicle]"
            .to_owned(),
        lines => format!("it needs {lines} under [vehicle], see suspension motion --help"),
    };
    Some(format!("there is no `{wanted}` of this mechanism: {needs}"))
}

/// The name in tables of the quantity that reports or tables call so: `roll_centre` for `Roll centre`, or for `height of the
/// roll centre above the ground`.
fn named_in_reports(wanted: &str, mechanism: &Description) -> Option<String> {
    let mut columns = columns(mechanism).into_iter();
    let wheels = &mechanism.names.wheels;
    let found = columns.find(|column| Title::is_called(column, wheels, wanted))?;
    Some(found.title())
}

/// The name of a quantity without that of a wheel of the mechanism: `camber` for `left_camber`; any other name
/// unchanged.
fn remove_wheel<'a>(wanted: &'a str, names: &Names) -> &'a str {
    let mut wheels = names.wheels.iter();
    let of_wheel = wheels.find_map(|wheel| wanted.strip_prefix(&*wheel.name)?.strip_prefix('_'));
    of_wheel.unwrap_or(wanted)
}

/// The lines of `[vehicle]` that a quantity needs. For the steering wheel this is the line for the drives that steer:
/// a rack's or a steering box's.
fn lines_needed(quantity: &Quantity, names: &Names) -> &'static str {
    if ![&STEERING_RATIO, &STEERING_WHEEL_ANGLE].contains(&quantity) {
        return quantity.vehicle;
    }
    let drives = names.vehicle.steer.iter();
    let mut are_angles: Vec<bool> = drives
        .map(|drive| names.drives[*drive].kind.is_angle())
        .collect();
    are_angles.dedup();
    match *are_angles {
        [false] => SteeringWheel::RACK,
        [true] => SteeringWheel::BOX,
        _ => quantity.vehicle,
    }
}

/// Whether a mechanism that lacks a quantity would have it if the radius of its wheels were known.
fn needs_radius(quantity: &'static Quantity, names: &Names) -> bool {
    let has = |names: &Names| !quantities::columns([quantity], names).is_empty();
    let mut on_ground = names.clone();
    for wheel in &mut on_ground.wheels {
        wheel.radius.get_or_insert(1.0);
    }
    !has(names) && has(&on_ground)
}

/// The usual names of derivatives of quantities with respect to the wheel's travel.
const DERIVATIVES: [(&str, &str); 3] = [
    ("bump_steer", "toe"),
    ("bump_camber", "camber"),
    ("camber_gain", "camber"),
];

/// A list of known quantities of wheels or of the axle whose names end with the wanted one.
pub fn suggest_for_wheels<'a>(
    wanted: &str,
    known: impl IntoIterator<Item = &'a str>,
) -> Option<String> {
    let ending = format!("_{wanted}");
    let known = known.into_iter().filter(|name| name.ends_with(&ending));
    listed(known.map(str::to_owned))
}

fn listed(names: impl Iterator<Item = String>) -> Option<String> {
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    let (last, others) = names.split_last()?;
    Some(match others {
        [] => last.clone(),
        others => format!("{} or {last}", others.join(", ")),
    })
}
