//! The lines of a measured table before they are split into fields.

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
