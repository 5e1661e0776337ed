//! Model files of Lotus Suspension Analysis: the template gives the names of points, the suspension gives their coordinates.
//!
//! The format is not documented; this is its layout in known files. `TEMP_SETTINGS` is followed by a number, the
//! template's name, the numbers of parts and points, the parts' names, and nine lines for each point, its name first.
//! `FRONT SUSPENSION` or `REAR SUSPENSION` is followed by a number, the points' coordinates in the same order, in
//! millimetres, and the tyre's rolling radius.

use super::lines::{Placed, lines};
use super::row::Row;
use crate::commands::import::hardpoints::Hardpoints;
use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::{Axes, Length};
use crate::vehicle_corner::{Section, Sides};

const TEMPLATE: &str = "TEMP_SETTINGS";
const SUSPENSIONS: [&str; 2] = ["FRONT SUSPENSION", "REAR SUSPENSION"];

/// The number of lines for a point in the template, and the line with its coordinates.
const LINES_OF_POINT: usize = 9;
const LINE_OF_COORDINATES: usize = 6;

/// Returns whether a text is a model file of Lotus.
pub(super) fn is_model(source: &Source) -> bool {
    source.name().to_lowercase().ends_with(".shk")
        || lines(source.text()).any(|(_, line)| line == TEMPLATE)
}

/// Reads a model file of one suspension.
///
/// # Errors
///
/// [`Failure::Input`] if the layout of the file is not the expected one: points are never guessed.
pub(super) fn read(source: &Source) -> Result<Hardpoints<'_>, Failure> {
    let lines: Vec<_> = lines(source.text()).collect();
    let found = template(&lines);
    let found = found.and_then(|names| Some((suspension(&lines, names.len())?, names)));
    let Some((suspension, names)) = found else {
        let message = "this is no .shk file of a known layout (TEMP_SETTINGS with the points' names, then one \
                       FRONT SUSPENSION or REAR SUSPENSION with as many coordinates); print the points as text in \
                       Lotus and import that";
        return Err(source.refuse(&(0..0), message));
    };
    let mut stated = Hardpoints::new(source, Axes::Adams);
    stated.unit = Some(Length::Millimetre);
    for (name, (place, at)) in names.iter().zip(suspension.coordinates) {
        stated.add_point(Section::default(), name, Sides::Unsaid, at, place);
    }
    if let Some((place, radius)) = suspension.radius {
        let section = Section::default();
        stated.add_number(
            section,
            "rolling_radius",
            Sides::Unsaid,
            (radius, None),
            place,
        );
    }
    Ok(stated)
}

/// Returns the names of the points, in the order of their coordinates.
fn template<'a>(lines: &[Placed<&'a str>]) -> Option<Vec<&'a str>> {
    let start = lines.iter().position(|(_, line)| *line == TEMPLATE)?;
    let (place, counts) = lines.get(start + 3)?;
    let counts = Row::parse(place.clone(), counts).numbers();
    let [parts, points, ..] = counts.as_slice() else {
        return None;
    };
    let blocks = lines.get((start + 4).saturating_add(*parts as usize)..)?;
    let blocks = blocks.chunks_exact(LINES_OF_POINT).take(*points as usize);
    let name = |block: &[Placed<&'a str>]| {
        let (place, line) = &block[LINE_OF_COORDINATES];
        let (_, name) = block[0];
        Row::parse(place.clone(), line).coordinates().map(|_| name)
    };
    let names: Vec<&str> = blocks.map_while(name).collect();
    (names.len() == *points as usize).then_some(names)
}

/// The numbers of a suspension, each with its place in the file.
struct Suspension {
    coordinates: Vec<Placed<[f64; 3]>>,
    radius: Option<Placed<f64>>,
}

/// Returns the coordinates of `points` points, and the radius that may follow them.
fn suspension(lines: &[Placed<&str>], points: usize) -> Option<Suspension> {
    let mut starts = (0..lines.len()).filter(|&line| SUSPENSIONS.contains(&lines[line].1));
    let (Some(start), None) = (starts.next(), starts.next()) else {
        return None;
    };
    let rows = lines.get(start + 2..)?.iter();
    let mut rows = rows.map(|(place, line)| Row::parse(place.clone(), line));
    let at = |row: Row<'_>| Some((row.place.clone(), row.coordinates()?));
    let coordinates: Vec<_> = rows.by_ref().take(points).map_while(at).collect();
    let radius = rows.next().and_then(|row| match row.numbers().as_slice() {
        [radius] if *radius > 0.0 => Some((row.place, *radius)),
        _ => None,
    });
    (coordinates.len() == points).then_some(Suspension {
        coordinates,
        radius,
    })
}
