//! The contents of a hardpoint file, in any format.

use std::collections::BTreeMap;
use std::ops::Range;

use super::length_units::length;
use super::spelling::key_of;
use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::{Axes, Length};
use crate::vehicle_corner::{End, Section, Side, Sides, remedy};

/// A point of a file.
#[derive(Clone, Debug)]
pub(super) struct Hardpoint {
    /// As the file writes it.
    pub(super) name: String,
    /// The name in the spelling in which names are compared.
    pub(super) key: String,
    pub(super) side: Option<Side>,
    pub(super) end: Option<End>,
    /// Coordinates in the file's axes.
    pub(super) at: [f64; 3],
    pub(super) place: Range<usize>,
}

/// A number of a file that is not a coordinate.
#[derive(Clone, Debug)]
pub(super) struct Number {
    /// As the file writes it.
    name: String,
    pub(super) key: String,
    pub(super) side: Option<Side>,
    pub(super) end: Option<End>,
    pub(super) value: f64,
    /// The unit that the row states; others are as the coordinates.
    pub(super) unit: Option<Length>,
    pub(super) place: Range<usize>,
}

/// A row of numbers whose name is unknown.
#[derive(Clone, Debug)]
pub(super) struct UnknownNumber {
    /// As the file writes it.
    pub(super) name: String,
    pub(super) end: Option<End>,
    pub(super) place: Range<usize>,
}

/// The end of Lotus' names for centres of mass.
const CENTRE_OF_MASS: &str = "c_of_g";

/// The contents of a file.
#[derive(Clone, Debug)]
pub(super) struct Hardpoints<'a> {
    pub(super) source: &'a Source,
    pub(super) points: Vec<Hardpoint>,
    pub(super) numbers: Vec<Number>,
    pub(super) unknown_numbers: Vec<UnknownNumber>,
    /// The unit of lengths; `None` if the file does not state it.
    pub(super) unit: Option<Length>,
    /// The ends of the vehicle that the file names, each with its place.
    pub(super) ends: Vec<(End, Range<usize>)>,
    /// The end of the vehicle that `--end` names.
    pub(super) wanted: Option<End>,
    /// The last heading that says nothing that import knows.
    pub(super) unread_heading: Option<Range<usize>>,
    /// Whether the file's angles are in radians.
    pub(super) radians: bool,
    /// The usual axes of such files.
    pub(super) usual: Axes,
}

impl<'a> Hardpoints<'a> {
    /// Starts the contents of a file, without points.
    pub(super) fn new(source: &'a Source, usual: Axes) -> Self {
        Self {
            source,
            points: Vec::new(),
            numbers: Vec::new(),
            unknown_numbers: Vec::new(),
            unit: None,
            ends: Vec::new(),
            wanted: None,
            unread_heading: None,
            radians: false,
            usual,
        }
    }

    /// Adds a point of a section, on both sides if it is mirrored. Skips centres of mass.
    pub(super) fn add_point(
        &mut self,
        section: Section,
        name: &str,
        sides: Sides,
        at: [f64; 3],
        place: Range<usize>,
    ) {
        let [x, y, z] = at;
        let (key, prefixed) = key_of(name);
        if key.ends_with(CENTRE_OF_MASS) {
            return;
        }
        let each = match (prefixed, sides) {
            (Sides::Unsaid, Sides::Mirrored) => {
                vec![(Some(Side::Left), at), (Some(Side::Right), [x, 0.0 - y, z])]
            }
            _ => vec![(side_of_row(section, prefixed, sides), at)],
        };
        let name: String = name.chars().filter(|c| !c.is_control()).collect();
        self.points
            .extend(each.into_iter().map(|(side, at)| Hardpoint {
                name: name.clone(),
                key: key.clone(),
                side,
                end: section.end,
                at,
                place: place.clone(),
            }));
    }

