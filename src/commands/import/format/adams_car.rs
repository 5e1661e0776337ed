//! Subsystem files of Adams/Car: blocks of hardpoints, parameters and units.

use super::add_row::add;
use super::lines::lines;
use super::row::Row;
use crate::commands::import::hardpoints::Hardpoints;
use crate::commands::import::names::Names;
use crate::commands::import::spelling::spelled;
use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::Axes;
use crate::vehicle_corner::end_of;

/// Returns whether a text is a subsystem file.
pub(super) fn is_subsystem(text: &str) -> bool {
    lines(text).any(|(_, line)| matches!(&*block(line), "MDI_HEADER" | "HARDPOINT"))
}

/// Returns the block that a line begins, in capitals and without the remark after it; an empty text for other lines.
fn block(line: &str) -> String {
    let name = line.strip_prefix('[').and_then(|line| line.split_once(']'));
    name.map_or("", |(name, _)| name.trim()).to_uppercase()
}

/// Reads a subsystem file.
///
/// # Errors
///
/// [`Failure::Input`] at a known point without three numbers, and at a unit of length that motion files do not have.
pub(super) fn read<'a>(source: &'a Source, names: &Names) -> Result<Hardpoints<'a>, Failure> {
    let mut stated = Hardpoints::new(source, Axes::Adams);
    let mut within = String::new();
    for (place, line) in lines(source.text()) {
        if line.starts_with('[') {
            within = block(line);
            continue;
        }
        match &*within {
            "HARDPOINT" | "PARAMETER" => {
                let row = Row::parse(place, line);
                add(&mut stated, &row, &row.name(), names)?;
            }
            "SUBSYSTEM_HEADER" => {
                let words = spelled(line);
                if let Some(role) = words.strip_prefix("minor_role_") {
                    stated.add_end(end_of(role), place);
                }
            }
            "UNITS" => {
                let words = spelled(line);
                match words.split_once('_') {
                    Some(("length", length)) => {
                        stated.state_unit(length, &place)?;
                    }
                    Some(("angle", angle)) => stated.radians = angle.starts_with("rad"),
                    _ => {}
                }
            }
            _ => {}
        }
    }
    Ok(stated)
}
