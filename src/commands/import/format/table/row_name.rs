//! The name of a row, of which parentheses, a column before it, or the heading above it may have a part.

use crate::commands::import::format::heading::{end_of_heading, section_of_heading};
use crate::commands::import::format::row::Row;
use crate::commands::import::length_units::unit;
use crate::commands::import::names::Names;
use crate::commands::import::spelling::{is_on_ground, key_of, spelled};
use crate::vehicle_corner::{Section, sides_of};

/// Returns the name of a row: together with the columns before it, as in `Tie rod, inner`, or with the `heading` above it,
/// if that is known, or else its own.
pub(super) fn name_of(row: &Row<'_>, heading: &str, names: &Names) -> String {
    let own = row.name();
    let is_point = !row.places().is_empty();
    let mut columns = row.columns_before_numbers();
    let last = columns.pop();
    // A column such as `Rear` is of the axle.
    columns.retain(|column| end_of_heading(&spelled(column)).is_none());
    let others = columns.len();
    columns.extend(last);
    let joined = (0..others).map(|from| columns[from..].join(" "));
    let headed = (!heading.is_empty()).then(|| format!("{heading} {own}").trim_end().to_owned());
    let mut readings = joined.chain(headed);
    let is_known = |key: &str| match is_point {
        true => names.is_point(key),
        false => names.is_number(key),
    };
    let own_form = names.normal(&key_of(&own).0);
    let known = readings.find(|name| {
        let (key, _) = key_of(name);
        // A heading such as `Point` adds nothing.
        is_known(&key) && names.normal(&key) != own_form
    });
    known.unwrap_or(own)
}

/// Returns a line without parentheses around words. The words are part of the name if it is then known, as in `Tie rod
/// (inner)`; else they are a remark, as in `Wheel centre (WC)`, or the name itself. A remark may state a corner; one on
/// the ground names another point.
pub(super) fn with_whole_name(line: &str, names: &Names) -> (String, Section) {
    if !line.contains('(') {
        return (line.to_owned(), Section::default());
    }
    let joined = replace_words_in_parentheses(line, |words| format!(" {words}"));
    let mut section = Section::default();
    let remarked = replace_words_in_parentheses(line, |words| {
        let remark = spelled(words);
        if is_on_ground(&remark) {
            return format!(" {words}");
        }
        section = section_of_heading(&names.heading_in_english(&remark)).or(section);
        String::new()
    });
    let unsaid = Section::default();
    let readings = [
        (&joined, unsaid),
        (&remarked, section),
        (&line.to_owned(), unsaid),
    ];
    let is_known = |(line, _): &(&String, Section)| {
        let (key, _) = key_of(&Row::parse(0..0, line).name());
        names.is_point(&key) || names.is_number(&key)
    };
    let known = readings.into_iter().find(is_known);
    let (line, section) = known.unwrap_or((&joined, unsaid));
    (line.clone(), section)
}

/// Replaces words in parentheses, with the parentheses. Numbers, units and sides in parentheses stay as they are.
fn replace_words_in_parentheses(line: &str, mut by: impl FnMut(&str) -> String) -> String {
    let (mut text, mut rest) = (String::new(), line);
    while let Some((before, (inside, behind))) = rest
        .split_once('(')
        .and_then(|(before, behind)| Some((before, behind.split_once(')')?)))
    {
        if inside.starts_with(char::is_alphabetic) && !is_unit_or_side(inside) {
            text += before.trim_end_matches(' ');
            text += &by(inside);
        } else {
            text += &format!("{before}({inside})");
        }
        rest = behind;
    }
    text + rest
}

/// Returns whether a word states a unit or a side.
fn is_unit_or_side(word: &str) -> bool {
    unit(word).is_some() || sides_of(word).is_some()
}
