//! The lines of a measured table, and how they are split into fields.

use csv::{ReaderBuilder, StringRecord, Trim};

use crate::failure::Failure;
use crate::file::Source;

/// The most lines: ten minutes at 1 kHz are 600,000. However short, a line takes 200 bytes of memory.
const MOST: usize = 1_000_000;

/// The lines that are neither empty nor comments, as fields.
///
/// # Errors
///
/// [`Failure::Input`] at the first line that is too many.
pub(super) fn records(source: &Source, separator: u8) -> Result<Vec<StringRecord>, Failure> {
    let mut reader = ReaderBuilder::new()
        .delimiter(separator)
        .trim(Trim::All)
        .comment(Some(b'#'))
        .has_headers(false)
        .flexible(true)
        .from_reader(source.text().as_bytes());
    let has_content = |line: &StringRecord| line.iter().any(|field| !field.is_empty());
    let lines = reader.records();
    let lines = lines.filter(|line| line.as_ref().map_or(true, has_content));
    let lines = lines.take(MOST + 1).collect::<Result<Vec<_>, _>>();
    let lines = lines.map_err(|error| source.refuse(&(0..0), error))?;
    match lines.len() > MOST {
        true => Err(Failure::input(
            source.name(),
            format!(
                "has more than {MOST} lines; leave out those that are not needed, as every second one"
            ),
        )),
        false => Ok(lines),
    }
}

/// The text from its first line that is neither empty nor a comment.
pub(super) fn content(mut text: &str) -> &str {
    loop {
        text = text.trim_start_matches(['\r', '\n']);
        let Some(comment) = text.strip_prefix('#') else {
            return text;
        };
        text = comment.split_once('\n').map_or("", |(_, rest)| rest);
    }
}

/// The bytes of a line that are not in quotes, each with its index.
pub(super) fn unquoted(line: &str) -> impl Iterator<Item = (usize, u8)> {
    let mut is_quoted = false;
    line.bytes().enumerate().filter(move |(_, byte)| {
        is_quoted ^= *byte == b'"';
        !is_quoted
    })
}

/// Returns whether several fields of a line are not empty: a table has a column of places and one of a quantity.
pub(super) fn has_several<'a>(fields: impl Iterator<Item = &'a str>) -> bool {
    fields.filter(|field| !field.trim().is_empty()).count() > 1
}

/// What is between the fields of the last line that has several: titles above the table may have commas.
pub(super) fn separator(text: &str) -> u8 {
    let of_line = |line: &str| {
        let has = |separator: &u8| unquoted(line).any(|(_, byte)| byte == *separator);
        [b';', b'\t', b','].into_iter().find(has)
    };
    let mut lines = text.lines().rev().filter(|line| !line.starts_with('#'));
    lines.find_map(of_line).unwrap_or(b',')
}
