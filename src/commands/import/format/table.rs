//! Tables of points: a name and three numbers in each line, with headings and remarks between them.

mod adams_view;
mod angles;
mod broken_cells;
mod coordinate_columns;
mod line_per_axis;
mod merged_cells;
mod names_as_columns;
mod row_name;
mod spreadsheet_errors;
mod thousands;

use std::mem::take;
use std::ops::Range;

use super::add_row::add;
use super::heading::{
    check_columns, column_groups, end_of_heading, side_of_heading, units_of_heading,
    with_axes_apart,
};
use super::lines::lines_with_tabs;
use super::row::Row;
use crate::commands::import::hardpoints::Hardpoints;
use crate::commands::import::names::Names;
use crate::commands::import::spelling::{key_of, spelled};
use crate::failure::Failure;
use crate::file::Source;
use crate::interrupt;
use crate::mechanism::Axes;
use crate::vehicle_corner::Section;
use adams_view::with_commands_as_rows;
use angles::check_angle;
pub(in crate::commands::import) use angles::is_name_of_other_angle;
use broken_cells::with_whole_cells;
use coordinate_columns::CoordinateColumns;
use line_per_axis::joined;
use merged_cells::with_merged_cells;
use names_as_columns::with_names_in_rows;
use row_name::{name_of, with_whole_name};
use spreadsheet_errors::first_error;
use thousands::Thousands;

/// Reads a table.
///
/// # Errors
///
/// [`Failure::Input`] at a known point without three numbers, and at columns in another order; [`Failure::Interrupted`].
pub(super) fn read<'a>(source: &'a Source, names: &Names) -> Result<Hardpoints<'a>, Failure> {
    let lines = with_commands_as_rows(lines_with_tabs(source.text()));
    let lines = with_merged_cells(with_whole_cells(lines));
    let lines = joined(with_names_in_rows(lines.into_iter(), names).into_iter());
    let mut table = Table {
        stated: Hardpoints::new(source, Axes::Iso),
        names,
        section: Section::default(),
        heading: String::new(),
        columns: None,
        groups: Vec::new(),
        thousands: Thousands::of(lines.iter().map(|(_, line)| &**line), names),
    };
    for (place, line) in lines {
        if interrupt::unless_set(interrupt::flag()).is_break() {
            let message = format!("{}: interrupted before it was read", source.name());
            return Err(Failure::Interrupted(message));
        }
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
    columns: Option<CoordinateColumns>,
    /// The corners of the groups of columns, if a heading names them.
    groups: Vec<Section>,
    thousands: Thousands,
}

impl Table<'_, '_> {
    fn read_line(&mut self, place: Range<usize>, line: &str) -> Result<(), Failure> {
        let whole = line;
        let columns = self.columns.as_ref();
        let line = &*columns.map_or(line.into(), |columns| columns.without_others(line));
        let (named, remarked) = with_whole_name(line, self.names);
        let mut row = Row {
            decimals: self.thousands.decimals,
            ..Row::parse(place.clone(), &named)
        };
        row.groups = self.groups_of(&row, whole);
        self.check_cells(&row, line)?;
        let section = remarked.or(self.section);
        if let Some(rows) = self.side_by_side(&row)? {
            for (mut row, group) in rows.into_iter().zip(self.groups.clone()) {
                self.read_row(&mut row, line, group.or(section))?;
            }
            return Ok(());
        }
        self.read_row(&mut row, line, section)?;
        if row.numbers().is_empty() || row.is_title() {
            let words = with_axes_apart(&spelled(line));
            self.read_heading(&row, &self.names.heading_in_english(&words))?;
            self.columns = CoordinateColumns::of_heading(line).or(take(&mut self.columns));
        }
        Ok(())
    }

    /// Refuses an error of the spreadsheet in place of a coordinate or a number that is known.
    fn check_cells(&self, row: &Row<'_>, line: &str) -> Result<(), Failure> {
        let Some((before, cell)) = first_error(line) else {
            return Ok(());
        };
        let read = Row::parse(row.place.clone(), before);
        let name = name_of(&read, &self.heading, self.names);
        let (key, _) = key_of(&name);
        let is_short = read.places().len() < self.groups.len().max(1);
        let is_number = self.names.is_number(&key) && read.numbers().is_empty();
        if !(is_number || is_short && self.names.is_point(&key)) {
            return Ok(());
        }
        let message = format!(
            "the cell `{cell}` of `{name}` is an error of the spreadsheet: correct it there and save the table again"
        );
        Err(self.stated.source.refuse(&row.place, message))
    }

    /// Returns the groups of columns in which a line has numbers. A number in the first one alone is of all.
    fn groups_of(&self, row: &Row<'_>, line: &str) -> Vec<Section> {
        let groups = &self.groups;
        let filled = match &self.columns {
            Some(columns) => columns.filled(line, groups),
            None => groups.clone(),
        };
        let is_first = filled.len() == 1 && filled.first() == groups.first();
        let is_of_all = is_first && self.names.is_number(&key_of(&row.name()).0);
        if is_of_all { groups.clone() } else { filled }
    }

    /// Returns the rows of two tables side by side that a line has; `None` for other lines.
    fn side_by_side<'r>(&self, row: &Row<'r>) -> Result<Option<[Row<'r>; 2]>, Failure> {
        let is_point = |row: &Row<'_>| self.names.is_point(&key_of(&row.name()).0);
        let rows = row.apart().filter(|[_, other]| is_point(other));
        match rows {
            Some(_) if self.groups.len() != 2 => {
                Err(self.stated.source.refuse(&row.place, SIDE_BY_SIDE))
            }
            _ => Ok(rows),
        }
    }

    fn read_row(&mut self, row: &mut Row<'_>, line: &str, section: Section) -> Result<(), Failure> {
        row.section = Section {
            end: row.end().or(section.end),
            ..section
        };
        let name = name_of(row, &self.heading, self.names);
        check_angle(&self.stated, (row, line), &name, self.names)?;
        add(&mut self.stated, row, &name, self.names)?;
        if self.names.is_point(&key_of(&name).0) {
            self.thousands.add(row);
        }
        self.stated.add_end(row.section.end, row.place.clone());
        Ok(())
    }

    fn read_heading(&mut self, row: &Row<'_>, words: &str) -> Result<(), Failure> {
        let stated = &mut self.stated;
        let end = end_of_heading(words);
        stated.add_end(end, row.place.clone());
        let words: Vec<&str> = words.split('_').collect();
        let side = side_of_heading(&words);
        let groups = column_groups(&words, &self.groups);
        // A code above a group of columns says nothing of the others.
        let code = row.end().filter(|_| groups.is_none());
        self.section = self.section.below(end.or(code), side);
        match (end, side) {
            (None, None) if groups.is_none() => {
                if let Some(heading) = row.heading() {
                    self.heading = heading;
                    stated.unread_heading = Some(row.place.clone());
                }
            }
            _ => self.heading.clear(),
        }
        self.groups = groups.unwrap_or(take(&mut self.groups));
        check_columns(&words).map_err(|message| stated.source.refuse(&row.place, message))?;
        let mut units = units_of_heading(&words).into_iter();
        units.try_for_each(|unit| stated.state_unit(unit, &row.place))
    }
}

const SIDE_BY_SIDE: &str = "two points stand side by side: write `Left` and `Right`, or `Front` and `Rear`, in a heading above the \
                            tables, or one table below the other";
