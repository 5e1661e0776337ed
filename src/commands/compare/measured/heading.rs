//! Headings of measured tables: a drive or a quantity, and its unit.

use std::collections::BTreeSet;

use suspension_listing::did_you_mean::mistyped;

use super::rig_names::{in_own_words, toe_out};
use crate::characteristics::{
    Title, as_in_tables, columns_of_positions, not_of_this, suggest_for_wheels,
};
use crate::file::Dimension;
use crate::measured_table::units::{name_and_symbol, usual_symbol};
use crate::mechanism::{Description, GridAxis, Unit};
use crate::quantities::{CENTRE, Column, DRIVES, STEERING_WHEEL_ANGLE, WHEEL_TRAVEL, columns};

/// What a heading states.
pub(super) struct Stated {
    pub(super) named: Named,
    pub(super) unit: Unit,
    /// That of the number in this unit.
    pub(super) symbol: String,
    /// The factor from the mechanism's number to that of the table.
    pub(super) scale: f64,
}

/// What a heading names.
pub(super) struct Named {
    pub(super) title: String,
    dimension: Dimension,
    /// The drives, by number, each with its change per unit; of wheel travel the one that lifts the wheel, of other
    /// quantities than that and the steering wheel's angle none.
    pub(super) drives: Vec<(usize, f64)>,
    /// The quantity; `None` if drives are named.
    pub(super) quantity: Option<Column>,
}

impl Stated {
    /// Reads a heading: the name of a column in CSV files, or a name with a unit, as `left toe [deg]`; without one it has the
    /// unit `below`. Returns `None` if the model has nothing of this name.
    ///
    /// # Errors
    ///
    /// A sentence with the remedy if a name seems mistyped, and if its unit is missing.
    pub(super) fn read(
        mechanism: &Description,
        heading: &str,
        below: &str,
    ) -> Result<Option<Self>, String> {
        let own = mechanism.unit;
        let mut known: Vec<Column> = columns_of_positions(mechanism).collect();
        let in_csv = |unit: Unit| known.iter().position(|each| each.csv_name(unit) == heading);
        let (named, unit) = match units(own).find_map(|unit| Some((in_csv(unit)?, unit))) {
            Some((found, unit)) => (Named::new(mechanism, known.swap_remove(found)), unit),
            None => {
                let (name, symbol) = name_and_symbol(heading, below);
                let Some(named) = Named::find(mechanism, known, name)? else {
                    return Ok(None);
                };
                let unit = unit_of(named.dimension, name, symbol, own)?;
                (named, unit)
            }
        };
        let dimension = named.dimension;
        Ok(Some(Self {
            named,
            unit,
            symbol: dimension.symbol(unit),
            scale: dimension.conversion(own, unit) * unit.file_factor(dimension),
        }))
    }
}

impl Named {
    fn new(mechanism: &Description, column: Column) -> Self {
        let names = &mechanism.names;
        let is_drive = column.is(&DRIVES);
        let drive = if is_drive {
            let mut drives = names.drives.iter();
            let drive = drives.position(|drive| drive.name == column.name);
            drive.map(|drive| (drive, 1.0))
        } else if column.is(&STEERING_WHEEL_ANGLE) {
            let wheel = names.vehicle.steering_wheel.as_ref();
            wheel.map(|wheel| (wheel.drive, 1.0 / wheel.per_drive()))
        } else {
            let of_wheel = column.wheel.as_deref().unwrap_or_default();
            let mut wheels = names.wheels.iter();
            let wheel = wheels.find(|wheel| wheel.name == of_wheel);
            let wheel = wheel.filter(|_| column.is(&WHEEL_TRAVEL));
            wheel.and_then(|wheel| Some((wheel.travel?, 1.0)))
        };
        Self {
            // A drive has the name by which options take it.
            title: match is_drive {
                true => column.name.clone(),
                false => Title::new(&column, &names.wheels).to_string(),
            },
            dimension: column.dimension,
            drives: drive.into_iter().collect(),
            quantity: (!is_drive).then_some(column),
        }
    }

