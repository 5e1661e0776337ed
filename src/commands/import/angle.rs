//! Rows of toe and camber that say something else than the angle of one wheel, in degrees: they are refused.

use super::hardpoints::Hardpoints;
use super::heading::section_of_heading;
use super::names::Names;
use super::row::Row;
use super::spelling::{key_of, spelled};
use crate::failure::Failure;
use crate::side::{Section, sides_of};

/// Words of another angle or sign, wherever they stand in the row; an apostrophe behind a number stands for minutes.
const OTHER: [&str; 22] = [
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
    "per_axle",
    "pro_achse",
    "top_in",
    "top_inboard",
];

/// The word of a toe angle that is positive for toe-out.
const TOE_OUT: &str = "out";

/// Words in which `rad` is a wheel.
const PER_WHEEL: [&str; 2] = ["pro_rad", "je_rad"];

/// The words that parentheses may have: degrees, the angle of one wheel at the design position, and our signs.
const UNDERSTOOD: [&str; 29] = [
    "deg",
    "degree",
    "degrees",
    "grad",
    "winkelgrad",
    "gradi",
    "grado",
    "grados",
    "degré",
    "degrés",
    "static",
    "statisch",
    "design",
    "nominal",
    "per",
    "each",
    "one",
    "single",
    "wheel",
    "side",
    "toe",
    "top",
    "out",
    "outboard",
    "outward",
    "positive",
    "positiv",
    "pos",
    "ve",
];

/// Checks that toe and camber are those of one wheel, in degrees, with our signs.
///
/// # Errors
///
/// [`Failure::Input`] if the line of the number says otherwise, or something else in parentheses.
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
    let Some(said) = other_angle(line, is_toe).or_else(|| not_understood(line, is_toe, names))
    else {
        return Ok(());
    };
    let or_limit = if said == "min" {
        ", for minutes or a limit"
    } else {
        ""
    };
    let message = format!(
        "`{name}` says `{said}`{or_limit}: write the angle of one wheel in degrees, positive for toe-in and for a top that leans outboard"
    );
    Err(stated.source.refuse(&row.place, &message))
}

/// Returns the words of a line that are those of another angle or sign.
fn other_angle(line: &str, is_toe: bool) -> Option<String> {
    let said = without_wheel(line);
    let minutes = has_minutes(line).then_some("'");
    let words: Vec<&str> = said.split('_').collect();
    let pairs: Vec<String> = words.windows(2).map(|pair| pair.join("_")).collect();
    let mut all = words
        .into_iter()
        .chain(minutes)
        .chain(pairs.iter().map(String::as_str));
    let other = all.find(|word| OTHER.contains(word) || is_toe && *word == TOE_OUT);
    other.map(|word| word.replace('_', " "))
}

/// Returns the first parentheses of a line with a word that is not understood, and is no corner.
fn not_understood(line: &str, is_toe: bool, names: &Names) -> Option<String> {
    let opened = line.split(['(', '[']).skip(1);
    let mut inside = opened.filter_map(|rest| Some(rest.split_once([')', ']'])?.0));
    let is_understood = |inside: &str| {
        let said = without_wheel(inside);
        let section = section_of_heading(&names.heading_in_english(&said));
        // `(in)` alone may be inches.
        let is_ours =
            |word: &str| UNDERSTOOD.contains(&word) || is_toe && word == "in" && said != "in";
        section != Section::default()
            || sides_of(inside).is_some()
            || !said.contains(char::is_alphabetic)
            || said.split('_').all(is_ours)
    };
    inside
        .find(|inside| !is_understood(inside))
        .map(str::to_owned)
}

/// Returns the spelled words without those in which `rad` is a wheel.
fn without_wheel(words: &str) -> String {
    PER_WHEEL
        .into_iter()
        .fold(spelled(words), |said, wheel| said.replace(wheel, "wheel"))
}

/// Returns whether an apostrophe stands behind a number, and not at the end of a field in quotes.
fn has_minutes(line: &str) -> bool {
    let mut apostrophes = line.match_indices('\'');
    let is_quoted = line.matches('\'').count().is_multiple_of(2);
    !is_quoted && apostrophes.any(|(at, _)| line[..at].ends_with(|c: char| c.is_ascii_digit()))
}
