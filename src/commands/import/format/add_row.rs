//! The point or the number that a row of a table has.

use super::ambiguous_rows::{check_group, check_row};
use super::row::Row;
use crate::commands::import::hardpoints::{Hardpoints, UnknownNumber};
use crate::commands::import::length_units::{length, unit};
use crate::commands::import::names::Names;
use crate::commands::import::spelling::key_of;
use crate::decimals::MINUS;
use crate::failure::Failure;
use crate::vehicle_corner::Section;

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
    if let Some(name) = row.of_mistyped_group() {
        return Err(misread(stated, name, row, names));
    }
    let (key, _) = key_of(name);
    let (is_point, is_number) = (names.is_point(&key), names.is_number(&key));
    if is_point || is_number {
        check_row(stated, row, is_point)?;
    }
    let places = match is_number {
        true => Vec::new(),
        false => placed(row),
    };
    if places.is_empty()
        && !is_number
        && let Some(name) = before_numbers(&row.spelled(), names)
    {
        return Err(misread(stated, name, row, names));
    }
    if is_point && !places.is_empty() {
        for unit in &row.units {
            stated.state_unit(unit, &row.place)?;
        }
        if let [(_, [_, y, _])] = places[..] {
            check_group(stated, row, (name, y))?;
        }
    }
    if !places.is_empty() && !key.is_empty() {
        for (group, at) in places {
            let section = group.or(row.section);
            stated.add_point(section, name, row.sides(), at, row.place.clone());
        }
    } else if is_number && row.has_digits() {
        add_numbers(stated, row, name, names)?;
    } else if is_point && row.begins_a_number() {
        return Err(misread(stated, name, row, names));
    } else if !key.is_empty() && row.ends_with_number() && !row.is_title() {
        stated.unknown_numbers.push(UnknownNumber {
            name: name.to_owned(),
            end: row.section.end,
            place: row.place.clone(),
        });
    }
    Ok(())
}

/// Adds the number of a row with the name of one; under groups of columns also one for each group. A single
/// number is that of its group, or of all of them if it has none.
fn add_numbers(
    stated: &mut Hardpoints<'_>,
    row: &Row<'_>,
    name: &str,
    names: &Names,
) -> Result<(), Failure> {
    let unit = row.units.first().map(|unit| length(unit)).transpose();
    let unit = unit.map_err(|message| stated.source.refuse(&row.place, message))?;
    let values = row.numbers_behind_name();
    let groups = match (values.len(), &row.groups[..]) {
        (1, [] | [_, _, ..]) => vec![Section::default()],
        (_, groups) => groups.to_vec(),
    };
    if values.len() != groups.len() || values.is_empty() {
        return Err(misread(stated, name, row, names));
    }
    for (value, group) in values.into_iter().zip(groups) {
        let section = group.or(row.section);
        stated.add_number(section, name, row.sides(), (value, unit), row.place.clone());
    }
    Ok(())
}

/// Returns the coordinates of a row's points with their corners.
fn placed(row: &Row<'_>) -> Vec<(Section, [f64; 3])> {
    match (&row.places()[..], &row.groups[..]) {
        ([at], [group]) => vec![(*group, *at)],
        ([at], _) => vec![(Section::default(), *at)],
        (places, groups) if places.len() == groups.len() => {
            groups.iter().copied().zip(places.iter().copied()).collect()
        }
        _ => Vec::new(),
    }
}

/// Returns the mistake of a row with a known name: what the row should have.
fn misread(stated: &Hardpoints<'_>, name: &str, row: &Row<'_>, names: &Names) -> Failure {
    let message = if names.is_number(&key_of(name).0) {
        format!("`{name}` needs one number after it, with a decimal point")
    } else if let Some((count, which)) = of_several_points(row) {
        format!(
            "point `{name}` has {count} numbers: say in a heading above the columns which are {which}{}, or give each a row of its own",
            unread_heading(stated).unwrap_or_default()
        )
    } else {
        format!(
            "point `{name}` needs three numbers in a row: x, y, z; {}",
            what_it_has(row)
        )
    };
    stated.source.refuse(&row.place, message)
}

/// Says which field of a row is no number, or how many it has.
fn what_it_has(row: &Row<'_>) -> String {
    match row.misspelt_number() {
        Some(field) => format!("`{field}` is no number{}", why_no_number(field)),
        None => format!("it has {}", row.numbers().len()),
    }
}

/// Says which sign of a mistyped number is probably the mistake; nothing of others, as `46O`.
fn why_no_number(field: &str) -> &'static str {
    let unsigned = field.trim_start_matches(MINUS).trim_start_matches('+');
    if unsigned.len() < field.len() && unsigned.starts_with(char::is_whitespace) {
        " (its sign stands directly before it)"
    } else if field.contains(|c: char| c.is_whitespace() || "'\u{2019}".contains(c)) {
        " (between thousands only a comma or a point may stand)"
    } else {
        ""
    }
}

/// Quotes the heading above the rows that says nothing that import knows.
fn unread_heading(stated: &Hardpoints<'_>) -> Option<String> {
    let place = stated.unread_heading.as_ref()?;
    let heading = stated.source.text().get(place.clone())?.lines().next()?;
    let heading = heading.trim_end_matches([';', ',', '\t', '|', ' ']);
    Some(format!(" (`{heading}` in {} does not)", stated.line(place)))
}

/// Returns the number of numbers of a row and the headings of their columns, in words, if they may be the coordinates of
/// several points.
fn of_several_points(row: &Row<'_>) -> Option<(&'static str, &'static str)> {
    const TWO: &str = "`Left` and which `Right` (or `Front`, `Rear`)";
    const FOUR: &str = "`FL`, `FR`, `RL` and `RR`";
    match row.numbers_behind_name().len() {
        6 => Some(("six", TWO)),
        9 => Some(("nine", FOUR)),
        12 => Some(("twelve", FOUR)),
        _ => None,
    }
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
