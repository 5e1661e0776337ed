//! A line of a table: a name and numbers, with any separators.

use std::ops::Range;

use super::fields::{
    fields, has_empty_coordinate, has_number_in_parentheses, number, without_axes, without_units,
};
use super::lines::without_remark;
use crate::commands::import::length_units::unit;
use crate::commands::import::spelling::spelled;
use crate::decimals::{Decimals, MINUS};
use crate::vehicle_corner::{Section, sides_of};

/// The separators of fields, among them those of tables in Markdown and LaTeX; numbers may have a decimal comma between all
/// but commas and blanks.
const SEPARATORS: [char; 6] = [';', '\t', '|', '&', ',', ' '];

/// The most points in a row: one for each corner of a vehicle.
const MOST_POINTS: usize = 4;

/// A line that has been split into fields.
#[derive(Debug)]
pub(super) struct Row<'a> {
    pub(super) fields: Vec<&'a str>,
    pub(super) separator: char,
    /// What the numbers of the file show of their commas and points.
    pub(super) decimals: Decimals,
    /// The units of length that the row states.
    pub(super) units: Vec<&'a str>,
    /// Whether a single number stands in parentheses, which may mean that it is negative.
    pub(super) has_number_in_parentheses: bool,
    /// Whether a cell between coordinates is empty.
    pub(super) has_empty_coordinate: bool,
    /// The place of the line in its file.
    pub(super) place: Range<usize>,
    /// The corners of the row, as far as it and the headings say.
    pub(super) section: Section,
    /// The corners of the groups of columns in which the row has coordinates; none if there are no groups.
    pub(super) groups: Vec<Section>,
}

impl<'a> Row<'a> {
    /// Splits a line without its remark, at the separator that gives three coordinates, or else several points.
    pub(super) fn parse(place: Range<usize>, line: &'a str) -> Self {
        let line = without_remark(line);
        let present = SEPARATORS
            .into_iter()
            .filter(|c| *c == ' ' || line.contains(*c));
        let has_number_in_parentheses = has_number_in_parentheses(line);
        let rows = present.map(|separator| {
            let (fields, units) = without_units(fields(line, separator), separator);
            Self {
                fields: without_axes(fields),
                separator,
                decimals: Decimals::default(),
                units,
                has_number_in_parentheses,
                has_empty_coordinate: separator != ' ' && has_empty_coordinate(line, separator),
                place: place.clone(),
                section: Section::default(),
                groups: Vec::new(),
            }
        });
        let mut rows: Vec<Self> = rows.collect();
        let best = rows.iter().position(|row| row.coordinates().is_some());
        let best = best.or_else(|| rows.iter().position(|row| !row.places().is_empty()));
        rows.swap_remove(best.unwrap_or_default())
    }

    /// Returns the rows of two tables side by side, in each of which a name stands before three coordinates; `None` for other rows.
    pub(super) fn apart(&self) -> Option<[Self; 2]> {
        let of = |fields: &[&'a str]| Self {
            fields: fields.to_vec(),
            units: self.units.clone(),
            place: self.place.clone(),
            groups: self.groups.clone(),
            ..*self
        };
        let (first, places) = self.found()?;
        let (one, other) = self.fields.split_at(first + 3 * places.len());
        let rows = [of(one), of(other)];
        let is_named = |row: &Self| row.found().is_some_and(|(first, _)| first > 0);
        rows.iter().all(is_named).then_some(rows)
    }

    /// Returns the coordinates of one to four points, consecutive numbers in groups of three, and the index of their first field.
    pub(super) fn found(&self) -> Option<(usize, Vec<[f64; 3]>)> {
        let numbers: Vec<_> = self.fields.iter().map(|field| self.number(field)).collect();
        let mut first = 0;
        for run in numbers.chunk_by(|a, b| a.is_some() == b.is_some()) {
            let values: Vec<f64> = run.iter().flatten().copied().collect();
            if let (places @ [_, ..], []) = values.as_chunks()
                && places.len() <= MOST_POINTS
            {
                return Some((first, places.to_vec()));
            }
            first += run.len();
        }
        None
    }

    /// Returns the coordinates of the point in each group of columns, or those of the only one; none in other rows.
    pub(super) fn places(&self) -> Vec<[f64; 3]> {
        self.found().map(|(_, places)| places).unwrap_or_default()
    }

    /// Returns the three coordinates of a point.
    pub(super) fn coordinates(&self) -> Option<[f64; 3]> {
        match self.places()[..] {
            [at] => Some(at),
            _ => None,
        }
    }

    pub(super) fn numbers(&self) -> Vec<f64> {
        let fields = self.fields.iter();
        fields.filter_map(|field| self.number(field)).collect()
    }