    /// States the unit of the coordinates.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if motion files do not have the unit, or the file states another one already.
    pub(super) fn state_unit(&mut self, word: &str, place: &Range<usize>) -> Result<(), Failure> {
        let refuse = |message: String| self.source.refuse(place, message);
        let unit = length(word).map_err(refuse)?;
        match self.unit.filter(|before| *before != unit) {
            Some(before) => Err(refuse(format!(
                "lengths are in `{}` here, and in `{}` before: convert them to one unit",
                unit.symbol(),
                before.symbol()
            ))),
            None => {
                self.unit = Some(unit);
                Ok(())
            }
        }
    }

    /// Adds a number of a section, which has a unit if it is a length whose unit its row states.
    pub(super) fn add_number(
        &mut self,
        section: Section,
        name: &str,
        sides: Sides,
        (value, unit): (f64, Option<Length>),
        place: Range<usize>,
    ) {
        let (key, prefixed) = key_of(name);
        self.numbers.push(Number {
            name: name.to_owned(),
            key,
            side: side_of_row(section, prefixed, sides),
            end: section.end,
            value,
            unit,
            place,
        });
    }

    /// Refuses two values of one number on the same side.
    pub(super) fn check_numbers(&self) -> Result<(), Failure> {
        for (place, number) in self.numbers.iter().enumerate() {
            let mut before = self.numbers[..place].iter();
            let first = before.find(|other| other.key == number.key && other.side == number.side);
            if let Some(first) = first.filter(|first| first.value != number.value) {
                let message = format!(
                    "`{}` stands in {} already, as {}; {}",
                    number.name,
                    self.line(&first.place),
                    first.value,
                    remedy(first.end, number.end)
                );
                return Err(self.source.refuse(&number.place, message));
            }
        }
        Ok(())
    }

    /// Returns the points of one corner and those without a side. Of two corners it takes the left one unless `wanted` is
    /// the right one.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if a name occurs twice.
    pub(super) fn of_side(&self, wanted: Option<Side>) -> Result<Vec<&Hardpoint>, Failure> {
        let has = |side: Side| self.points.iter().any(|point| point.side == Some(side));
        let wanted = wanted.unwrap_or(Side::Left);
        let side = if has(wanted) { wanted } else { wanted.other() };
        let points = self.points.iter();
        let points = points.filter(|point| point.side.is_none_or(|other| other == side));
        let points: Vec<&Hardpoint> = points.collect();
        let mut found = BTreeMap::new();
        for point in &points {
            if let Some(first) = found.insert(&point.key, point) {
                let message = self.twice(first, point);
                return Err(self.source.refuse(&point.place, message));
            }
        }
        Ok(points)
    }

    /// Returns what to do about two points of one name and corner.
    fn twice(&self, first: &Hardpoint, second: &Hardpoint) -> String {
        let is_same_row = first.place == second.place;
        let at = match is_same_row {
            true => "this row".to_owned(),
            false => self.line(&first.place),
        };
        let remedy = match is_same_row && first.end == second.end {
            true => {
                "write above the columns which are `Left` and which `Right`, or of four corners `FL`, `FR`, `RL` and `RR`"
            }
            false => remedy(first.end, second.end),
        };
        format!("point `{}` stands in {at} already; {remedy}", second.name)
    }

    /// Returns the name of a point with its place.
    pub(super) fn quoted(&self, point: &Hardpoint) -> String {
        format!("`{}` ({})", point.name, self.line(&point.place))
    }

    /// Returns `file:line` of a place.
    pub(super) fn line(&self, place: &Range<usize>) -> String {
        let place = self.source.place(place);
        let line = place.rsplit_once(':').map(|(line, _)| line.to_owned());
        line.unwrap_or(place)
    }
}

/// Returns the side of a row: of its name, or else of its fields, or else of the heading above it.
fn side_of_row(section: Section, prefixed: Sides, sides: Sides) -> Option<Side> {
    match (prefixed, sides) {
        (Sides::One(side), _) | (_, Sides::One(side)) => Some(side),
        _ => section.side,
    }
}
