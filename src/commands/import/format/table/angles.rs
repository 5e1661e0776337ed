//! Rows of toe and camber that say something else than the angle of one wheel, in degrees: they are refused.

use crate::commands::import::format::heading::section_of_heading;
use crate::commands::import::format::row::Row;
use crate::commands::import::hardpoints::Hardpoints;
use crate::commands::import::names::Names;
use crate::commands::import::spelling::{is_one_of, key_of, spelled};
use crate::failure::Failure;
use crate::vehicle_corner::{Section, sides_of};

/// Words of another angle or sign, wherever they stand in the row; an apostrophe behind a number stands for minutes.
const OTHER: &str = "\
    min minutes minuten winkelminuten minuti primi minutos arcmin ' rad mrad radians total gesamtspur mm cm inch inches \
    per_axle pro_achse top_in top_inboard";

/// The word of a toe angle that is positive for toe-out.
const TOE_OUT: &str = "out";

/// Words in which `rad` is a wheel.
const PER_WHEEL: [&str; 2] = ["pro_rad", "je_rad"];

/// The words that parentheses and columns behind the name may have: degrees, the angle of one wheel at the design position, and our signs.
const UNDERSTOOD: &str = "\
    angle winkel deg degree degrees grad winkelgrad gradi grado grados degré degrés static statisch design nominal per \
    each one single wheel side toe top out outboard outward positive positiv pos ve";

/// Checks that toe and camber are those of one wheel, in degrees, with our signs.
///
/// # Errors
///
/// [`Failure::Input`] if the line of the number says otherwise, or something else in parentheses or in a column
/// between its name and the number.
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
    let columns = row.columns_before_numbers().into_iter();
    let is_name = |column: &&str| names.is_number(&key_of(column).0);
    let mut beside = columns
        .skip_while(|column| !is_name(column))
        .skip(1)
        .chain(in_parentheses(line));
    let is_understood = |words: &str| is_understood(words, is_toe, names);
    let unknown = beside.find(|words| !is_understood(words));
    let said = other_angle(line, is_toe).or(unknown.map(str::to_owned));
    let Some(said) = said.or_else(|| beyond_a_right_angle(row)) else {
        return Ok(());
    };
    let meant = match said.as_str() {
        "min" => ", for minutes or a limit",
        "total" | "gesamtspur" | "per axle" | "pro achse" => ", the angle of both wheels together",
        _ => "",
    };
    let message = format!(
        "`{name}` says `{said}`{meant}: write the angle of one wheel in degrees, positive for toe-in and for a top that leans outboard"
    );
    Err(stated.source.refuse(&row.place, &message))
}

/// Returns whether the name of an angle says itself that it is another one, as `total_toe` does.
pub(in crate::commands::import) fn is_name_of_other_angle(key: &str) -> bool {
    key.split('_').any(|word| is_one_of(word, OTHER))
}

/// Returns a number that is no toe or camber in degrees, such as `1,250` between decimals with a point.
fn beyond_a_right_angle(row: &Row<'_>) -> Option<String> {
    let numbers = row.numbers_behind_name().into_iter();
    let mut beyond = numbers.filter(|number| number.abs() > 90.0);
    beyond.next().map(|number| number.to_string())
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
    let other = all.find(|word| is_one_of(word, OTHER) || is_toe && *word == TOE_OUT);
    other.map(|word| word.replace('_', " "))
}

/// Returns the words in each pair of parentheses of a line.
fn in_parentheses(line: &str) -> impl Iterator<Item = &str> {
    let opened = line.split(['(', '[']).skip(1);
    opened.filter_map(|rest| Some(rest.split_once([')', ']'])?.0))
}

/// Returns whether words beside an angle are those of a corner, or say that it is as ours.
fn is_understood(words: &str, is_toe: bool, names: &Names) -> bool {
    let said = without_wheel(words);
    let section = section_of_heading(&names.heading_in_english(&said));
    // `(in)` alone may be inches.
    let is_ours =
        |word: &str| is_one_of(word, UNDERSTOOD) || is_toe && word == "in" && said != "in";
    section != Section::default()
        || sides_of(words).is_some()
        || !said.contains(char::is_alphabetic)
        || said.split('_').all(is_ours)
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
