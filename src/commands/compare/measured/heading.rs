//! Headings of measured tables: a drive or a quantity, and its unit.

use suspension_listing::did_you_mean::unknown;

use crate::characteristics::{Title, columns_of_positions, not_of_this, suggest_for_wheels};
use crate::file::Dimension;
use crate::mechanism::{Angle, Axis, Description, Length, Unit};
use crate::quantities::{Column, DRIVES, WHEEL_TRAVEL};

/// A column of a table.
pub(super) struct Stated {
    /// Its index.
    pub(super) column: usize,
    pub(super) named: Named,
    pub(super) symbol: String,
    /// The factor from the mechanism's number to that of the table.
    pub(super) scale: f64,
}

/// What a heading names.
pub(super) struct Named {
    pub(super) title: String,
    dimension: Dimension,
    /// The drives, by number, each with its part of the change; of wheel travel the one that lifts the wheel, of other
    /// quantities none.
    pub(super) drives: Vec<(usize, f64)>,
    /// The quantity; `None` if drives are named.
    pub(super) quantity: Option<Column>,
}

impl Stated {
    /// Reads a heading: the name of a column in CSV files, or a name with a unit, as `left toe [deg]`.
    ///
    /// # Errors
    ///
    /// A sentence with the remedy if it names nothing, or no unit.
    pub(super) fn read(
        mechanism: &Description,
        column: usize,
        heading: &str,
    ) -> Result<Self, String> {
        let own = mechanism.unit;
        let mut known: Vec<Column> = columns_of_positions(mechanism).collect();
        let in_csv = |unit: Unit| known.iter().position(|each| each.csv_name(unit) == heading);
        let (named, unit) = match units(own).find_map(|unit| Some((in_csv(unit)?, unit))) {
            Some((found, unit)) => (Named::new(mechanism, known.swap_remove(found)), unit),
            None => {
                let (name, symbol) = name_and_symbol(heading);
                let named = Named::find(mechanism, known, name)?;
                let unit = unit_of(named.dimension, name, symbol, own)?;
                (named, unit)
            }
        };
        let dimension = named.dimension;
        Ok(Self {
            column,
            named,
            symbol: dimension.symbol(unit),
            scale: dimension.conversion(own, unit) * dimension.file_factor(unit),
        })
    }
}

impl Named {
    fn new(mechanism: &Description, column: Column) -> Self {
        let names = &mechanism.names;
        let is_drive = column.is(&DRIVES);
        let drive = if is_drive {
            let mut drives = names.drives.iter();
            drives.position(|drive| drive.name == column.name)
        } else {
            let of_wheel = column.wheel.as_deref().unwrap_or_default();
            let mut wheels = names.wheels.iter();
            let wheel = wheels.find(|wheel| wheel.name == of_wheel);
            wheel.and_then(|wheel| wheel.travel.filter(|_| column.is(&WHEEL_TRAVEL)))
        };
        Self {
            title: Title::new(&column, &names.wheels).to_string(),
            dimension: column.dimension,
            drives: drive.map(|drive| (drive, 1.0)).into_iter().collect(),
            quantity: (!is_drive).then_some(column),
        }
    }

    /// Finds drives joined by commas, as sweep takes them, or a number by its name in tables or for people.
    fn find(mechanism: &Description, mut known: Vec<Column>, name: &str) -> Result<Self, String> {
        if name.contains(',') {
            let Axis { drives, .. } = Axis::named(mechanism, name, &[], &[])?;
            return Ok(Self {
                title: name.to_owned(),
                dimension: mechanism.names.drives[drives[0].0].kind.into(),
                drives,
                quantity: None,
            });
        }
        let wanted = plain(name);
        let is_called = |column: &Column| {
            let for_people = Title::new(column, &mechanism.names.wheels).to_string();
            let names = [column.title(), for_people];
            names.iter().any(|name| plain(name) == wanted)
        };
        match known.iter().position(is_called) {
            Some(found) => Ok(Self::new(mechanism, known.swap_remove(found))),
            None => Err(unknown_name(mechanism, &known, name)),
        }
    }
}

/// Returns a name in small letters, in the form of those in tables.
fn plain(name: &str) -> String {
    name.to_lowercase().replace(' ', "_")
}

/// Says what may be meant by a name that no number has.
fn unknown_name(mechanism: &Description, known: &[Column], wanted: &str) -> String {
    // Coordinates would make the list long.
    let known = known.iter().filter(|column| column.axis.is_none());
    let titles: Vec<String> = known.map(Column::title).collect();
    let titles: Vec<&str> = titles.iter().map(String::as_str).collect();
    let name = plain(wanted);
    let without_unit = name.rsplit_once('_').map(|(name, _)| name);
    let mut names = [Some(&*name), without_unit].into_iter().flatten();
    let why = names.find_map(|name| {
        let meant = suggest_for_wheels(name, titles.iter().copied());
        let meant =
            meant.map(|meant| format!("unknown quantity `{wanted}`; did you mean {meant}?"));
        meant.or_else(|| not_of_this(name, mechanism))
    });
    let why = why.unwrap_or_else(|| unknown("quantity", wanted, &titles));
    let stop = if why.ends_with('?') { "" } else { "." };
    format!("{why}{stop} A column whose heading is empty is left out")
}

/// Returns the units in which a file may be, its own first.
fn units(own: Unit) -> impl Iterator<Item = Unit> {
    let angles = [Angle::Degree, Angle::Radian];
    let all = Length::ALL.into_iter();
    let all = all.flat_map(move |length| angles.map(|angle| Unit { length, angle }));
    [own].into_iter().chain(all)
}

/// Splits `toe [deg]` or `toe (deg)`.
fn name_and_symbol(heading: &str) -> (&str, Option<&str>) {
    match heading.rsplit_once(['[', '(']) {
        Some((name, symbol)) => {
            let symbol = symbol.trim_end_matches([']', ')']).trim();
            (name.trim(), Some(symbol))
        }
        None => (heading, None),
    }
}

/// Returns the unit that a symbol means for a dimension.
fn unit_of(
    dimension: Dimension,
    name: &str,
    symbol: Option<&str>,
    own: Unit,
) -> Result<Unit, String> {
    let (_, usual) = dimension.display_scale(own);
    let Some(symbol) = symbol else {
        return Err(format!("`{name}` states no unit; write `{name} [{usual}]`"));
    };
    let wanted = symbol.replace('\u{b0}', "deg").replace('%', "percent");
    let found = units(own).find(|unit| dimension.symbol(*unit) == wanted);
    found.ok_or_else(|| {
        format!(
            "`{symbol}` is no unit of `{name}` here; convert the column and write `{name} [{usual}]`"
        )
    })
}
