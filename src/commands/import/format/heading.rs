//! Headings of tables: the axle and side of the rows below, the unit of lengths, the order of columns.

use crate::commands::import::length_units::{is_unit, unit};
use crate::commands::import::spelling::is_one_of;
use crate::vehicle_corner::{End, Section, Side, end_of};

/// Words of a suspension in headings.
const OF_SUSPENSION: [&str; 5] = ["suspension", "axle", "corner", "hardpoints", "geometry"];

/// Words of a side in headings.
const OF_SIDE: [&str; 6] = ["left", "right", "lh", "rh", "lhs", "rhs"];

/// Words in a remark on where coordinates are measured from, such as `x from the rear axle`, or where they count to, such as `x
/// to rear`, before those of the place.
const OF_ORIGIN: &str = "origin at from datum reference relative behind ahead zero to towards nach";

/// Returns the end of the vehicle in the heading of a table, such as `Rear suspension`, `REAR LEFT` or `Rear`. A heading such as
/// `Front lower wishbone` is of a part.
pub(super) fn end_of_heading(words: &str) -> Option<End> {
    let words: Vec<&str> = words.split('_').collect();
    let before = before_origin(&words);
    let end = end_of(&before.join("_"))?;
    let is_of_axle = before.iter().any(|word| is_of_axle(word));
    (is_of_axle || words.len() == 1).then_some(end)
}

/// Returns the words of a heading before a remark on the origin.
fn before_origin<'a, 'w>(words: &'a [&'w str]) -> &'a [&'w str] {
    let origin = words.iter().position(|word| is_one_of(word, OF_ORIGIN));
    &words[..origin.unwrap_or(words.len())]
}

/// Returns whether a word of a heading says that it is of an axle or a corner.
fn is_of_axle(word: &str) -> bool {
    OF_SUSPENSION.contains(&word) || OF_SIDE.contains(&word)
}

/// Words of a heading above groups of columns, beside those of corners, axes and units.
const OF_COLUMNS: &str = "\
    point points name hardpoint hardpoints side hand wheel corner axle suspension mass kg remark remarks comment comments";

/// Returns the words of a heading with the axis of a column apart from its corner: `x_l` for `xl`.
pub(super) fn with_axes_apart(words: &str) -> String {
    let apart = words.split('_').map(|word| {
        let corner = word.strip_prefix(['x', 'y', 'z']);
        let corner = corner.filter(|corner| group_of_word(corner).is_some());
        corner.map_or(word.to_owned(), |corner| format!("{}_{corner}", &word[..1]))
    });
    apart.collect::<Vec<_>>().join("_")
}

/// Returns what a word above columns says of their corner; there a letter is a side.
fn group_of_word(word: &str) -> Option<Section> {
    let side = match word {
        "l" => Side::Left,
        "r" => Side::Right,
        _ => return Section::of_word(word),
    };
    Some(Section::default().below(None, Some(side)))
}

/// Returns the corners of groups of columns, such as `Left` and `Right`, `Front x, y, z` and `Rear x, y, z`, or the four corners.
/// The groups `above` may each stand over several, as `Front` and `Rear` over `Left`, `Right`, `Left`, `Right`.
pub(super) fn column_groups(words: &[&str], above: &[Section]) -> Option<Vec<Section>> {
    let is_other = |word: &&str| {
        let is_axis = ["x", "y", "z"].contains(word);
        is_axis || is_one_of(word, OF_COLUMNS) || unit(word).is_some()
    };
    let corners = words.iter().filter(|word| !is_other(word));
    let said: Option<Vec<Section>> = corners.map(|word| group_of_word(word)).collect();
    let mut said = said?;
    said.dedup();
    let mut groups: Vec<Section> = Vec::new();
    for word in said {
        match groups.last_mut() {
            Some(last) if last.lacks(word) => *last = last.or(word),
            _ => groups.push(word),
        }
    }
    groups.dedup();
    if groups.len() == 2 * above.len() {
        let each = groups.iter().enumerate();
        groups = each.map(|(at, group)| group.or(above[at / 2])).collect();
    }
    (groups.len() > 1).then_some(groups)
}

/// Returns the side of the vehicle in a heading that has no words but those of axles and sides, such as `FRONT LEFT` or `RL
/// corner`, or in a title of an axle with the side beside it, such as `Front left suspension of car 7`.
pub(super) fn side_of_heading(words: &[&str]) -> Option<Side> {
    let is_of_corner = |word: &&str| {
        let is_other = ["side", "hand", "wheel", "points", "coordinates"].contains(word)
            || unit(word).is_some();
        is_of_axle(word) || Section::of_word(word).is_some() || is_other
    };
    let mut sides: Vec<Side> = if words.iter().all(is_of_corner) {
        let sides = words.iter().filter_map(|word| Section::of_word(word)?.side);
        sides.collect()
    } else {
        sides_beside_ends(before_origin(words))
    };
    sides.dedup();
    match sides[..] {
        [side] => Some(side),
        _ => None,
    }
}

/// Returns the sides in the words of a suspension, such as `front left`, `left front`, `FL` and `rear axle, right`.
fn sides_beside_ends(words: &[&str]) -> Vec<Side> {
    let others = words.iter().filter(|word| !OF_SUSPENSION.contains(word));
    let said = others.map(|word| Section::of_word(word).unwrap_or_default());
    let said: Vec<Section> = said.collect();
    let is_of_axle = words.iter().any(|word| is_of_axle(word));
    let sides = (0..said.len()).filter_map(|place| {
        let beside = &said[place.saturating_sub(1)..said.len().min(place + 2)];
        let has_end = beside.iter().any(|section| section.end.is_some());
        said[place].side.filter(|_| is_of_axle && has_end)
    });
    sides.collect()
}

/// Returns the corner that a heading or remark states.
pub(super) fn section_of_heading(words: &str) -> Section {
    let each: Vec<&str> = words.split('_').collect();
    Section {
        end: end_of_heading(words),
        side: side_of_heading(&each),
    }
}

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
const OF_LENGTHS: &str = "\
    unit units einheit einheiten angaben maße werte length lengths dimensions coordinates values point points hardpoint \
    hardpoints";

/// Returns the units in the headings of columns, in a line of units, or in a remark on units.
pub(super) fn units_of_heading<'a>(words: &[&'a str]) -> Vec<&'a str> {
    let said = |word: &str| words.contains(&word);
    let of_columns = said("x") && said("y") && said("z");
    let of_units = words.iter().all(|word| is_unit(word));
    let remarked = words.iter().any(|word| is_one_of(word, OF_LENGTHS));
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
