//! The contents of a hardpoint file, in any format.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use super::names::{key_of, spelled};
use super::side::{End, Side, Sides, end_of};
use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::{Axes, Length};

/// A point of a file.
#[derive(Clone, Debug)]
pub(super) struct Hardpoint {
    /// As the file writes it.
    pub(super) name: String,
    /// The name in the spelling in which names are compared.
    pub(super) key: String,
    pub(super) side: Option<Side>,
    /// Coordinates in the file's axes.
    pub(super) at: [f64; 3],
    pub(super) place: Range<usize>,
}

/// A number of a file that is not a coordinate.
#[derive(Clone, Debug)]
pub(super) struct Number {
    pub(super) key: String,
    pub(super) side: Option<Side>,
    pub(super) value: f64,
    pub(super) place: Range<usize>,
}

/// The end of Lotus' names for centres of mass.
const CENTRE_OF_MASS: &str = "c_of_g";

/// The contents of a file.
#[derive(Debug)]
pub(super) struct Hardpoints<'a> {
    pub(super) source: &'a Source,
    pub(super) points: Vec<Hardpoint>,
    pub(super) numbers: Vec<Number>,
    /// Sentences about rows that are not used.
    pub(super) unread: Vec<String>,
    /// The unit of lengths; `None` if the file does not state it.
    pub(super) unit: Option<Length>,
    /// The ends of the vehicle that the file names, each with its place.
    ends: Vec<(End, Range<usize>)>,
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
            unread: Vec::new(),
            unit: None,
            ends: Vec::new(),
            radians: false,
            usual,
        }
    }

    /// Notes that a line names an end of the vehicle.
    pub(super) fn add_end(&mut self, end: Option<End>, place: Range<usize>) {
        self.ends.extend(end.map(|end| (end, place)));
    }

    /// Returns the end of the vehicle to which the suspension belongs, and the reason; `None` if the file does not say or
    /// names both. A name of the file counts only if its lines say nothing.
    pub(super) fn end(&self) -> Option<(End, String)> {
        let in_words = |end: End, at: &str| {
            let end = match end {
                End::Front => "front",
                End::Rear => "rear",
            };
            format!("{at} says {end}")
        };
        let Some((end, place)) = self.ends.first() else {
            let name = Path::new(self.source.name()).file_stem()?;
            let end = end_of(&spelled(&name.to_string_lossy()))?;
            return Some((end, in_words(end, "the name of the file")));
        };
        let is_same = self.ends.iter().all(|(other, _)| other == end);
        is_same.then(|| (*end, in_words(*end, &self.line(place))))
    }

    /// Adds a point, on both sides if it is mirrored. Skips centres of mass.
    pub(super) fn add_point(
        &mut self,
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
            (Sides::One(side), _) | (_, Sides::One(side)) => vec![(Some(side), at)],
            _ => vec![(None, at)],
        };
        let name: String = name.chars().filter(|c| !c.is_control()).collect();
        self.points
            .extend(each.into_iter().map(|(side, at)| Hardpoint {
                name: name.clone(),
                key: key.clone(),
                side,
                at,
                place: place.clone(),
            }));
    }

    /// Adds a number.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the file has another number of that name on the same side.
    pub(super) fn add_number(
        &mut self,
        name: &str,
        sides: Sides,
        value: f64,
        place: Range<usize>,
    ) -> Result<(), Failure> {
        let (key, prefixed) = key_of(name);
        let side = match (prefixed, sides) {
            (Sides::One(side), _) | (_, Sides::One(side)) => Some(side),
            _ => None,
        };
        let same = |other: &&Number| other.key == key && other.side == side;
        if let Some(first) = self
            .numbers
            .iter()
            .find(same)
            .filter(|first| first.value != value)
        {
            let message = format!(
                "`{name}` stands in {} already, as {}; leave one of them",
                self.line(&first.place),
                first.value
            );
            return Err(self.source.refuse(&place, message));
        }
        self.numbers.push(Number {
            key,
            side,
            value,
            place,
        });
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
                let message = format!(
                    "point `{}` stands in {} already; leave one of them, and give each axle of a vehicle a file of its own",
                    point.name,
                    self.line(&first.place)
                );
                return Err(self.source.refuse(&point.place, message));
            }
        }
        Ok(points)
    }

    /// Returns `file:line` of a place.
    pub(super) fn line(&self, place: &Range<usize>) -> String {
        let place = self.source.place(place);
        let line = place.rsplit_once(':').map(|(line, _)| line.to_owned());
        line.unwrap_or(place)
    }
}
