//! Rows with known names whose numbers can be read in several ways: they are refused.

use super::row::Row;
use crate::commands::import::hardpoints::Hardpoints;
use crate::commands::import::spelling::key_of;
use crate::failure::Failure;
use crate::vehicle_corner::Sides;

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
    let [one, others @ ..] = row.groups.as_slice() else {
        return Ok(());
    };
    let Some(other) = others.last() else {
        return Ok(());
    };
    let has_side = row.sides() != Sides::Unsaid || key_of(name).1 != Sides::Unsaid;
    let has_side = has_side || row.section.side.is_some() || y == 0.0;
    let is_clear = (others.iter().all(|group| group.end == one.end) || row.section.end.is_some())
        && (others.iter().all(|group| group.side == one.side) || has_side);
    if is_clear {
        return Ok(());
    }
    let message = format!(
        "`{name}` has the coordinates of one point under {} groups of columns: say in the row which it is, for example `{}`",
        if others.len() == 1 { "two" } else { "several" },
        other.words().join(" ")
    );
    Err(stated.source.refuse(&row.place, &message))
}
