//! Tables of measured numbers in text: perhaps titles, a line of headings, perhaps one of units, then lines of numbers.

mod lines;
pub mod units;

use std::iter;

use csv::StringRecord;

use crate::decimals::Decimals;
use crate::failure::Failure;
use crate::file::Source;
use lines::{content, has_several, records, separator, unquoted};

/// A table whose numbers are read column by column.
#[derive(Clone, Debug)]
pub struct MeasuredTable {
    source: Source,
    separator: u8,
    decimals: Decimals,
    headings: StringRecord,
    lines: Vec<StringRecord>,
}

impl MeasuredTable {
    /// Splits a text into fields, which commas, semicolons or tabs separate. Lines without content, lines that begin with `#`,
    /// and titles, lines of one field above that of the headings, are left out.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the text has no line of headings, or more than a million lines, and at a field beyond the last
    /// heading.
    pub fn new(file: &Source) -> Result<Self, Failure> {
        // The mark with which spreadsheets begin a file is not part of its first heading.
        let source = Source::new(file.name(), file.text().trim_start_matches('\u{feff}'));
        let separator = separator(source.text());
        let mut lines = records(&source, separator)?;
        let first = lines.iter().position(|line| has_several(line.iter()));
        lines.drain(..first.unwrap_or_default());
        if lines.is_empty() {
            let message = "the file is empty; it needs a line of headings and lines of numbers";
            return Err(source.refuse(&(0..0), message));
        }
        let headings = lines.remove(0);
        let table = Self {
            source,
            separator,
            decimals: decimals(&lines),
            headings,
            lines,
        };
        table.check_separated()?;
        table.check_lengths()?;
        Ok(table)
    }

    /// Refuses numbers that only blanks separate, which would be read as one field.
    fn check_separated(&self) -> Result<(), Failure> {
        let is_number = |word: &str| self.decimals.number(word).is_some();
        let is_several = |field: &str| {
            let mut words = field.split_whitespace();
            words.clone().count() > 1 && words.all(is_number)
        };
        let first = |line: &StringRecord| line.get(0).is_some_and(is_several);
        match self.lines.iter().position(first) {
            Some(line) if self.headings.len() == 1 => {
                let message = "several numbers in one field; separate fields by commas, semicolons or tabs, in the line of headings \
                               too";
                Err(self.refuse_number(line, 0, message))
            }
            _ => Ok(()),
        }
    }

    /// Refuses decimal commas between commas, which would be read as fields of their own.
    fn check_lengths(&self) -> Result<(), Failure> {
        let headings = self.headings.len();
        let beyond =
            |line: &StringRecord| line.iter().skip(headings).any(|field| !field.is_empty());
        let Some(line) = self.lines.iter().position(beyond) else {
            return Ok(());
        };
        self.check_no_point()?;
        let of_headings = self.line_of(&self.headings);
        let message = format!(
            "the line has more fields than there are headings in line {of_headings}; begin lines above the headings with #, and \
             with decimal commas separate the fields by semicolons or tabs"
        );
        Err(self.refuse_number(line, headings, message))
    }

    /// Refuses a table of hardpoints; a measured table may have such lines, too, if its headings say where the model is.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the first line that is a name with three numbers.
    pub fn check_no_point(&self) -> Result<(), Failure> {
        let point = self.lines.iter().position(|line| self.is_point(line));
        point.map_or(Ok(()), |point| {
            let message = "a name with three numbers, as in a table of hardpoints, which suspension import reads; a measured \
                           table has a column of places and columns of quantities";
            Err(self.refuse_number(point, 0, message))
        })
    }

    /// Returns whether a line is a name with three numbers.
    fn is_point(&self, line: &StringRecord) -> bool {
        let is_number = |field: &str| self.decimals.number(field).is_some();
        let mut fields = line.iter();
        let name = fields.next().filter(|name| !name.is_empty());
        name.is_some_and(|name| !is_number(name))
            && fields.take(3).filter(|at| is_number(at)).count() == 3
    }

    /// The file's name.
    pub fn name(&self) -> &str {
        self.source.name()
    }

    /// The headings.
    pub fn headings(&self) -> Vec<&str> {
        self.headings.iter().collect()
    }

