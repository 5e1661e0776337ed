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
    let (table, columns) = columns(source, stated, of)?;
    points(&table, columns)
}

/// A table, and the numbers of the two columns that a motion file names.
///
/// # Errors
///
/// [`Failure::Input`] at the path, and at a column that the file does not have.
pub(super) fn columns(
    source: &Source,
    stated: &CsvTable,
    of: &str,
) -> Result<(MeasuredTable, [usize; 2]), Failure> {
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
    let found = [column(at)?, column(value)?];
    Ok((table, found))
}

/// The numbers of two columns, line by line.
///
/// # Errors
///
/// [`Failure::Input`] at a line without a number in a column.
pub(super) fn points(
    table: &MeasuredTable,
    [at, value]: [usize; 2],
) -> Result<Vec<[f64; 2]>, Failure> {
    let (places, values) = (table.numbers(at)?, table.numbers(value)?);
    Ok(places
        .into_iter()
        .zip(values)
        .map(|(at, value)| [at, value])
        .collect())
}
