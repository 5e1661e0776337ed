//! Rows with known names whose numbers can be read in several ways: they are refused.

use super::hardpoints::Hardpoints;
use super::names::{Names, key_of, spelled};
use super::row::Row;
use crate::failure::Failure;
use crate::side::{Section, Sides};

const LONE_SIGN: &str = "the sign before the number stands alone: write it at the number, or leave it out if it is a dash";

const IN_PARENTHESES: &str = "a number stands in parentheses: write it with a minus if that is meant, or without parentheses";

const EMPTY: &str = "a cell between the numbers is empty: write the coordinate there, or take the empty column out of the table";

const FRONT_OR_RIGHT: &str = "beside `F`, an `R` may be rear or right: write `Front` and `Rear`, or the corners as FL, FR, RL, RR";

/// Checks a row with a known name.
///
/// # Errors
///
/// [`Failure::Input`] at a sign apart from its number, a number in parentheses, an empty cell between the coordinates of a
/// point, and a letter that names an axle.
pub(super) fn check_row(
    stated: &Hardpoints<'_>,
    row: &Row<'_>,
    is_point: bool,
) -> Result<(), Failure> {
    let refuse = |message: &str| Err(stated.source.refuse(&row.place, message));
    if row.has_lone_sign() {
        return refuse(LONE_SIGN);
    }
    if row.has_number_in_parentheses {
        return refuse(IN_PARENTHESES);
    }
    if row.has_empty_coordinate && is_point {
        return refuse(EMPTY);
    }
    if row.has_field("f") {
        return refuse(FRONT_OR_RIGHT);
    }
    Ok(())
}

/// Checks that a row with a single point says to which of several groups of columns, such as `Front` and `Rear`, it belongs. A
/// point in the middle of the vehicle is of both sides.
///
/// # Errors
///
/// [`Failure::Input`] if the row does not say it.
pub(super) fn check_group(
    stated: &Hardpoints<'_>,
    row: &Row<'_>,
    (name, y): (&str, f64),
) -> Result<(), Failure> {
    let [one, others @ ..] = stated.groups.as_slice() else {
        return Ok(());
    };
    let Some(other) = others.last() else {
        return Ok(());
    };
    let has_side = row.sides() != Sides::Unsaid || key_of(name).1 != Sides::Unsaid;
    let has_side = has_side || stated.section.side.is_some() || y == 0.0;
    let is_clear = (others.iter().all(|group| group.end == one.end)
        || stated.section.end.is_some())
        && (others.iter().all(|group| group.side == one.side) || has_side);
    if is_clear {
        return Ok(());
    }
    let message = format!(
        "`{name}` has the coordinates of one point under {} groups of columns: say in the row which it is, for example `{}`",
        if others.len() == 1 { "two" } else { "several" },
        in_words(*other)
    );
    Err(stated.source.refuse(&row.place, &message))
}

fn in_words(section: Section) -> String {
    let (end, side) = (
        section.end.map(|end| end.name()),
        section.side.map(|side| side.name()),
    );
    let words: Vec<&str> = end.into_iter().chain(side).collect();
    words.join(" ")
}

/// Words of an angle that is not that of one wheel in degrees; an apostrophe behind a number stands for minutes.
const NOT_DEGREES: [&str; 18] = [
    "min",
    "minutes",
    "minuten",
    "winkelminuten",
    "minuti",
    "primi",
    "minutos",
    "arcmin",
    "'",
    "rad",
    "mrad",
    "radians",
    "total",
    "gesamtspur",
    "mm",
    "cm",
    "inch",
    "inches",
];

/// Words beside each other of an angle that is that of both wheels.
const OF_BOTH: [&str; 2] = ["per_axle", "pro_achse"];

/// The word of a toe angle that is positive for toe-out.
const TOE_OUT: &str = "out";

/// Checks that toe and camber are those of one wheel, in degrees, and that toe is not toe-out.
///
/// # Errors
///
/// [`Failure::Input`] if the line of the number says otherwise.
pub(super) fn check_angle(
    stated: &Hardpoints<'_>,
    (row, line): (&Row<'_>, &str),
    name: &str,
    names: &Names,
) -> Result<(), Failure> {
    let (key, _) = key_of(name);
    let [is_toe, is_camber] = ["toe", "camber"].map(|angle| names.is_of_number(angle, &key));
    if !(is_toe || is_camber) || !row.has_digits() {
        return Ok(());
    }
    let said = spelled(line);
    let minutes = has_minutes(line).then_some("'");
    let of_both = OF_BOTH.into_iter().find(|both| said.contains(both));
    let mut words = said.split('_').chain(minutes).chain(of_both);
    let is_other = |word: &&str| {
        NOT_DEGREES.contains(word) || OF_BOTH.contains(word) || is_toe && *word == TOE_OUT
    };
    words.find(is_other).map_or(Ok(()), |word| {
        let or_limit = if word == "min" { ", for minutes or a limit" } else { "" };
        let word = word.replace('_', " ");
        let message = format!(
            "`{name}` says `{word}`{or_limit}: write the angle of one wheel in degrees, positive for toe-in and for a top that leans outboard"
        );
        Err(stated.source.refuse(&row.place, &message))
    })
}

/// Returns whether an apostrophe stands behind a number, and not at the end of a field in quotes.
fn has_minutes(line: &str) -> bool {
    let mut apostrophes = line.match_indices('\'');
    let is_quoted = line.matches('\'').count().is_multiple_of(2);
    !is_quoted && apostrophes.any(|(at, _)| line[..at].ends_with(|c: char| c.is_ascii_digit()))
}
