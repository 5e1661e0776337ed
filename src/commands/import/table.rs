//! Tables of points: a name and three numbers in each line, with headings and remarks between them.

use super::hardpoints::Hardpoints;
use super::heading::{
    check_columns, column_groups, end_of_heading, length, side_of_heading, unit, unit_of_heading,
};
use super::names::{Names, key_of, spelled};
use super::row::{Row, is_unit_or_side, lines};
use super::row_name::name_of;
use super::side::Section;
use super::thousands::Thousands;
use super::unclear::{check_angle, check_group, check_row};
use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::Axes;

/// Reads a table.
///
/// # Errors
///
/// [`Failure::Input`] at a known point without three numbers, and at columns in another order.
pub(super) fn read<'a>(source: &'a Source, names: &Names) -> Result<Hardpoints<'a>, Failure> {
    let mut stated = Hardpoints::new(source, Axes::Iso);
    let mut section = Section::default();
    let mut heading = String::new();
    let mut thousands = Thousands::default();
    for (place, line) in lines(source.text()) {
        let named = with_whole_name(line, names);
        let row = Row::parse(place.clone(), &named);
        stated.section = Section {
            end: row.end().or(section.end),
            ..section
        };
        let name = name_of(&row, &heading, names);
        check_angle(&stated, (&row, line), &name, names)?;
        add(&mut stated, &row, &name, names)?;
        if names.is_point(&key_of(&name).0) {
            thousands.add(&row);
        }
        stated.add_end(row.end(), place.clone());
        if row.numbers().is_empty() {
            let words = spelled(line);
            let end = end_of_heading(&words);
            stated.add_end(end, place.clone());
            let words: Vec<&str> = words.split('_').collect();
            let side = side_of_heading(&words);
            section = section.below(end.or(row.end()), side);
            stated.groups = column_groups(&words).or(stated.groups);
            heading = match (end, side) {
                (None, None) => row.heading().unwrap_or(heading),
                _ => String::new(),
            };
            check_columns(&words).map_err(|message| source.refuse(&place, message))?;
            if let Some(unit) = unit_of_heading(&words) {
                stated.state_unit(unit, &place)?;
            }
        }
    }
    thousands.check(source)?;
    if stated
        .points
        .iter()
        .any(|point| point.name.to_lowercase().starts_with("hp"))
    {
        stated.usual = Axes::Adams;
    }
    Ok(stated)
}

/// Returns a line without parentheses around words. The words are part of the name if it is then known, as in `Tie rod
/// (inner)`; else they are a remark, as in `Wheel centre (WC)`, or the name itself.
fn with_whole_name(line: &str, names: &Names) -> String {
    let joined = replace_words_in_parentheses(line, |words| format!(" {words}"));
    let remarked = replace_words_in_parentheses(line, |_| String::new());
    let mut readings = vec![joined, remarked, line.to_owned()];
    let is_known = |line: &String| {
        let (key, _) = key_of(&Row::parse(0..0, line).name());
        names.is_point(&key) || names.is_number(&key)
    };
    let known = readings.iter().position(is_known);
    readings.swap_remove(known.unwrap_or_default())
}

/// Replaces words in parentheses, with the parentheses. Numbers, units and sides in parentheses stay as they are.
fn replace_words_in_parentheses(line: &str, by: impl Fn(&str) -> String) -> String {
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

/// Adds the point or the number of a row under a name; skips other rows.
///
/// # Errors
///
/// [`Failure::Input`] at a known point without three numbers, at an angle or radius that cannot be read, and at a sign apart
/// from its number or a number in parentheses.
pub(super) fn add(
    stated: &mut Hardpoints<'_>,
    row: &Row<'_>,
    name: &str,
    names: &Names,
) -> Result<(), Failure> {
    let (key, _) = key_of(name);
    let places = placed(row, stated.groups);
    if places.is_empty()
        && let Some(name) = before_numbers(&row.spelled(), names)
    {
        return Err(misread(stated, name, row, names));
    }
    if names.is_point(&key) || names.is_number(&key) {
        check_row(stated, row)?;
    }
    if names.is_point(&key) && !places.is_empty() {
        if let Some(unit) = row.unit {
            stated.state_unit(unit, &row.place)?;
        }
        if let [(_, [_, y, _])] = places[..] {
            check_group(stated, row, (name, y))?;
        }
    }
    match row.numbers()[..] {
        _ if !places.is_empty() && !key.is_empty() => {
            let section = stated.section;
            for (group, at) in places {
                stated.section = group.or(section);
                stated.add_point(name, row.sides(), at, row.place.clone());
            }
            stated.section = section;
        }
        _ if names.is_number(&key) && row.has_digits() => match row.numbers_behind_name()[..] {
            [value] => {
                let unit = row.unit.map(length).transpose();
                let unit = unit.map_err(|message| stated.source.refuse(&row.place, message))?;
                stated.add_number(name, row.sides(), (value, unit), row.place.clone());
            }
            _ => return Err(misread(stated, name, row, names)),
        },
        _ if names.is_point(&key) && row.begins_a_number() => {
            return Err(misread(stated, name, row, names));
        }
        [_] => {
            let meant = names.number_meant(&key);
            let place = stated.line(&row.place);
            let said =
                meant.map(|meant| format!("`{name}` ({place}) is not used: did you mean {meant}?"));
            stated.unread.extend(said);
        }
        _ => {}
    }
    Ok(())
}

/// Returns the coordinates of a row's points with their corners.
fn placed(row: &Row<'_>, groups: Option<[Section; 2]>) -> Vec<(Section, [f64; 3])> {
    match (&row.places()[..], groups) {
        ([at], _) => vec![(Section::default(), *at)],
        ([one, other], Some([of_one, of_other])) => vec![(of_one, *one), (of_other, *other)],
        _ => Vec::new(),
    }
}

/// Returns the mistake of a row with a known name: what the row should have.
fn misread(stated: &Hardpoints<'_>, name: &str, row: &Row<'_>, names: &Names) -> Failure {
    let message = if names.is_number(&key_of(name).0) {
        format!("`{name}` needs one number after it, with a decimal point")
    } else if row.numbers_behind_name().len() == 6 {
        format!(
            "point `{name}` has six numbers: say in a heading above the columns which are `Left` and which `Right` (or `Front`, \
             `Rear`), or give each a row of its own"
        )
    } else {
        format!(
            "point `{name}` needs three numbers in a row: x, y, z, with decimal points and no sign for thousands"
        )
    };
    stated.source.refuse(&row.place, message)
}

/// Returns a known name at the start of a row's words if nothing but numbers, at least two, with axes and units follow it: a
/// row that cannot be read, for example with decimal commas between blanks.
fn before_numbers<'a>(words: &'a str, names: &Names) -> Option<&'a str> {
    let has_digit = |word: &&str| word.contains(|c: char| c.is_ascii_digit());
    let is_said = |word: &str| ["x", "y", "z"].contains(&word) || unit(word).is_some();
    let ends = words.match_indices('_').map(|(end, _)| end);
    ends.filter_map(|end| {
        let (name, behind) = (&words[..end], &words[end + 1..]);
        let numbers = behind.split('_').filter(has_digit).count();
        let is_numbers = behind
            .split('_')
            .all(|word| has_digit(&word) || is_said(word));
        let (key, _) = key_of(name);
        let is_known = names.is_number(&key) || names.is_point(&key);
        (is_known && is_numbers && numbers > 1).then_some(name)
    })
    .next_back()
}
