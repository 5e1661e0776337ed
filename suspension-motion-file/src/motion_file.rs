//! The motion file: one mechanism, its lengths, the instants and the drives.

use std::collections::BTreeMap;

use nalgebra::Vector3;
use serde::Deserialize;
use toml::Spanned;

use crate::coefficients::Coefficients;
use crate::explain::explained;
use crate::failure::Failure;
use crate::load::LoadCase;
use crate::mass::MassTable;
use crate::position::{Offset, Position};
use crate::source::Source;
use crate::spring::SpringTable;
use crate::table::Table;
use crate::tune::TuneTable;
use crate::vehicle::VehicleTable;
use crate::{Angle, Axes, Length, Unit};

/// A motion file as written; names and values are not checked yet.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MotionFile {
    /// The linkage's name: one of the catalogue's, or that of one's own.
    pub linkage: Option<Spanned<String>>,
    /// In place of a name, the file that has the listing, beside this one.
    pub listing: Option<Spanned<String>>,
    /// In place of a name, the statements of the listing.
    pub statements: Option<Spanned<String>>,
    /// The unit of all lengths and coordinates, in the file and in the results.
    #[serde(rename = "unit")]
    pub length: Length,
    /// The unit of all angles, in the file and in the results.
    #[serde(default)]
    pub angle: Angle,
    /// The axes of all points, offsets and statements, in the file and in the results.
    #[serde(default)]
    pub axes: Axes,
    /// Every point of the linkage: chassis points, free points, markers. Those that the listing states may be
    /// left out.
    #[serde(default = "no_points")]
    pub points: Table<Position>,
    /// The lengths of links and bodies; with them the points are a rough guess.
    pub lengths: Option<Table<f64>>,
    /// The drives' values at which the mechanism is assembled and markers are attached.
    pub design: Option<Table<f64>>,
    /// What the listing does not say of the vehicle.
    pub vehicle: Option<Spanned<VehicleTable>>,
    /// Springs and anti-roll bars by name.
    pub springs: Option<Table<SpringTable>>,
    /// Masses of moving parts by name.
    pub masses: Option<Table<MassTable>>,
    /// Load cases by name, each with what acts where.
    pub loads: Option<Table<LoadCase>>,
    /// Standard deviations of points and links by name, in the unit.
    pub tolerances: Option<Table<f64>>,
    /// What may be moved to reach which curves.
    pub tune: Option<Spanned<TuneTable>>,
    /// The instants.
    pub time: Spanned<Time>,
    /// Each drive as a polynomial of time in seconds.
    pub drives: Table<Coefficients>,
}

impl MotionFile {
    /// Reads the text of a motion file.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] with the place of the first mistake.
    pub fn parse(source: &Source) -> Result<Self, Failure> {
        toml::from_str(source.text()).map_err(|error| {
            let span = error.span().unwrap_or(0..0);
            let message = explained(error.message(), source, span.start);
            source.refuse(&span, message)
        })
    }

    /// Its units.
    pub fn unit(&self) -> Unit {
        Unit {
            length: self.length,
            angle: self.angle,
        }
    }

    /// The same file with the values of some drives and measures, those that are angles, in radians.
    pub fn in_radians<'a>(mut self, angles: impl Iterator<Item = &'a str>) -> Self {
        let radian = self.angle.radian();
        for name in angles {
            let design = self.design.as_mut();
            if let Some(value) = design.and_then(|values| values.get_mut().get_mut(name)) {
                *value.get_mut() /= radian;
            }
            let law = self.drives.get_mut().get_mut(name);
            for coefficient in law.into_iter().flat_map(|law| &mut law.get_mut().0) {
                *coefficient /= radian;
            }
        }
        self
    }

    /// Markers that are stated off another point, each with that one, by their numbers among `points`.
    pub fn followers(&self, points: &[String]) -> Vec<[usize; 2]> {
        let number = |name: &str| points.iter().position(|point| point == name);
        let stated = self.points.get_ref().iter();
        let pairs = stated.filter_map(|(name, position)| match position.get_ref() {
            Position::Off(Offset { from, .. }) => {
                Some([number(name.get_ref())?, number(from.get_ref())?])
            }
            Position::At(_) => None,
        });
        pairs.collect()
    }

    /// The same file with its points in coordinates whose origin is at `origin`.
    pub fn seen_from(mut self, origin: [f64; 3]) -> Self {
        for position in self.points.get_mut().values_mut() {
            if let Position::At(at) = position.get_mut() {
                for (x, origin) in at.iter_mut().zip(origin) {
                    *x -= origin;
                }
            }
        }
        self
    }

    /// The same file with its points, offsets and masses in other axes; what else it states stays.
    pub fn turned(mut self, axes: Axes) -> Self {
        let from = self.axes;
        let turned = |vector: Vector3<f64>| axes.turned(from.turned(vector));
        for position in self.points.get_mut().values_mut() {
            let (Position::At(at) | Position::Off(Offset { offset: at, .. })) = position.get_mut();
            *at = turned((*at).into()).into();
        }
        for mass in self
            .masses
            .iter_mut()
            .flat_map(|table| table.get_mut().values_mut())
        {
            if let MassTable::OfBody(body) = mass.get_mut() {
                body.turn(turned);
            }
        }
        Self { axes, ..self }
    }

    /// The same file with the drives' values less by what `offset` has for their names.
    pub fn driven_from<'a>(mut self, offset: impl Iterator<Item = (&'a str, f64)>) -> Self {
        for (name, offset) in offset {
            let design = self.design.as_mut();
            if let Some(value) = design.and_then(|values| values.get_mut().get_mut(name)) {
                *value.get_mut() -= offset;
            }
            let law = self.drives.get_mut().get_mut(name);
            if let Some(constant) = law.and_then(|law| law.get_mut().0.first_mut()) {
                *constant -= offset;
            }
        }
        self
    }
}

fn no_points() -> Table<Position> {
    Spanned::new(0..0, BTreeMap::new())
}

/// The instants of the motion, in one of two forms.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Time {
    /// The first instant, s.
    pub start: Option<Spanned<f64>>,
    /// Where the steps end, s.
    pub stop: Option<Spanned<f64>>,
    /// From one instant to the next, s.
    pub step: Option<Spanned<f64>>,
    /// The instants one by one, s.
    pub instants: Option<Spanned<Vec<Spanned<f64>>>>,
}