    /// Returns the numbers as the line writes them.
    pub(super) fn written_numbers(&self) -> impl Iterator<Item = &'a str> {
        let fields = self.fields.iter().copied();
        fields.filter(|field| self.number(field).is_some())
    }

    /// Returns the numbers after the first word: numbers before it count rows.
    pub(super) fn numbers_behind_name(&self) -> Vec<f64> {
        let fields = self.fields.iter();
        let behind = fields.skip_while(|field| self.number(field).is_some());
        behind.filter_map(|field| self.number(field)).collect()
    }

    /// Returns whether a number is the last field.
    pub(super) fn ends_with_number(&self) -> bool {
        let last = self.fields.last();
        last.is_some_and(|field| self.number(field).is_some())
    }

    /// Returns whether a field is this word, in small letters.
    pub(super) fn has_field(&self, word: &str) -> bool {
        let mut fields = self.fields.iter();
        fields.any(|field| field.to_lowercase() == word)
    }

    /// Returns whether a minus stands alone before a number.
    pub(super) fn has_lone_sign(&self) -> bool {
        let mut pairs = self.fields.windows(2);
        pairs.any(|pair| match pair {
            [sign, number] => {
                sign.trim_start_matches(MINUS).is_empty() && self.number(number).is_some()
            }
            _ => false,
        })
    }

    /// Returns the first field behind the name that has a digit and is no number, as `261O.5`.
    pub(super) fn misspelt_number(&self) -> Option<&'a str> {
        let mut fields = self.fields.iter().skip(1);
        let is_misspelt = |field: &&&str| {
            field.contains(|c: char| c.is_ascii_digit()) && self.number(field).is_none()
        };
        fields.find(is_misspelt).copied()
    }

    /// Returns the first field of a row in which a mistyped number stands before the coordinates, as `46O` of the left corner before
    /// those of the right one.
    pub(super) fn of_mistyped_group(&self) -> Option<&'a str> {
        let (first, places) = self.found()?;
        let before = self.fields.get(first.checked_sub(1)?);
        let is_mistyped = first > 1 && self.misspelt_number().as_ref() == before;
        let is_short = places.len() < self.groups.len();
        self.fields
            .first()
            .copied()
            .filter(|_| is_mistyped && is_short)
    }

    /// Returns whether the row has any digit, even in a mistyped number.
    pub(super) fn has_digits(&self) -> bool {
        let mut fields = self.fields.iter();
        fields.any(|field| field.contains(|c: char| c.is_ascii_digit()))
    }

    /// Returns whether a field begins like a number, for example `150 mm`.
    pub(super) fn begins_a_number(&self) -> bool {
        let mut fields = self.fields.iter();
        fields.any(|field| {
            let unsigned = field.trim_start_matches(|c| MINUS.contains(&c) || "+.".contains(c));
            unsigned.starts_with(|c: char| c.is_ascii_digit())
        })
    }

    /// Returns the name, which stands before the coordinates, or else after them, as in reports of Lotus.
    pub(super) fn name(&self) -> String {
        let first = self.found().map_or(self.fields.len(), |(first, _)| first);
        let (before, behind) = self.fields.split_at(first);
        let mut words = self.words(before);
        if words.is_empty() {
            words = self.words(behind);
            let is_label = |word: &str| word.eq_ignore_ascii_case("point");
            if words.first().is_some_and(|word| is_label(word)) {
                words.remove(0);
            }
        }
        // The name is next to the coordinates. In a row without coordinates further words may be mistyped numbers.
        let word = if first == self.fields.len() {
            words.first()
        } else {
            words.last()
        };
        match word {
            Some(word) if self.separator != ' ' => (*word).to_owned(),
            _ => words.join(" "),
        }
    }

    /// Returns the columns with words before the first number; none between blanks.
    pub(super) fn columns_before_numbers(&self) -> Vec<&'a str> {
        // Numbers before the words count rows.
        let fields = self.fields.iter().copied();
        let fields = fields.skip_while(|field| self.number(field).is_some());
        let columns = fields.take_while(|field| self.number(field).is_none());
        let columns: Vec<&str> = columns.collect();
        match self.separator {
            ' ' => Vec::new(),
            _ => self.words(&columns),
        }
    }

    /// Returns the heading that the row is for others: its first column, or all words between blanks, but the axes.
    pub(super) fn heading(&self) -> Option<String> {
        let mut words = self.words(&self.fields);
        words.retain(|word| !["x", "y", "z"].contains(&word.to_lowercase().as_str()));
        if self.separator != ' ' {
            words.truncate(1);
        }
        Some(words.join(" ")).filter(|words| !words.is_empty())
    }

    /// Returns the words of all fields, as names are compared, with 0 for each number that can be read.
    pub(super) fn spelled(&self) -> String {
        let words = self.fields.iter().map(|field| match self.number(field) {
            Some(_) => "0",
            None => field,
        });
        spelled(&words.collect::<Vec<_>>().join(" "))
    }

    /// Returns the fields that are not numbers, sides, types, units or mere signs.
    fn words(&self, fields: &[&'a str]) -> Vec<&'a str> {
        let is_word = |field: &&str| {
            let is_sign = !field.contains(char::is_alphanumeric);
            let is_type = ["real", "deg", "rad", "array", "np.array", "numpy.array"]
                .iter()
                .any(|name| field.eq_ignore_ascii_case(name));
            let is_type = is_type || unit(field).is_some();
            self.number(field).is_none() && sides_of(field).is_none() && !is_type && !is_sign
        };
        fields.iter().copied().filter(is_word).collect()
    }

    fn number(&self, field: &str) -> Option<f64> {
        // Between commas only a field in quotes has a comma.
        number(field, self.separator != ' ', self.decimals)
    }
}
