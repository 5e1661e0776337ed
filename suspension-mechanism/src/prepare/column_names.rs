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
        let (file, own, quantity) = (source.name(), &of_listing.name, other.quantity.title);
        return Err(Failure::Input(format!(
            "{file}: `{own}` of the listing and the quantity `{quantity}` would both have the column `{name}` in tables; give \
             `{own}` another name in the listing"
        )));
    }
    Ok(())
}
