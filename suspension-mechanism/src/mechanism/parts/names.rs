//! Names of a listing's parts, and their kinds.

use nalgebra::Vector3;
use suspension_core::listing::{DriveKind, Kind, MeasureKind, Part, Parts, WheelPlaces};
use suspension_listing::did_you_mean::unknown;

use crate::mechanism::parts::driven_length::DrivenLength;
use crate::mechanism::parts::guide::Guide;
use crate::mechanism::parts::hinge::Hinge;
use crate::mechanism::parts::vehicle::{Vehicle, Wheel};

/// The parts of a listing in lists, independent of its types.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Names {
    /// Points: those of the chassis, then free ones, then markers carried by bodies.
    pub points: Vec<String>,
    /// The number of chassis points.
    pub chassis: usize,
    /// The number of free points, whose coordinates are the unknowns.
    pub free: usize,
    /// Lengths of links and bodies.
    pub lengths: Vec<String>,
    /// The lengths of links, by number; known for a listing that was read at run time.
    pub links: Vec<usize>,
    /// The links among these that are lines of a driven or held angle.
    pub angled_links: Vec<usize>,
    /// Hinges; known for a listing that was read at run time.
    pub hinges: Vec<Hinge>,
    /// Lines on the chassis on which points slide; known in the same case.
    pub guides: Vec<Guide>,
    /// Lengths that drives prescribe; known in the same case.
    pub driven_lengths: Vec<DrivenLength>,
    /// Drives.
    pub drives: Vec<Drive>,
    /// Measures.
    pub measures: Vec<Measure>,
    /// Equations: rows of the Jacobian.
    pub equations: Vec<String>,
    /// Unknowns: columns of the Jacobian.
    pub unknowns: Vec<String>,
    /// The wheels that the listing states.
    pub wheels: Vec<Wheel>,
    /// The data of the vehicle in the motion file.
    pub vehicle: Vehicle,
}

/// A drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// Its name.
    pub name: String,
    /// The kind of its value.
    pub kind: DriveKind,
}

/// A measure.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// Its name.
    pub name: String,
    /// Its kind.
    pub kind: MeasureKind,
}

impl Names {
    /// The names of a listing or a model.
    pub fn new(parts: &dyn Parts) -> Self {
        let named = |count: usize, part: fn(usize) -> Part| -> Vec<String> {
            let each = (0..count).map(|index| parts.name(part(index)).to_owned());
            each.collect()
        };
        let count = |kind| parts.count(kind);
        let [chassis, free] = [Kind::ChassisPoint, Kind::FreePoint].map(count);
        let drive = |drive| Drive {
            name: parts.name(Part::Drive(drive)).to_owned(),
            kind: parts.drive_kind(drive),
        };
        let measure = |measure| Measure {
            name: parts.name(Part::Measure(measure)).to_owned(),
            kind: parts.measure_kind(measure),
        };
        let wheels = (0..).map_while(|wheel| parts.wheel(wheel));
        Self {
            points: named(chassis + free + count(Kind::Marker), Part::Point),
            chassis,
            free,
            lengths: named(count(Kind::Length), Part::Length),
            drives: (0..count(Kind::Drive)).map(drive).collect(),
            measures: (0..count(Kind::Measure)).map(measure).collect(),
            equations: named(count(Kind::Unknown), Part::Equation),
            unknowns: named(count(Kind::Unknown), Part::Unknown),
            wheels: wheels.map(Wheel::from).collect(),
            ..Self::default()
        }
    }

    /// Adds the links, hinges and guides of the listing.
    pub(crate) fn with_parts_of(mut self, listing: &suspension_runtime::Listing) -> Self {
        let statements = listing.statements().into_iter();
        let links = statements.filter(|statement| statement.ends().is_some());
        let number = |link: &str| self.lengths.iter().position(|length| length == link);
        self.links = links.filter_map(|link| number(link.name)).collect();
        let parts = listing.parts().zip(listing.part_forces());
        let angled = parts.filter(|(part, forces)| part.ends().is_some() && forces.bears_moments());
        self.angled_links = angled.filter_map(|(part, _)| number(part.name)).collect();
        self.hinges = Hinge::all(listing, self.chassis);
        self.guides = Guide::all(listing, self.chassis);
        self.driven_lengths = DrivenLength::all(listing, self.drives.len());
        self
    }

    /// The links, each with the number of its length.
    pub(crate) fn links(&self) -> impl Iterator<Item = (&str, usize)> {
        let links = self.links.iter();
        links.map(|&length| (self.lengths[length].as_str(), length))
    }

