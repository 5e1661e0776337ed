//! Rules for motion files beyond their grammar. Each error names its place.

mod drives;
mod instants;

use std::borrow::Borrow;

use suspension_core::model::parts;
use suspension_listing::did_you_mean::did_you_mean;
use toml::Spanned;

use crate::failure::Failure;
use crate::motion_file::MotionFile;
use crate::number::exact;
use crate::place_of_key::place_of_key;
use crate::source::Source;
use crate::tables::entries::Table;
use crate::tables::position::{Offset, Position};

pub use drives::drives;
pub use instants::instants;

/// Checks that a table has an entry for each known name and no other.
///
/// # Errors
///
/// [`Failure::Input`] at the first unknown key, or at the table where a name is missing.
pub fn names<V>(
    source: &Source,
    table: &Table<V>,
    kind: &str,
    known: &[impl Borrow<str>],
) -> Result<(), Failure> {
    let has = format!("the linkage has {}", known.join(", "));
    known_names(source, table, kind, known, &has)?;
    let missing = missing(table, known);
    let message = match missing.as_slice() {
        [] => return Ok(()),
        [name] => format!("{kind} `{name}` is missing"),
        names => format!("{kind}s {} are missing", quoted(names)),
    };
    Err(source.refuse(&table.span(), message))
}

/// Checks that the file names only points of the linkage.
///
/// # Errors
///
/// [`Failure::Input`] at the first unknown point.
pub fn known_points(
    source: &Source,
    file: &MotionFile,
    known: &[impl Borrow<str>],
) -> Result<(), Failure> {
    let all: Vec<&str> = known.iter().map(Borrow::borrow).collect();
    let has = format!("the linkage has {}", all.join(", "));
    known_names(source, &file.points, "point", known, &has)
}

/// Checks that the file names only known points, and that each has a position.
///
/// # Errors
///
/// [`Failure::Input`] at the first unknown name, or at the table where a position is missing.
pub fn point_names(source: &Source, file: &MotionFile, known: &[String]) -> Result<(), Failure> {
    known_points(source, file, known)?;
    let table = &file.points;
    let missing = missing(table, known);
    let (points, first) = match missing.as_slice() {
        [] => return Ok(()),
        [name] => (format!("point `{name}` has"), name),
        [name, ..] => (format!("points {} have", quoted(&missing)), name),
    };
    let in_the_listing = match file.linkage {
        Some(_) => String::new(),
        None => format!("`{first} at [x, y, z]` in the listing, or "),
    };
    let message =
        format!("{points} no position; write {in_the_listing}{first} = [x, y, z] under [points]");
    Err(source.refuse(&table.span(), message))
}

/// Returns the known names for which a table has no entry.
fn missing<'a, V>(table: &Table<V>, known: &'a [impl Borrow<str>]) -> Vec<&'a str> {
    let entries = table.get_ref();
    let known = known.iter().map(Borrow::borrow);
    known.filter(|name| !entries.has(name)).collect()
}

fn quoted(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}

/// Checks that a table has entries only for known names; `has` introduces their list in the message.
///
/// # Errors
///
/// [`Failure::Input`] at each unknown key; only the message on the first lists the known names.
pub fn known_names<V>(
    source: &Source,
    table: &Table<V>,
    kind: &str,
    known: &[impl Borrow<str>],
    has: &str,
) -> Result<(), Failure> {
    let names = table.get_ref().names();
    let unknown = names.filter(|key| known.iter().all(|name| name.borrow() != key.get_ref()));
    let refused = unknown.enumerate().map(|(index, key)| {
        let name = key.get_ref();
        let list = if index == 0 {
            format!("; {has}")
        } else {
            String::new()
        };
        let hint = match place_of_key(name) {
            Some(place) => format!("; {name} belongs {place}"),
            None => did_you_mean(name, known.iter().map(Borrow::borrow)),
        };
        Err(source.refuse(&key.span(), format!("unknown {kind} `{name}`{list}{hint}")))
    });
    Failure::all(refused).map(|_: Vec<()>| ())
}

