//! Tables of measured numbers in text: a line of headings, then lines of numbers.

use std::iter;

use csv::{ReaderBuilder, StringRecord, Trim};

use crate::failure::Failure;
use crate::file::Source;

/// A table whose numbers are read column by column.
#[derive(Clone, Debug)]
pub struct MeasuredTable {
    source: Source,
    separator: u8,
    headings: StringRecord,
    lines: Vec<StringRecord>,
}

impl MeasuredTable {
    /// Splits a text into fields, which commas, semicolons or tabs separate.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the text has no line of headings.
    pub fn new(file: &Source) -> Result<Self, Failure> {
        // The mark with which spreadsheets begin a file is not part of its first heading.
        let source = Source::new(file.name(), file.text().trim_start_matches('\u{feff}'));
        let separator = separator(source.text());
        let mut reader = ReaderBuilder::new()
            .delimiter(separator)
            .trim(Trim::All)
            .flexible(true)
            .from_reader(source.text().as_bytes());
        let unread = |error: csv::Error| source.refuse(&(0..0), error);
        let headings = reader.headers().map_err(unread)?.clone();
        if headings.is_empty() {
            let message = "the file is empty; it needs a line of headings and lines of numbers";
            return Err(source.refuse(&(0..0), message));
        }
        let lines = reader.records().collect::<Result<_, _>>();
        let lines = lines.map_err(unread)?;
        Ok(Self {
            source,
            separator,
            headings,
            lines,
        })
    }

    /// The file's name.
    pub fn name(&self) -> &str {
        self.source.name()
    }

    /// The headings.
    pub fn headings(&self) -> Vec<&str> {
        self.headings.iter().collect()
    }

    /// The number of lines below the headings.
    pub fn lines(&self) -> usize {
        self.lines.len()
    }

    /// The numbers of a column, with a decimal point or, where commas do not separate fields, a decimal comma.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the first field without a finite number.
    pub fn numbers(&self, column: usize) -> Result<Vec<f64>, Failure> {
        let number = |(line, record): (usize, &StringRecord)| {
            let field = record.get(column).unwrap_or_default();
            let heading = &self.headings[column];
            parsed(field, self.separator).ok_or_else(|| {
                let message = match field {
                    "" => format!("the line has no number in column `{heading}`"),
                    _ => format!("`{field}` in column `{heading}` is not a finite number, as -0.5"),
                };
                self.refuse_number(line, column, message)
            })
        };
        self.lines.iter().enumerate().map(number).collect()
    }

    /// The failure at a heading.
    pub fn refuse_heading(&self, column: usize, message: impl std::fmt::Display) -> Failure {
        self.refuse(&self.headings, column, message)
    }

    /// The failure at a number of a line, which counts from zero below the headings.
    pub fn refuse_number(
        &self,
        line: usize,
        column: usize,
        message: impl std::fmt::Display,
    ) -> Failure {
        self.refuse(&self.lines[line], column, message)
    }

    /// The failure at a field; at the end of a line that is too short.
    fn refuse(
        &self,
        record: &StringRecord,
        column: usize,
        message: impl std::fmt::Display,
    ) -> Failure {
        let begin = record
            .position()
            .map_or(0, |position| position.byte() as usize);
        // The record may begin at the end of the line before.
        let text = self.source.text()[begin..].trim_start_matches(['\r', '\n']);
        let line = text.lines().next().unwrap_or_default();
        let mut is_quoted = false;
        let ends = line.bytes().enumerate().filter(|(_, byte)| {
            is_quoted ^= *byte == b'"';
            !is_quoted && *byte == self.separator
        });
        let mut starts = iter::once(0).chain(ends.map(|(end, _)| end + 1));
        let field = starts
            .nth(column)
            .map_or("", |start| line[start..].trim_start_matches(' '));
        let start = self.source.text().len() - text.len() + line.len() - field.len();
        self.source.refuse(&(start..start), message)
    }
}

/// What is between the fields of the first line.
fn separator(text: &str) -> u8 {
    let headings = text.trim_start().lines().next().unwrap_or_default();
    let mut others = [b';', b'\t'].into_iter();
    let other = others.find(|separator| headings.as_bytes().contains(separator));
    other.unwrap_or(b',')
}

fn parsed(field: &str, separator: u8) -> Option<f64> {
    let number = match separator {
        b',' => field.parse(),
        _ => field.replace(',', ".").parse(),
    };
    number.ok().filter(|number: &f64| number.is_finite())
}
