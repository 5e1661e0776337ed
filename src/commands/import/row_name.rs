//! The name of a row of which a column before it, or the heading above it, has a part.

use super::heading::end_of_heading;
use super::names::{Names, key_of, spelled};
use super::row::Row;

/// Returns the name of a row: together with the columns before it, as in `Tie rod, inner`, or with the `heading` above it,
/// if that is known, or else its own.
pub(super) fn name_of(row: &Row<'_>, heading: &str, names: &Names) -> String {
    let own = row.name();
    let is_point = !row.places().is_empty();
    let mut columns = row.columns_before_numbers();
    let last = columns.pop();
    // A column such as `Rear` is of the axle.
    columns.retain(|column| end_of_heading(&spelled(column)).is_none());
    let others = columns.len();
    columns.extend(last);
    let joined = (0..others).map(|from| columns[from..].join(" "));
    let headed = (!heading.is_empty()).then(|| format!("{heading} {own}"));
    let mut readings = joined.chain(headed);
    let is_known = |key: &str| match is_point {
        true => names.is_point(key),
        false => names.is_number(key),
    };
    let own_form = names.normal(&key_of(&own).0);
    let known = readings.find(|name| {
        let (key, _) = key_of(name);
        // A heading such as `Point` adds nothing.
        is_known(&key) && names.normal(&key) != own_form
    });
    known.unwrap_or(own)
}