    /// Removes the first line below the headings if it has no number, and returns its fields, which are units.
    pub fn take_units(&mut self) -> Vec<String> {
        let is_number = |field: &str| self.decimals.number(field).is_some();
        let units = self.lines.first();
        let Some(units) = units.filter(|line| !line.iter().any(is_number)) else {
            return Vec::new();
        };
        let units = units.iter().map(str::to_owned).collect();
        self.lines.remove(0);
        units
    }

    /// The number of lines of numbers.
    pub fn lines(&self) -> usize {
        self.lines.len()
    }

    /// The numbers of a column, with a decimal point or comma, and perhaps the other sign between thousands.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the first field without a finite number.
    pub fn numbers(&self, column: usize) -> Result<Vec<f64>, Failure> {
        let numbers = self.numbers_or_nan(column)?;
        match numbers.iter().position(|number| number.is_nan()) {
            Some(line) => {
                let heading = &self.headings[column];
                let message = format!(
                    "the line has no number in column `{heading}`; write one, or leave out the line"
                );
                Err(self.refuse_number(line, column, message))
            }
            None => Ok(numbers),
        }
    }

    /// The same, with NaN where a field is empty or says `NaN`.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the first field with anything else, and at a number that may be one or one thousand.
    pub fn numbers_or_nan(&self, column: usize) -> Result<Vec<f64>, Failure> {
        let number = |(line, record): (usize, &StringRecord)| {
            let field = record.get(column).unwrap_or_default();
            if field.is_empty() || field.eq_ignore_ascii_case("nan") {
                return Ok(f64::NAN);
            }
            if self.is_unclear(field) {
                let message = Decimals::doubt(field) + ", here or in another line";
                return Err(self.refuse_number(line, column, message));
            }
            self.decimals.number(field).ok_or_else(|| {
                let heading = &self.headings[column];
                let message = format!(
                    "`{field}` in column `{heading}` is not a finite number, as -0.5; leave the field empty if nothing was \
                     measured"
                );
                self.refuse_number(line, column, message)
            })
        };
        self.lines.iter().enumerate().map(number).collect()
    }

    /// Returns whether a number may be one thousand. Where commas or tabs separate fields, decimals usually follow a point.
    fn is_unclear(&self, field: &str) -> bool {
        let is_usual = self.separator != b';' && field.contains('.');
        !is_usual && self.decimals.is_unclear(field)
    }

    /// The number of a line in the file, from one, as failures state it; the argument counts from zero below the headings.
    pub fn line_in_file(&self, line: usize) -> u64 {
        self.line_of(&self.lines[line])
    }

    /// The first line below the headings that has a field, by its number in the file.
    pub(crate) fn line_with(&self, wanted: &str) -> Option<u64> {
        let mut lines = self.lines.iter();
        let line = lines.find(|line| line.iter().any(|field| field == wanted))?;
        Some(self.line_of(line))
    }

    fn line_of(&self, record: &StringRecord) -> u64 {
        let number = record.position().map_or(1, csv::Position::line);
        let text = &self.source.text()[start_of(record)..];
        let before = &text[..text.len() - self.text_from(record).len()];
        number + before.matches('\n').count() as u64
    }

    /// The text from the line of a record on: the record may begin before lines that it does not have.
    fn text_from(&self, record: &StringRecord) -> &str {
        content(&self.source.text()[start_of(record)..])
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
        let text = self.text_from(record);
        let line = text.lines().next().unwrap_or_default();
        let ends = unquoted(line).filter(|(_, byte)| *byte == self.separator);
        let mut starts = iter::once(0).chain(ends.map(|(end, _)| end + 1));
        let field = starts
            .nth(column)
            .map_or("", |start| line[start..].trim_start_matches(' '));
        let start = self.source.text().len() - text.len() + line.len() - field.len();
        self.source.refuse(&(start..start), message)
    }
}

/// Returns the place in the text where a record begins.
fn start_of(record: &StringRecord) -> usize {
    let position = record.position();
    position.map_or(0, |position| position.byte() as usize)
}

/// Returns what the numbers of all lines show of their commas and points.
fn decimals(lines: &[StringRecord]) -> Decimals {
    let mut decimals = Decimals::default();
    let fields = lines.iter().flatten();
    let numbers = fields.filter(|field| Decimals::default().number(field).is_some());
    numbers.for_each(|number| decimals.add(number));
    decimals
}