/// Checks that all values of a table are finite.
///
/// # Errors
///
/// [`Failure::Input`] at each other value.
pub fn finite_values(source: &Source, table: &Table<f64>, kind: &str) -> Result<(), Failure> {
    each(table, |name, value| {
        if value.get_ref().is_finite() {
            return Ok(());
        }
        let message = format!("{kind} `{name}` is not a finite number");
        Err(source.refuse(&value.span(), message))
    })
}

/// The mistakes in all entries of a table.
fn each<'a, V>(
    table: &'a Table<V>,
    mut check: impl FnMut(&'a str, &'a Spanned<V>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let entries = table.get_ref().iter();
    let checks = entries.map(|(name, value)| check(name.get_ref(), value));
    Failure::all(checks).map(drop)
}

/// Checks that the lengths are positive, finite and of a size with which the program can compute.
///
/// # Errors
///
/// [`Failure::Input`] at each length that is not.
pub fn lengths(source: &Source, table: &Table<f64>) -> Result<(), Failure> {
    each(table, |name, value| {
        let length = *value.get_ref();
        let fault = if !(length > 0.0 && length.is_finite()) {
            "not a positive finite number"
        } else if parts::positive([length]).is_ok() {
            return Ok(());
        } else if length > 1.0 {
            "too large to compute with"
        } else {
            "too small to compute with"
        };
        let message = format!("length `{name}` is {}, {fault}", exact(length));
        Err(source.refuse(&value.span(), message))
    })
}

/// Checks the points: their coordinates are finite, no two chassis or free points coincide unless they are `unjoined`, and
/// only `markers` are stated relative to another point, which has coordinates.
///
/// # Errors
///
/// [`Failure::Input`] at each point that breaks a rule.
pub fn points(
    source: &Source,
    file: &MotionFile,
    markers: &[String],
    unjoined: &[&str],
) -> Result<(), Failure> {
    let is_marker = |name: &str| markers.iter().any(|marker| marker == name);
    let mut placed: Vec<(&str, [f64; 3])> = Vec::new();
    each(&file.points, |name, position| {
        let refuse = |message: String| Err(source.refuse(&position.span(), message));
        let numbers = match position.get_ref() {
            Position::At(at) => at,
            Position::Off(Offset { offset, .. }) => offset.get_ref(),
        };
        if numbers.iter().any(|number| !number.is_finite()) {
            return refuse(format!(
                "point `{name}` has a coordinate that is not a finite number"
            ));
        }
        match position.get_ref() {
            Position::Off(off) => {
                if !is_marker(name) {
                    return refuse(format!(
                        "point `{name}` is not a marker and needs coordinates [x, y, z]"
                    ));
                }
                base_of_marker(source, file, &off.from)?;
            }
            Position::At(at) if !is_marker(name) && !unjoined.contains(&name) => {
                if let Some((other, _)) = placed.iter().find(|(_, place)| place == at) {
                    return refuse(in_one_place(name, other));
                }
                placed.push((name, *at));
            }
            Position::At(_) => {}
        }
        Ok(())
    })
}

/// The message on two joints in one place.
pub fn in_one_place(name: &str, other: &str) -> String {
    format!(
        "point `{name}` is in the same place as point `{other}`; correct one of them, or, if they are one joint, state one point \
         and name it in the statements of both"
    )
}

fn base_of_marker(
    source: &Source,
    file: &MotionFile,
    from: &Spanned<String>,
) -> Result<(), Failure> {
    let base = from.get_ref();
    match file
        .points
        .get_ref()
        .get(base.as_str())
        .map(Spanned::get_ref)
    {
        Some(Position::At(_)) => Ok(()),
        Some(Position::Off(_)) => Err(source.refuse(
            &from.span(),
            format!("point `{base}` is itself placed relative to another point"),
        )),
        None => {
            let names = file.points.get_ref().names();
            let hint = did_you_mean(base, names.map(|name| name.get_ref().as_str()));
            let message = format!("there is no point `{base}`{hint}");
            Err(source.refuse(&from.span(), message))
        }
    }
}
