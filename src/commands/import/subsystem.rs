//! Subsystem files of Adams/Car: blocks of hardpoints, parameters and units.

use super::hardpoints::Hardpoints;
use super::names::{Names, spelled};
use super::row::{Row, lines, unit};
use super::table::add;
use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::Axes;

/// Whether a text is such a file.
pub(super) fn is_subsystem(text: &str) -> bool {
    lines(text).any(|(_, line)| ["[MDI_HEADER]", "[HARDPOINT]"].contains(&line))
}

/// Reads a subsystem file.
///
/// # Errors
///
/// [`Failure::Input`] at a known point without three numbers, and at a unit of length that is none of ours.
pub(super) fn read<'a>(source: &'a Source, names: &Names) -> Result<Hardpoints<'a>, Failure> {
    let mut stated = Hardpoints::new(source, Axes::Adams);
    let mut block = "";
    for (place, line) in lines(source.text()) {
        if line.starts_with('[') {
            block = line;
            continue;
        }
        match block {
            "[HARDPOINT]" | "[PARAMETER]" => add(&mut stated, &Row::of(place, line), names)?,
            "[UNITS]" => {
                let words = spelled(line);
                match words.split_once('_') {
                    Some(("length", length)) => {
                        let known = unit(length).ok_or_else(|| {
                            let message =
                                format!("lengths in `{length}`: convert them to mm, m or in");
                            source.refuse(&place, message)
                        })?;
                        stated.unit = Some(known);
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
