//! Tables of points: a name and three numbers in each line, with headings and remarks between them.

use std::mem::take;
use std::ops::Range;

use super::columns::Columns;
use super::hardpoints::Hardpoints;
use super::heading::{
    check_columns, column_groups, end_of_heading, length, side_of_heading, unit, units_of_heading,
};
use super::line_per_axis::joined;
use super::names::{Names, key_of, spelled};
use super::row::{Row, lines};
use super::row_name::{name_of, with_whole_name};
use super::thousands::Thousands;
use super::unclear::{check_angle, check_group, check_row};
use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::Axes;
use crate::side::Section;

/// Reads a table.
///
/// # Errors
///
/// [`Failure::Input`] at a known point without three numbers, and at columns in another order.
pub(super) fn read<'a>(source: &'a Source, names: &Names) -> Result<Hardpoints<'a>, Failure> {
    let mut table = Table {
        stated: Hardpoints::new(source, Axes::Iso),
        names,
        section: Section::default(),
        heading: String::new(),
        columns: None,
        thousands: Thousands::default(),
    };
    for (place, line) in joined(lines(source.text())) {
        table.read_line(place, &line)?;
    }
    table.thousands.check(source)?;
    let mut stated = table.stated;
    stated.forget_ends_behind_points();
    let mut points = stated.points.iter();
    if points.any(|point| point.name.to_lowercase().starts_with("hp")) {
        stated.usual = Axes::Adams;
    }
    Ok(stated)
}

/// A table that is read line by line.
struct Table<'a, 'n> {
    stated: Hardpoints<'a>,
    names: &'n Names,
    /// The corner that the headings above the line state.
    section: Section,
    /// The last heading that may be a part of names.
    heading: String,
    /// The columns of coordinates, if a heading names them.
    columns: Option<Columns>,
    thousands: Thousands,
}

impl Table<'_, '_> {
    fn read_line(&mut self, place: Range<usize>, line: &str) -> Result<(), Failure> {
        let columns = self.columns.as_ref();
        let line = &*columns.map_or(line.into(), |columns| columns.without_others(line));
        let (named, remarked) = with_whole_name(line, self.names);
        let row = Row::parse(place.clone(), &named);
        let section = remarked.or(self.section);
        if let (Some(rows), Some(groups)) = (self.side_by_side(&row)?, self.stated.groups) {
            for (row, group) in rows.iter().zip(groups) {
                self.read_row(row, line, group.or(section))?;
            }
            return Ok(());
        }
        self.read_row(&row, line, section)?;
        if row.numbers().is_empty() || row.is_title() {
            self.read_heading(&row, &spelled(line))?;
            self.columns = Columns::of_heading(line).or(take(&mut self.columns));
        }
        Ok(())
    }

    /// Returns the rows of two tables side by side that a line has; `None` for other lines.
    fn side_by_side<'r>(&self, row: &Row<'r>) -> Result<Option<[Row<'r>; 2]>, Failure> {
        let is_point = |row: &Row<'_>| self.names.is_point(&key_of(&row.name()).0);
        let rows = row.apart().filter(|[_, other]| is_point(other));
        match (&rows, self.stated.groups) {
            (Some(_), None) => Err(self.stated.source.refuse(&row.place, SIDE_BY_SIDE)),
            _ => Ok(rows),
        }
    }

    fn read_row(&mut self, row: &Row<'_>, line: &str, section: Section) -> Result<(), Failure> {
        self.stated.section = Section {
            end: row.end().or(section.end),
            ..section
        };
        let name = name_of(row, &self.heading, self.names);
        check_angle(&self.stated, (row, line), &name, self.names)?;
        add(&mut self.stated, row, &name, self.names)?;
        if self.names.is_point(&key_of(&name).0) {
            self.thousands.add(row);
        }
        self.stated
            .add_end(self.stated.section.end, row.place.clone());
        Ok(())
    }

    fn read_heading(&mut self, row: &Row<'_>, words: &str) -> Result<(), Failure> {
        let stated = &mut self.stated;
        let end = end_of_heading(words);
        stated.add_end(end, row.place.clone());
        let words: Vec<&str> = words.split('_').collect();
        let side = side_of_heading(&words);
        self.section = self.section.below(end.or(row.end()), side);
        stated.groups = column_groups(&words).or(stated.groups);
        match (end, side) {
            (None, None) => self.heading = row.heading().unwrap_or(take(&mut self.heading)),
            _ => self.heading.clear(),
        }
        check_columns(&words).map_err(|message| stated.source.refuse(&row.place, message))?;
        let mut units = units_of_heading(&words).into_iter();
        units.try_for_each(|unit| stated.state_unit(unit, &row.place))
    }
}

