//! Headings of tables: the axle and side of the rows below, the unit of lengths, the order of columns.

use crate::mechanism::Length;
use crate::side::{End, Section, Side, end_of};

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

/// Words in a remark on where coordinates are measured from, such as `x from the rear axle`, before those of the place.
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
    let words: Vec<&str> = words.split('_').collect();
    let origin = words.iter().position(|word| OF_ORIGIN.contains(word));
    let before = &words[..origin.unwrap_or(words.len())];
    let end = end_of(&before.join("_"))?;
    let is_of_axle = before.iter().any(|word| OF_AXLE.contains(word));
    (is_of_axle || words.len() == 1).then_some(end)
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

/// Returns the units in the headings of columns, in a line of units, or in a remark on units.
pub(super) fn units_of_heading<'a>(words: &[&'a str]) -> Vec<&'a str> {
    let said = |word: &str| words.contains(&word);
    let of_columns = said("x") && said("y") && said("z");
    let of_units = words.iter().all(|word| is_unit(word));
    let remarked = OF_LENGTHS.iter().any(|word| said(word));
    if !(of_columns || of_units || remarked) {
        return Vec::new();
    }
    let places = (0..words.len()).filter(|place| {
        let may_be_a_word = ["in", "m"].contains(&words[*place]) && !of_units;
        is_unit(words[*place]) && (!may_be_a_word || is_certain_unit(words, *place))
    });
    places.map(|place| words[place]).collect()
}

/// Returns whether `in` or `m` is a unit in its place: at the end, between axes (`x in, y in, z in`), and behind words of units.
/// It is none in `Coordinates in x, y, z` and `Hardpoints by M. Smith`.
fn is_certain_unit(words: &[&str], place: usize) -> bool {
    let (before, behind) = (words[..place].last(), words.get(place + 1));
    let is = |word: Option<&&str>, of: &[&str]| word.is_some_and(|word| of.contains(word));
    let is_between_axes = is(before, &["x", "y"]) && is(behind, &["y", "z"]);
    let is_behind_units = is(before, &["in", "unit", "units", "einheit", "einheiten"]);
    behind.is_none() || is(behind, &["in", "deg"]) || is_between_axes || is_behind_units
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
        format!("lengths are in `{word}`; convert them to mm, m or in, and say so here")
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
