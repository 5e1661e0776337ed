//! The name of a row of which a column before it, or the heading above it, has a part.

use super::names::{Names, key_of};
use super::row::Row;

/// Returns the name of a row: its own or, if that is no point, the one that is a point together with columns before it, as
/// in `Tie rod, inner`, or with the `heading` above it.
pub(super) fn name_of(row: &Row<'_>, heading: &str, names: &Names) -> String {
    let own = row.name();
    let columns = row.words_before_coordinates();
    let joined = (0..columns.len())
        .rev()
        .map(|from| columns[from..].join(" "));
    let under_heading = format!("{heading} {own}");
    let mut readings = [own.clone()]
        .into_iter()
        .chain(joined)
        .chain([under_heading]);
    let known = readings.find(|name| names.is_point(&key_of(name).0));
    known.unwrap_or(own)
}
