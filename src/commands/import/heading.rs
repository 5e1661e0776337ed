//! Headings of tables: the axle and side of the rows below, the unit of lengths, the order of columns.

use super::side::{End, Section, Side, end_of};
use crate::mechanism::Length;

/// Words of a heading that names the end of the vehicle to which a suspension belongs.
const OF_AXLE: [&str; 11] = [
    "suspension",
    "axle",
    "corner",
    "hardpoints",
    "geometry",
    "left",
    "right",
    "lh",
    "rh",
    "lhs",
    "rhs",
];

/// Words of a remark on where coordinates are measured from, such as `x from the rear axle`.
const OF_ORIGIN: [&str; 9] = [
    "origin",
    "at",
    "from",
    "datum",
    "reference",
    "relative",
    "behind",
    "ahead",
    "zero",
];

/// Returns the end of the vehicle in the heading of a table, such as `Rear suspension`, `REAR LEFT` or `Rear`. A heading such as
/// `Front lower wishbone` is of a part.
pub(super) fn end_of_heading(words: &str) -> Option<End> {
    let end = end_of(words)?;
    let has_any = |of: &[&str]| words.split('_').any(|word| of.contains(&word));
    let is_of_axle = has_any(&OF_AXLE) && !has_any(&OF_ORIGIN);
    (is_of_axle || !words.contains('_')).then_some(end)
}

/// Words of a heading above groups of columns, beside those of corners, axes and units.
const OF_COLUMNS: [&str; 11] = [
    "point",
    "points",
    "name",
    "hardpoint",
    "hardpoints",
    "side",
    "hand",
    "wheel",
    "corner",
    "axle",
    "suspension",
];

/// Returns the corners of two groups of columns, such as `Left` and `Right`, or `Front x, y, z` and `Rear x, y, z`.
pub(super) fn column_groups(words: &[&str]) -> Option<[Section; 2]> {
    let is_other = |word: &&str| {
        let is_axis = ["x", "y", "z"].contains(word);
        is_axis || OF_COLUMNS.contains(word) || unit(word).is_some()
    };
    let corners = words.iter().filter(|word| !is_other(word));
    let groups: Option<Vec<Section>> = corners.map(|word| Section::of_word(word)).collect();
    let mut groups = groups?;
    groups.dedup();
    groups.try_into().ok()
}

/// Returns the side of the vehicle in a heading that has no words but those of axles and sides, such as `FRONT LEFT` or `RL
/// corner`.
pub(super) fn side_of_heading(words: &[&str]) -> Option<Side> {
    let is_of_corner = |word: &&str| {
        let is_other = ["side", "hand", "wheel", "points", "coordinates"].contains(word)
            || unit(word).is_some();
        OF_AXLE.contains(word) || Section::of_word(word).is_some() || is_other
    };
    if !words.iter().all(is_of_corner) {
        return None;
    }
    let sides = words.iter().filter_map(|word| Section::of_word(word)?.side);
    let mut sides: Vec<Side> = sides.collect();
    sides.dedup();
    match sides[..] {
        [side] => Some(side),
        _ => None,
    }
}

/// Returns the corner that a heading or remark states.
pub(super) fn section_of_heading(words: &str) -> Section {
    let each: Vec<&str> = words.split('_').collect();
    Section {
        end: end_of_heading(words),
        side: side_of_heading(&each),
    }
}

/// Units of length that motion files do not have.
const OTHER_UNITS: [&str; 10] = [
    "cm",
    "centimeter",
    "centimetre",
    "centimeters",
    "centimetres",
    "dm",
    "km",
    "ft",
    "foot",
    "feet",
];

/// Checks that the columns are x, y, z in this order.
pub(super) fn check_columns(words: &[&str]) -> Result<(), String> {
    let columns = words.iter().filter(|word| ["x", "y", "z"].contains(word));
    let columns: Vec<&str> = columns.copied().collect();
    let is_heading = ["x", "y", "z"].iter().all(|axis| columns.contains(axis));
    if is_heading && columns[..3] != ["x", "y", "z"] {
        let found = columns.join(", ");
        return Err(format!(
            "the columns are {found}; put them in the order x, y, z"
        ));
    }
    Ok(())
}

/// Words of a remark on the unit of lengths.
const OF_LENGTHS: [&str; 13] = [
    "unit",
    "units",
    "einheit",
    "einheiten",
    "length",
    "lengths",
    "dimensions",
    "coordinates",
    "values",
    "point",
    "points",
    "hardpoint",
    "hardpoints",
];

/// Returns the unit in the headings of columns, in a line of units, or in a remark on units.
pub(super) fn unit_of_heading<'a>(words: &[&'a str]) -> Option<&'a str> {
    let said = |word: &str| words.contains(&word);
    let of_columns = said("x") && said("y") && said("z");
    let of_units = words.iter().all(|word| is_unit(word));
    let remarked = OF_LENGTHS.iter().any(|word| said(word));
    if !(of_columns || of_units || remarked) {
        return None;
    }
    let units = words.iter().enumerate().filter(|(place, word)| {
        // `in` may be a word instead of the inch: `x, y, z in the frame of the vehicle`.
        let behind = words.get(place + 1);
        let is_inch = behind.is_none_or(|word| ["x", "y", "z", "in", "deg"].contains(word));
        is_unit(word) && (**word != "in" || is_inch)
    });
    let mut units = units.map(|(_, word)| *word);
    units.next()
}

/// Returns whether a word names a unit of length.
pub(super) fn is_unit(word: &str) -> bool {
    unit(word).is_some() || OTHER_UNITS.contains(&word)
}

/// Returns the unit of length that a word names.
///
/// # Errors
///
/// A sentence, if motion files do not have the unit.
pub(super) fn length(word: &str) -> Result<Length, String> {
    unit(word).ok_or_else(|| {
        format!("lengths are in {word}; convert them to mm, m or in, and say so here")
    })
}

/// Returns the unit of motion files that a word names.
pub(super) fn unit(word: &str) -> Option<Length> {
    match word {
        "mm" | "millimeter" | "millimetre" | "millimeters" | "millimetres" => {
            Some(Length::Millimetre)
        }
        "m" | "meter" | "metre" | "meters" | "metres" => Some(Length::Metre),
        "in" | "inch" | "inches" => Some(Length::Inch),
        _ => None,
    }
}
