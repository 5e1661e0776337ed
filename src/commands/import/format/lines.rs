//! The lines of a file with their places.

use std::borrow::Cow;
use std::ops::Range;

/// A part of a file, with its place.
pub(super) type Placed<T> = (Range<usize>, T);

/// A line of a file, or one that takes the place of several.
pub(super) type Line<'a> = Placed<Cow<'a, str>>;

/// The beginnings of a remark, and the end of a row in LaTeX.
const REMARKS: [&str; 5] = ["#", "//", "%", "!", "\\\\"];

/// The beginning of a line that is a remark in Adams/Car; elsewhere it stands around numbers in LaTeX.
const REMARK_LINE: char = '$';

/// Returns the trimmed lines of a text, each with its place.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Placed<&str>> {
    trimmed_lines(text, char::is_whitespace)
}

/// Returns the lines of a text without the blanks around them, but with tabs: cells that are empty.
pub(super) fn lines_with_tabs(text: &str) -> impl Iterator<Item = Placed<&str>> {
    trimmed_lines(text, |c| c.is_whitespace() && c != '\t')
}

fn trimmed_lines(text: &str, is_blank: fn(char) -> bool) -> impl Iterator<Item = Placed<&str>> {
    let mut start = 0;
    text.split_inclusive('\n').map(move |line| {
        let from = start;
        start += line.len();
        let line = line.trim_end_matches(is_blank);
        let own = line.trim_start_matches(|c: char| is_blank(c) || c == '\u{feff}');
        (from + line.len() - own.len()..from + line.len(), own)
    })
}

/// Returns a line without its remark.
pub(super) fn without_remark(line: &str) -> &str {
    let starts = REMARKS.iter().filter_map(|remark| line.find(remark));
    match line.trim_start().starts_with(REMARK_LINE) {
        true => "",
        false => &line[..starts.min().unwrap_or(line.len())],
    }
}
