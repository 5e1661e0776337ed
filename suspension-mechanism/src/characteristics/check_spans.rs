//! Whether ranges of travel and steering are what anyone asks for.

use suspension_core::listing::DriveKind;

use crate::characteristics::mode_states::{option_of, usual_change};
use crate::characteristics::modes::Mode;
use crate::characteristics::span::Span;
use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{Names, Unit};
use crate::number::number;

/// The shortest and the longest span of a wheel's drive from end to end that anyone asks for, in metres.
const SHORTEST: f64 = 3e-4;
const LONGEST: f64 = 1.0;

/// Returns notes on spans that seem to be in another unit, also on usual ones of drives that are multiples of heights.
///
/// # Errors
///
/// [`Failure::Input`] if no drive is known to move the wheel up and down.
pub fn check_spans(
    mechanism: &dyn Kinematics,
    file: &str,
    spans: [Option<Span>; 2],
    unit: Unit,
) -> Result<Vec<String>, Failure> {
    let names = &mechanism.names;
    if names.vehicle.travel.is_empty() {
        return Err(Failure::Input(format!("{file}: {}", no_travel(names))));
    }
    let notes = Mode::all(mechanism)
        .into_iter()
        .filter_map(|mode| match spans[option_of(&mode)] {
            _ if mode.kind != DriveKind::Coordinate => None,
            Some(span) => note_on_stated(file, &mode, span, unit),
            None => note_on_usual(file, &mode, mechanism.unit),
        });
    Ok(notes.collect())
}

/// Returns whether anyone asks for a span of a wheel's drive, whose length from end to end is in `unit`.
fn is_asked_for(length: f64, unit: Unit) -> bool {
    (SHORTEST..=LONGEST).contains(&(length / unit.metre()))
}

/// A note if a span seems to be in another unit.
fn note_on_stated(file: &str, mode: &Mode, Span([from, to]): Span, unit: Unit) -> Option<String> {
    let rise = (to - from) * mode.rise.unwrap_or(1.0);
    (!is_asked_for(rise, unit)).then(|| {
        let (way, symbol) = (&mode.title, unit.symbol());
        let [from, to] = [from, to].map(number);
        format!("{file}: {way} is from {from} {symbol} to {to} {symbol}: is it in another unit?")
    })
}

/// A note if the usual range of a drive moves its wheel much less or further than anyone asks for.
fn note_on_usual(file: &str, mode: &Mode, unit: Unit) -> Option<String> {
    let rise = 2.0 * usual_change(mode.effect, DriveKind::Coordinate, unit) * mode.rise?;
    (!is_asked_for(rise, unit)).then(|| {
        format!(
            "{file}: over the usual range of {} the wheel rises by {} {}; --travel sets another range",
            mode.title,
            number(rise),
            unit.symbol()
        )
    })
}

/// The remedy if no drive is known to move the wheel up and down.
fn no_travel(names: &Names) -> String {
    let is_still = names.wheels.iter().all(|wheel| wheel.lifted_by.is_empty());
    match names.wheels.first() {
        Some(wheel) if is_still => {
            let [_, centre] = wheel.points.axis;
            let centre = &names.points[centre];
            format!(
                "the curves need a drive that moves the wheel up and down, and only steering does; if the wheel can rise, add \
                 one to the listing, for example `drive bump: {centre}.z;`; `suspension sweep` makes tables over any drive"
            )
        }
        _ => {
            let known = names.drive_names().join(", ");
            let travel = names.travel_in_file(&names.wheels);
            format!(
                "which drive moves the wheel up and down? Write [vehicle] with travel = {travel}; the drives are {known}"
            )
        }
    }
}
