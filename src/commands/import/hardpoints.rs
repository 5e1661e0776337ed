//! The contents of a hardpoint file, in any format.

use std::collections::BTreeMap;
use std::ops::Range;

use clap::ValueEnum;

use super::names::spelled;
use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::{Axes, Length};

/// A side of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Side {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

impl Side {
    /// The one across the vehicle.
    pub(super) fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// In words.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// The sides of the vehicle to which a row of a file belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sides {
    /// The row does not say, or its point is in the middle.
    Unsaid,
    /// One.
    One(Side),
    /// Both: it has the left one, and the right one is its mirror image.
    Mirrored,
}

/// A point of a file.
#[derive(Clone, Debug)]
pub(super) struct Hardpoint {
    /// As the file writes it.
    pub(super) name: String,
    /// In the spelling that names are compared in.
    pub(super) key: String,
    pub(super) side: Option<Side>,
    /// In the file's axes.
    pub(super) at: [f64; 3],
    pub(super) place: Range<usize>,
}

/// A number of a file that is no coordinate.
#[derive(Clone, Debug)]
pub(super) struct Number {
    pub(super) key: String,
    pub(super) side: Option<Side>,
    pub(super) value: f64,
    pub(super) place: Range<usize>,
}

/// How the names of points end that Lotus has for the masses of parts.
const CENTRE_OF_MASS: &str = "c_of_g";

/// What a file says.
#[derive(Debug)]
pub(super) struct Hardpoints<'a> {
    pub(super) source: &'a Source,
    pub(super) points: Vec<Hardpoint>,
    pub(super) numbers: Vec<Number>,
    /// What is to be said of rows that are not used, a sentence each.
    pub(super) unread: Vec<String>,
    /// The unit of lengths, where the file states it.
    pub(super) unit: Option<Length>,
    /// Whether its angles are in radians.
    pub(super) radians: bool,
    /// The axes that are usual in such files.
    pub(super) usual: Axes,
}

impl<'a> Hardpoints<'a> {
    /// Of a file that has not been read yet.
    pub(super) fn new(source: &'a Source, usual: Axes) -> Self {
        Self {
            source,
            points: Vec::new(),
            numbers: Vec::new(),
            unread: Vec::new(),
            unit: None,
            radians: false,
            usual,
        }
    }

    /// Adds a point, on both sides where it is mirrored; a centre of mass is none.
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
    /// [`Failure::Input`] where its side has another one under the name.
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

    /// The points of one corner, and those of no side; of two corners the left one unless the other is wanted.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] where a name stands twice.
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
                    "point `{}` stands in {} already; leave one of them",
                    point.name,
                    self.line(&first.place)
                );
                return Err(self.source.refuse(&point.place, message));
            }
        }
        Ok(points)
    }

    /// `file:line` of a place.
    pub(super) fn line(&self, place: &Range<usize>) -> String {
        let place = self.source.place(place);
        let line = place.rsplit_once(':').map(|(line, _)| line.to_owned());
        line.unwrap_or(place)
    }
}

/// A name as it is compared, without what Adams/Car puts before it: the model, and hpl_, hpr_ or hps_ for left, right
/// and single; and the side that this says.
pub(super) fn key_of(name: &str) -> (String, Sides) {
    let own = name.rsplit('.').next().unwrap_or(name);
    let key = spelled(own);
    let prefixes = [
        ("hpl_", Sides::One(Side::Left)),
        ("hpr_", Sides::One(Side::Right)),
        ("pvl_", Sides::One(Side::Left)),
        ("pvr_", Sides::One(Side::Right)),
        ("hps_", Sides::Unsaid),
        ("pvs_", Sides::Unsaid),
    ];
    let mut found = prefixes.into_iter();
    let found = found.find_map(|(prefix, side)| Some((key.strip_prefix(prefix)?.to_owned(), side)));
    found.unwrap_or((key, Sides::Unsaid))
}