    /// Finds drives joined by commas, as sweep takes them, or a number by its name in tables or for people.
    fn find(
        mechanism: &Description,
        mut known: Vec<Column>,
        name: &str,
    ) -> Result<Option<Self>, String> {
        if name.contains(',') {
            let GridAxis { drives, .. } = GridAxis::named(mechanism, name, &[], &[])?;
            return Ok(Some(Self {
                title: name.to_owned(),
                dimension: mechanism.names.drives[drives[0].0].kind.into(),
                drives,
                quantity: None,
            }));
        }
        let wheels = &mechanism.names.wheels;
        let in_own_words = in_own_words(mechanism, name);
        let position = |name: &str| {
            let in_tables = as_in_tables(name);
            let exact = known.iter().position(|column| column.title() == in_tables);
            let mut columns = known.iter();
            exact.or_else(|| columns.position(|column| Title::is_called(column, wheels, name)))
        };
        let found = position(name).or_else(|| position(&in_own_words));
        let found = found.map(|found| known.swap_remove(found));
        match found.or_else(|| wheel_centre(mechanism, name)) {
            Some(found) => Ok(Some(Self::new(mechanism, found))),
            None => unsteered(mechanism, &as_in_tables(name))
                .or_else(|| unsteered(mechanism, &in_own_words))
                .or_else(|| toe_out(name))
                .or_else(|| meant(mechanism, &known, name, &in_own_words))
                .map_or(Ok(None), Err),
        }
    }
}

/// Finds a coordinate of a wheel centre as reports and pages call it, whatever the name of its point.
fn wheel_centre(mechanism: &Description, name: &str) -> Option<Column> {
    let mut centres = columns([&CENTRE], &mechanism.names).into_iter();
    centres.find(|column| Title::is_called(column, &mechanism.names.wheels, name))
}

/// Says what a model lacks whose steering wheel a table turns; without it the model would stay straight ahead.
fn unsteered(mechanism: &Description, wanted: &str) -> Option<String> {
    let angle = STEERING_WHEEL_ANGLE.name;
    let steers = !mechanism.names.vehicle.steer.is_empty();
    let is_called = wanted == angle || wanted == as_in_tables(STEERING_WHEEL_ANGLE.title);
    let needs = not_of_this(angle, mechanism).filter(|_| steers && is_called);
    needs.map(|needs| format!("{needs}; or empty the heading"))
}

/// Says what is near to a name that no number has, or to the same `in_own_words`.
fn meant(
    mechanism: &Description,
    known: &[Column],
    wanted: &str,
    in_own_words: &str,
) -> Option<String> {
    let wheels = &mechanism.names.wheels;
    let names = known.iter();
    let names = names.flat_map(|each| [each.title(), Title::new(each, wheels).to_string()]);
    let names: BTreeSet<String> = names.map(|name| as_in_tables(&name)).collect();
    let names = || names.iter().map(String::as_str);
    let near = |name: &str| {
        // A single letter is an axis, behind many names.
        let of_wheels = suggest_for_wheels(name, names()).filter(|_| name.len() > 1);
        of_wheels.or_else(|| mistyped(name, names()).map(|near| format!("`{near}`")))
    };
    let near = near(&as_in_tables(wanted)).or_else(|| near(in_own_words))?;
    Some(format!(
        "unknown quantity `{wanted}`; did you mean {near}? A column whose heading is empty is left out"
    ))
}

/// Returns the units in which a file may be, its own first.
fn units(own: Unit) -> impl Iterator<Item = Unit> {
    [own].into_iter().chain(Unit::all())
}

/// Returns the unit that a symbol means for a dimension.
fn unit_of(dimension: Dimension, name: &str, symbol: &str, own: Unit) -> Result<Unit, String> {
    let (_, usual) = dimension.display_scale(own);
    let wanted = usual_symbol(symbol);
    let mut units = units(own);
    let found = units.find(|unit| dimension.symbol(*unit).eq_ignore_ascii_case(&wanted));
    found.ok_or_else(|| match symbol {
        "" => format!("`{name}` states no unit; write `{name} [{usual}]`"),
        _ => format!(
            "`{symbol}` is no unit of `{name}` here; convert the column and write `{name} [{usual}]`"
        ),
    })
}
