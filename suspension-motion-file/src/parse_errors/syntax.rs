//! Mistakes in the notation of TOML, whatever the key, with what to write instead.

/// Returns the message for such a mistake that begins at `start`.
pub(super) fn explained(message: &str, text: &str, start: usize) -> Option<String> {
    let rest = text.get(start..)?;
    let is_value = [
        "string values must be quoted",
        "invalid boolean",
        "invalid datetime",
    ];
    if is_value.iter().any(|begin| message.starts_with(begin)) {
        let value = rest.split([',', ']', '}', '\n', '#']).next()?.trim();
        return Some(mistaken_number(value).unwrap_or_else(|| without_quotes(value)));
    }
    let first_line = message.trim_end().replace('\n', ", ");
    let hint = hint(message, text, start)?;
    Some(first_line + &hint)
}

/// Says what to write, behind the parser's message.
fn hint(message: &str, text: &str, start: usize) -> Option<String> {
    let rest = text.get(start..)?;
    if message.starts_with("key with no value") {
        return Some(without_equals(text, start));
    }
    if message.starts_with("duplicate key") {
        let is_end = |letter: char| !letter.is_alphanumeric() && letter != '_';
        let name = rest.split(is_end).next()?;
        return Some(format!("; `{name}` is stated twice: leave one of them"));
    }
    let is_surplus = message.starts_with("unexpected key or value");
    let hint = if is_comma_between_digits(text, start) {
        "; a decimal separator is a point, as in 0.5"
    } else if is_surplus && rest.starts_with(',') {
        LIST
    } else if is_surplus && rest.starts_with(';') {
        "; a line ends without `;`"
    } else if message.starts_with("missing comma") {
        "; or the list before it lacks its `]`"
    } else {
        return None;
    };
    Some(hint.to_owned())
}

/// Says what a line without `=` lacks, at which the parser stopped at `start`.
fn without_equals(text: &str, start: usize) -> String {
    let (before, rest) = text.split_at_checked(start).unwrap_or((text, ""));
    let line = before.rsplit('\n').next().unwrap_or_default().trim_start();
    if line.starts_with('/') || rest.starts_with('/') {
        return "; a comment begins with #".to_owned();
    }
    if line.trim_end().ends_with(':') || rest.starts_with(':') {
        return "; write `=` in place of `:`".to_owned();
    }
    "; a line is written NAME = value, with `_` in place of blanks in the name".to_owned()
}

/// Says how a text is written that stands without quotes, or in quotes of a text processor.
fn without_quotes(value: &str) -> String {
    let text = value.trim_matches(['“', '”', '„', '‘', '’', '"', '\'']);
    if text.is_empty() {
        return "the value is missing; write it behind the `=`".to_owned();
    }
    format!("a text stands in straight quotes; write \"{text}\"")
}

/// How several numbers are written.
const LIST: &str = "; several numbers are written [0.1, 0.2, 0.3]";

/// Says what is wrong with a value that begins like a number: a comma that is missing, as in `[0.1 0.2]`, or other signs.
fn mistaken_number(value: &str) -> Option<String> {
    let begins = value.trim_start_matches(['+', '-', '.', ' ']);
    if !begins.starts_with(|letter: char| letter.is_ascii_digit()) {
        return None;
    }
    let mut words = value.split_whitespace();
    let is_number = |word: &str| word.parse::<f64>().is_ok();
    Some(match words.clone().collect::<Vec<_>>()[..] {
        [first, ..] if words.all(is_number) => format!("a comma is missing behind {first}{LIST}"),
        [first, unit] if is_number(first) && unit.chars().all(char::is_alphabetic) => {
            format!("`{value}` is no number; write {first} without the unit")
        }
        _ => format!("`{value}` is no number{LIST}"),
    })
}

fn is_comma_between_digits(text: &str, start: usize) -> bool {
    let (before, behind) = text.split_at_checked(start).unwrap_or((text, ""));
    let is_digit = |letter: char| letter.is_ascii_digit();
    before.ends_with(is_digit)
        && behind
            .strip_prefix(',')
            .is_some_and(|rest| rest.starts_with(is_digit))
}
