//! The motion file: one mechanism, its lengths, the instants and the drives.

use nalgebra::Vector3;
use serde::Deserialize;
use toml::Spanned;

use crate::failure::Failure;
use crate::inputs;
use crate::parse_errors::refused;
use crate::source::Source;
use crate::tables::entries::{Entries, Table};
use crate::tables::loads::LoadCase;
use crate::tables::mass::MassTable;
use crate::tables::position::{Offset, Position};
use crate::tables::several_notations::written_as_table;
use crate::tables::spring::SpringTable;
use crate::tables::stated_law::StatedLaw;
use crate::tables::tune::TuneTable;
use crate::tables::vehicle::VehicleTable;
use crate::{Angle, Axes, Length, Unit};

/// The contents of a motion file; names and values are not checked yet.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MotionFile {
    /// The linkage's name: one of the catalogue, or the name of the user's listing.
    pub linkage: Option<Spanned<String>>,
    /// The path of the listing relative to this file, in place of a name of the catalogue.
    pub listing: Option<Spanned<String>>,
    /// The statements of the listing, in place of a name of the catalogue.
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
    /// The points of the linkage: chassis points, free points, markers. Points that the listing states may be omitted.
    #[serde(default = "no_points")]
    pub points: Table<Position>,
    /// The lengths of links and bodies; with them the points are only a start of the assembly.
    pub lengths: Option<Table<f64>>,
    /// The values of the drives at which the mechanism is assembled and markers are attached.
    pub design: Option<Table<f64>>,
    /// Data of the vehicle that the listing does not state.
    #[serde(default = "VehicleTable::left_out")]
    pub vehicle: Spanned<VehicleTable>,
    /// Springs and anti-roll bars by name.
    pub springs: Option<Table<SpringTable>>,
    /// Masses of moving parts by name.
    pub masses: Option<Table<MassTable>>,
    /// Load cases by name.
    pub loads: Option<Table<LoadCase>>,
    /// Standard deviations of points and links by name, in the unit of lengths.
    pub tolerances: Option<Table<f64>>,
    /// The points that tuning may move, and the target curves.
    pub tune: Option<Spanned<TuneTable>>,
    /// The instants of the motion.
    pub time: Spanned<Time>,
    /// Each drive over time in seconds.
    pub drives: Table<StatedLaw>,
}

impl MotionFile {
    /// Reads the text of a motion file, and protects the files of measurements that it names from being overwritten.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] with the places of all mistakes.
    pub fn parse(source: &Source) -> Result<Self, Failure> {
        let file: Self = toml::from_str(source.text()).map_err(|_| refused::<Self>(source))?;
        let tune = file.tune.iter().map(Spanned::get_ref);
        let drives = file.drives.get_ref().values();
        let recorded = drives.filter_map(|law| law.get_ref().recording());
        for table in tune.flat_map(TuneTable::measured).chain(recorded) {
            inputs::note(&source.beside(table.csv.get_ref()));
        }
        Ok(file)
    }

    /// Returns the units of the file.
    pub fn unit(&self) -> Unit {
        Unit {
            length: self.length,
            angle: self.angle,
        }
    }

    /// Returns the markers that are stated relative to another point, each with that point, as indices into `points`.
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

    /// Returns the file with points, offsets and masses in other axes; the rest stays the same.
    pub fn turned(mut self, axes: Axes) -> Self {
        let from = self.axes;
        let turned = |vector: Vector3<f64>| axes.turned(from.turned(vector));
        for position in self.points.get_mut().values_mut() {
            let at = match position.get_mut() {
                Position::At(at) => at,
                Position::Off(Offset { offset, .. }) => offset.get_mut(),
            };
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
}

fn no_points() -> Table<Position> {
    Spanned::new(0..0, Entries::EMPTY)
}

/// The instants of the motion, in one of two forms: steps or a list.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, remote = "Self")]
pub struct Time {
    /// The first instant, s.
    pub start: Option<Spanned<f64>>,
    /// The end of the steps, s.
    pub stop: Option<Spanned<f64>>,
    /// The time between two instants, s.
    pub step: Option<Spanned<f64>>,
    /// A list of instants, s.
    pub instants: Option<Spanned<Vec<Spanned<f64>>>>,
}

written_as_table!(Time, "the instants of the motion under [time]");