    pub(crate) fn link(&self, name: &str) -> Option<usize> {
        let found = self.links().find(|(link, _)| *link == name);
        found.map(|(_, length)| length)
    }

    /// Whether there is a link of this name that is not a line of a driven or held angle.
    pub(crate) fn is_free_link(&self, name: &str) -> bool {
        let length = self.link(name);
        length.is_some_and(|length| !self.angled_links.contains(&length))
    }

    /// Adds the axes of the wheels and the directions of the guides at the design position, of which `points` are the
    /// local coordinates.
    pub fn designed(mut self, points: &[Vector3<f64>]) -> Self {
        for wheel in &mut self.wheels {
            wheel.design = Some(wheel.points.axis.map(|point| points[point]));
        }
        for guide in &mut self.guides {
            guide.design(points);
        }
        self
    }

    /// The number of a point.
    pub(crate) fn point(&self, name: &str) -> Option<usize> {
        self.points.iter().position(|point| point == name)
    }

    /// The number of a drive.
    pub(crate) fn drive(&self, name: &str) -> Option<usize> {
        self.drives.iter().position(|drive| drive.name == name)
    }

    /// The number of a measure.
    pub(crate) fn measure(&self, name: &str) -> Option<usize> {
        self.measures
            .iter()
            .position(|measure| measure.name == name)
    }

    /// The points' names.
    pub(crate) fn point_names(&self) -> Vec<&str> {
        self.points.iter().map(String::as_str).collect()
    }

    /// The markers' names.
    pub fn markers(&self) -> &[String] {
        &self.points[self.chassis + self.free..]
    }

    /// The drives' names.
    pub fn drive_names(&self) -> Vec<&str> {
        let drives = self.drives.iter();
        drives.map(|drive| drive.name.as_str()).collect()
    }

    /// The measures' names.
    pub fn measure_names(&self) -> Vec<&str> {
        let measures = self.measures.iter();
        measures.map(|measure| measure.name.as_str()).collect()
    }

    /// The number of the drive that an option names; without an option, the number of the only drive.
    ///
    /// # Errors
    ///
    /// A sentence that says what is wrong.
    pub fn chosen_drive(&self, wanted: Option<&str>) -> Result<usize, String> {
        let names = self.drive_names();
        let all = names.join(", ");
        match (wanted, names.as_slice()) {
            (None, [_]) => Ok(0),
            (None, _) => Err(format!("name one of the drives with --drive: {all}")),
            (Some(wanted), _) => self
                .drive(wanted)
                .ok_or_else(|| match self.measure(wanted) {
                    Some(_) => {
                        format!("`{wanted}` is a measure, not a drive; the drives are {all}")
                    }
                    None => unknown("drive", wanted, &names),
                }),
        }
    }

    /// The number of the wheel that `--wheel` names, of a mechanism with wheels.
    ///
    /// # Errors
    ///
    /// A sentence that says what is wrong.
    pub fn chosen_wheel(&self, wanted: &str) -> Result<usize, String> {
        let names: Vec<&str> = self
            .wheels
            .iter()
            .map(|wheel| wheel.name.as_str())
            .collect();
        let found = names.iter().position(|name| *name == wanted);
        found.ok_or_else(|| match names.as_slice() {
            [""] => "--wheel: the listing has one wheel, without a name; leave it out".to_owned(),
            known => unknown("wheel", wanted, known),
        })
    }
}

impl Parts for Names {
    fn name(&self, part: Part) -> &str {
        let found = match part {
            Part::Equation(index) => self.equations.get(index),
            Part::Unknown(index) => self.unknowns.get(index),
            Part::Point(index) => self.points.get(index),
            Part::Drive(index) => self.drives.get(index).map(|drive| &drive.name),
            Part::Measure(index) => self.measures.get(index).map(|measure| &measure.name),
            Part::Length(index) => self.lengths.get(index),
        };
        found.map_or("?", String::as_str)
    }

    fn count(&self, kind: Kind) -> usize {
        match kind {
            Kind::Unknown => self.unknowns.len(),
            Kind::ChassisPoint => self.chassis,
            Kind::FreePoint => self.free,
            Kind::Marker => self.markers().len(),
            Kind::Drive => self.drives.len(),
            Kind::Measure => self.measures.len(),
            Kind::Length => self.lengths.len(),
        }
    }

    fn drive_kind(&self, drive: usize) -> DriveKind {
        self.drives[drive].kind
    }

    fn measure_kind(&self, measure: usize) -> MeasureKind {
        self.measures[measure].kind
    }

    fn wheel(&self, wheel: usize) -> Option<WheelPlaces<'_>> {
        self.wheels.get(wheel).map(Wheel::places)
    }
}