const SIDE_BY_SIDE: &str = "two points stand side by side: write `Left` and `Right`, or `Front` and `Rear`, in a heading above the \
                            tables, or one table below the other";

/// Adds the point or the number of a row under a name; skips other rows.
///
/// # Errors
///
/// [`Failure::Input`] at a known point without three numbers, at an angle or radius that cannot be read, and at a sign apart
/// from its number or a number in parentheses.
pub(super) fn add(
    stated: &mut Hardpoints<'_>,
    row: &Row<'_>,
    name: &str,
    names: &Names,
) -> Result<(), Failure> {
    let (key, _) = key_of(name);
    if names.is_point(&key) || names.is_number(&key) {
        check_row(stated, row)?;
    }
    let places = placed(row, stated.groups);
    if places.is_empty()
        && let Some(name) = before_numbers(&row.spelled(), names)
    {
        return Err(misread(stated, name, row, names));
    }
    if names.is_point(&key) && !places.is_empty() {
        for unit in &row.units {
            stated.state_unit(unit, &row.place)?;
        }
        if let [(_, [_, y, _])] = places[..] {
            check_group(stated, row, (name, y))?;
        }
    }
    match row.numbers()[..] {
        _ if !places.is_empty() && !key.is_empty() => {
            let section = stated.section;
            for (group, at) in places {
                stated.section = group.or(section);
                stated.add_point(name, row.sides(), at, row.place.clone());
            }
            stated.section = section;
        }
        _ if names.is_number(&key) && row.has_digits() => match row.numbers_behind_name()[..] {
            [value] => {
                let unit = row.units.first().map(|unit| length(unit)).transpose();
                let unit = unit.map_err(|message| stated.source.refuse(&row.place, message))?;
                stated.add_number(name, row.sides(), (value, unit), row.place.clone());
            }
            _ => return Err(misread(stated, name, row, names)),
        },
        _ if names.is_point(&key) && row.begins_a_number() => {
            return Err(misread(stated, name, row, names));
        }
        [_] => {
            let meant = names.number_meant(&key);
            let place = stated.line(&row.place);
            let said =
                meant.map(|meant| format!("`{name}` ({place}) is not used: did you mean {meant}?"));
            stated.unread.extend(said);
        }
        _ => {}
    }
    Ok(())
}

/// Returns the coordinates of a row's points with their corners.
fn placed(row: &Row<'_>, groups: Option<[Section; 2]>) -> Vec<(Section, [f64; 3])> {
    match (&row.places()[..], groups) {
        ([at], _) => vec![(Section::default(), *at)],
        ([one, other], Some([of_one, of_other])) => vec![(of_one, *one), (of_other, *other)],
        _ => Vec::new(),
    }
}

/// Returns the mistake of a row with a known name: what the row should have.
fn misread(stated: &Hardpoints<'_>, name: &str, row: &Row<'_>, names: &Names) -> Failure {
    let message = if names.is_number(&key_of(name).0) {
        format!("`{name}` needs one number after it, with a decimal point")
    } else if row.numbers_behind_name().len() == 6 {
        format!(
            "point `{name}` has six numbers: say in a heading above the columns which are `Left` and which `Right` (or `Front`, \
             `Rear`), or give each a row of its own"
        )
    } else {
        format!(
            "point `{name}` needs three numbers in a row: x, y, z, with decimal points and no sign for thousands"
        )
    };
    stated.source.refuse(&row.place, message)
}

/// Returns a known name at the start of a row's words if nothing but numbers, at least two, with axes and units follow it: a
/// row that cannot be read, for example with decimal commas between blanks.
fn before_numbers<'a>(words: &'a str, names: &Names) -> Option<&'a str> {
    let has_digit = |word: &&str| word.contains(|c: char| c.is_ascii_digit());
    let is_said = |word: &str| ["x", "y", "z"].contains(&word) || unit(word).is_some();
    let ends = words.match_indices('_').map(|(end, _)| end);
    ends.filter_map(|end| {
        let (name, behind) = (&words[..end], &words[end + 1..]);
        let numbers = behind.split('_').filter(has_digit).count();
        let is_numbers = behind
            .split('_')
            .all(|word| has_digit(&word) || is_said(word));
        let (key, _) = key_of(name);
        let is_known = names.is_number(&key) || names.is_point(&key);
        (is_known && is_numbers && numbers > 1).then_some(name)
    })
    .next_back()
}
