//! Names that two columns of a table would have.

use std::collections::BTreeMap;

use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::{Names, Unit};
use crate::quantities::{Column, catalogue, columns};

/// Refuses a name of the listing that would give a column the name of another one.
pub(super) fn check(source: &Source, names: &Names, unit: Unit) -> Result<(), Failure> {
    let mut seen: BTreeMap<String, Column> = BTreeMap::new();
    for column in columns(catalogue(), names) {
        let name = column.csv_name(unit);
        let Some(first) = seen.get(&name) else {
            seen.insert(name, column);
            continue;
        };
        let (of_listing, other) = if first.quantity.name.is_empty() {
            (first, &column)
        } else {
            (&column, first)
        };
        return Err(Failure::Input(format!(
            "{}: `{}` of the listing would have the column name `{name}` of {} in tables: give it another name",
            source.name(),
            of_listing.name,
            other.quantity.title
        )));
    }
    Ok(())
}
