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
        let value = rest.split(ENDS).next()?.trim();
        return Some(mistaken_number(value).unwrap_or_else(|| without_quotes(value)));
    }
    if ["invalid float", "invalid mantissa", "invalid integer"]
        .iter()
        .any(|begin| message.starts_with(begin))
    {
        return mistaken_number(value_around(text, start)?);
    }
    let first_line = message.trim_end().replace('\n', ", ");
    let hint = hint(message, text, start)?;
    Some(first_line + &hint)
}

/// What ends a value.
const ENDS: [char; 5] = [',', ']', '}', '\n', '#'];

/// Returns the value within which the parser stopped.
fn value_around(text: &str, start: usize) -> Option<&str> {
    let (before, _) = text.split_at_checked(start)?;
    let first = before
        .rfind(['=', ',', '[', '{', '\n'])
        .map_or(0, |end| end + 1);
    Some(text[first..].split(ENDS).next()?.trim())
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
    let line = rest.split(['\n', '#']).next()?;
    let hint = if is_comma_between_digits(text, start) {
        "; a decimal separator is a point, as in 0.5"
    } else if is_surplus && rest.starts_with(';') {
        NO_SEMICOLON
    } else if is_surplus && rest.starts_with('/') {
        COMMENT
    } else if is_surplus && line.contains('=') {
        "; each NAME = value stands in a line of its own"
    } else if is_surplus && line.trim_end() == "," {
        "; a line ends without `,`"
    } else if is_surplus && rest.starts_with(',') {
        LIST
    } else if is_surplus && rest.starts_with(']') {
        "; there is a `]` too many"
    } else if message.contains("unicode") || message.contains("escape") {
        "; in double quotes `\\` begins an escape: write `/` in a path, or single quotes"
    } else if message.starts_with("missing comma between key-value pairs") {
        "; or the table before it lacks its `}`"
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
        return COMMENT.to_owned();
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

const NO_SEMICOLON: &str = "; a line ends without `;`";

const COMMENT: &str = "; a comment begins with #";

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
    if let [first, _, ..] = words.clone().collect::<Vec<_>>()[..]
        && words.all(is_number)
    {
        return Some(format!("a comma is missing behind {first}{LIST}"));
    }
    let number = value
        .trim_end_matches(|letter: char| letter.is_alphabetic())
        .trim_end();
    let hint = if value.ends_with(';') {
        NO_SEMICOLON.to_owned()
    } else if value.contains("//") {
        COMMENT.to_owned()
    } else if number != value && is_number(number) {
        format!("; write {number} without the unit")
    } else if value.ends_with('%') {
        "; write the fraction, as 0.6 for 60 %".to_owned()
    } else if is_number(value) {
        "; a digit stands on both sides of the point, as in 0.3".to_owned()
    } else if value.contains(['/', '*', '+', '^', '(']) {
        "; a number is written out, as 0.01: formulas are not read".to_owned()
    } else {
        LIST.to_owned()
    };
    Some(format!("`{value}` is no number{hint}"))
}

fn is_comma_between_digits(text: &str, start: usize) -> bool {
    let (before, behind) = text.split_at_checked(start).unwrap_or((text, ""));
    let is_digit = |letter: char| letter.is_ascii_digit();
    before.ends_with(is_digit)
        && behind
            .strip_prefix(',')
            .is_some_and(|rest| rest.starts_with(is_digit))
}
