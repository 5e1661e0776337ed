//! Measured points of a target in a CSV file.

use csv::{ReaderBuilder, StringRecord, Trim};
use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{CsvTable, Source};
use crate::load::beside::read_beside;

/// The points of the two columns that a motion file names.
///
/// # Errors
///
/// [`Failure::Input`] at the path, at a column that the file does not have, and at a line without a number in a column.
pub(super) fn read(source: &Source, stated: &CsvTable) -> Result<Vec<[f64; 2]>, Failure> {
    let [drive, value] = stated.columns.get_ref().as_slice() else {
        let message = "`columns` are two headings of the file, of the drive and of the quantity, for example [\"travel\", \"toe\"]";
        return Err(source.refuse(&stated.columns.span(), message));
    };
    let file = read_beside(source, &stated.csv)?;
    // The mark with which spreadsheets begin a file is not part of its first heading.
    let file = Source::new(file.name(), file.text().trim_start_matches('\u{feff}'));
    let separator = separator(file.text());
    let mut reader = ReaderBuilder::new()
        .delimiter(separator)
        .trim(Trim::All)
        .flexible(true)
        .from_reader(file.text().as_bytes());
    let unread = |error: csv::Error| source.refuse(&stated.csv.span(), error);
    let headings = reader.headers().map_err(unread)?.clone();
    let headings: Vec<&str> = headings.iter().collect();
    if headings.is_empty() {
        let message = format!(
            "{} is empty; it needs a line of headings and lines of numbers",
            file.name()
        );
        return Err(source.refuse(&stated.csv.span(), message));
    }
    let column = |wanted: &Spanned<String>| {
        let mut each = headings.iter();
        let found = each.position(|heading| heading == wanted.get_ref());
        found.ok_or_else(|| {
            let what = format!("column of {}:", file.name());
            source.refuse(&wanted.span(), unknown(&what, wanted.get_ref(), &headings))
        })
    };
    let columns = [column(drive)?, column(value)?];
    let points = reader.records().map(|record| {
        let record = record.map_err(unread)?;
        let number = |column: usize| {
            let field = record.get(column).unwrap_or_default();
            let number = parsed(field, separator);
            number.ok_or_else(|| no_number(&file, &record, (field, headings[column])))
        };
        Ok([number(columns[0])?, number(columns[1])?])
    });
    points.collect()
}

/// What is between the fields of the first line.
fn separator(text: &str) -> u8 {
    let headings = text.trim_start().lines().next().unwrap_or_default();
    let mut others = [b';', b'\t'].into_iter();
    let other = others.find(|separator| headings.as_bytes().contains(separator));
    other.unwrap_or(b',')
}

/// The number in a field, with a decimal point or, where commas do not separate fields, a decimal comma.
fn parsed(field: &str, separator: u8) -> Option<f64> {
    let number = match separator {
        b',' => field.parse(),
        _ => field.replace(',', ".").parse(),
    };
    number.ok().filter(|number: &f64| number.is_finite())
}

/// The refusal of a field without a number.
fn no_number(file: &Source, record: &StringRecord, (field, heading): (&str, &str)) -> Failure {
    let message = match field {
        "" => format!("the line has no number in column `{heading}`"),
        _ => format!("`{field}` in column `{heading}` is not a finite number, as -0.5"),
    };
    // The record may begin at the end of the line before.
    let begin = record
        .position()
        .map_or(0, |position| position.byte() as usize);
    let before = file.text()[begin..].trim_start().len();
    let start = file.text().len() - before;
    file.refuse(&(start..start), message)
}
