//! Measured or recorded points in a CSV file.

use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{CsvTable, Source};
use crate::measured_table::MeasuredTable;

/// The points of the two columns that a motion file names; `of` says what they hold, with an example.
///
/// # Errors
///
/// [`Failure::Input`] at the path, at a column that the file does not have, and at a line without a number in a column.
pub(super) fn read(source: &Source, stated: &CsvTable, of: &str) -> Result<Vec<[f64; 2]>, Failure> {
    let [at, value] = stated.columns.get_ref().as_slice() else {
        let message = format!("`columns` are two headings of the file, {of}");
        return Err(source.refuse(&stated.columns.span(), message));
    };
    let table = MeasuredTable::new(&source.read_beside(&stated.csv)?)?;
    let headings = table.headings();
    let column = |wanted: &Spanned<String>| {
        let mut each = headings.iter();
        let found = each.position(|heading| heading == wanted.get_ref());
        found.ok_or_else(|| {
            let what = format!("column of {}:", table.name());
            source.refuse(&wanted.span(), unknown(&what, wanted.get_ref(), &headings))
        })
    };
    let (at, value) = (column(at)?, column(value)?);
    let (places, values) = (table.numbers(at)?, table.numbers(value)?);
    Ok(places
        .into_iter()
        .zip(values)
        .map(|(at, value)| [at, value])
        .collect())
}
