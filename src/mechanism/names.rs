//! What a listing calls its parts, and what they are.

use nalgebra::Vector3;
use serde::Deserialize;
use suspension_core::listing::Kind;
use suspension_core::{
    Build, DriveKind, Linkage, Listing, MeasureKind, Part, Parts, Values, WheelPlaces,
};

/// A linkage that this program can run.
pub trait Suspension<const N: usize>:
    Build<N, Scalar = f64>
    + Linkage<N, Listing: Listing<N, Model<f64> = Self, Model<f32>: Build<N, Scalar = f32>>>
{
}

impl<L, const N: usize> Suspension<N> for L where
    L: Build<N, Scalar = f64>
        + Linkage<N, Listing: Listing<N, Model<f64> = L, Model<f32>: Build<N, Scalar = f32>>>
{
}

/// The parts of a listing in lists, whatever its types.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Names {
    /// Points: those of the chassis, then free ones, then markers carried by bodies.
    pub points: Vec<String>,
    /// How many of them are the chassis'.
    pub chassis: usize,
    /// How many are free: the unknowns.
    pub free: usize,
    /// Lengths of links and bodies.
    pub lengths: Vec<String>,
    /// Drives.
    pub drives: Vec<Drive>,
    /// Measures.
    pub measures: Vec<Measure>,
    /// Equations, rows of the Jacobian.
    pub equations: Vec<String>,
    /// Unknowns, columns of the Jacobian.
    pub unknowns: Vec<String>,
    /// The wheel, where the listing states one.
    pub wheel: Option<WheelPoints>,
    /// The kingpin's lower and upper point, by number, where the listing states one.
    pub kingpin: Option<[usize; 2]>,
    /// What the motion file says of the vehicle.
    pub vehicle: Vehicle,
}

/// What quantities need beside the linkage.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vehicle {
    /// From the wheel centre to the ground, in the unit of lengths.
    pub wheel_radius: Option<f64>,
    /// The number of the drive that moves the wheel up and down.
    pub travel: Option<usize>,
    /// The number of the drive that steers it.
    pub steer: Option<usize>,
    /// The car that the wheel is of.
    pub car: Option<Car>,
}

/// What a car's braking and driving make of a wheel's support angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Car {
    /// Which axle the wheel is on.
    pub axle: Axle,
    /// From axle to axle, in the unit of lengths.
    pub wheelbase: f64,
    /// The height of the centre of gravity above the ground, in the unit of lengths.
    pub cg_height: f64,
    /// The axle's share of the brake force.
    pub brake_share: Option<f64>,
    /// The axle's share of the drive force.
    pub drive_share: Option<f64>,
}

/// An axle of a car.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Axle {
    /// The leading one.
    Front,
    /// The trailing one.
    Rear,
}

/// A drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// Its name.
    pub name: String,
    /// What its value measures.
    pub kind: DriveKind,
}

/// A measure.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: MeasureKind,
}

/// The points of a wheel, by number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WheelPoints {
    /// On the spin axis, pointing outboard: the inner one and the wheel centre.
    pub axis: [usize; 2],
    /// Of the body that carries the wheel.
    pub carrier: [usize; 3],
}

impl Names {
    /// Those of a listing or a model; which points are wheel and kingpin says a model alone.
    pub fn of(parts: &impl Parts) -> Self {
        let named = |count: usize, part: fn(usize) -> Part| -> Vec<String> {
            let each = (0..count).map(|index| parts.name(part(index)).to_owned());
            each.collect()
        };
        let count = |kind| parts.count(kind);
        let [chassis, free] = [Kind::ChassisPoint, Kind::FreePoint].map(count);
        let drives = named(count(Kind::Drive), Part::Drive).into_iter();
        let measures = named(count(Kind::Measure), Part::Measure).into_iter();
        Self {
            points: named(chassis + free + count(Kind::Marker), Part::Point),
            chassis,
            free,
            lengths: named(count(Kind::Length), Part::Length),
            drives: (0..)
                .zip(drives)
                .map(|(drive, name)| Drive {
                    name,
                    kind: parts.drive_kind(drive),
                })
                .collect(),
            measures: (0..)
                .zip(measures)
                .map(|(measure, name)| Measure {
                    name,
                    kind: parts.measure_kind(measure),
                })
                .collect(),
            equations: named(count(Kind::Unknown), Part::Equation),
            unknowns: named(count(Kind::Unknown), Part::Unknown),
            wheel: None,
            kingpin: None,
            vehicle: Vehicle::default(),
        }
    }

    /// Those of a model, with the points that are its wheel and kingpin.
    pub fn of_model<L: Suspension<N>, const N: usize>(model: &L) -> Self {
        // A model gives the roles as positions: let each point's position be its number.
        let numbers = (0..).map(|number: u32| Vector3::repeat(f64::from(number)));
        let tags = L::Points::from_values(numbers);
        let number = |tag: Vector3<f64>| tag.x as usize;
        let axis = model.wheel_axis(&tags);
        let wheel = axis.zip(model.wheel_carrier(&tags));
        Self {
            wheel: wheel.map(|(axis, carrier)| WheelPoints {
                axis: axis.map(number),
                carrier: carrier.map(number),
            }),
            kingpin: model.kingpin(&tags).map(|ends| ends.map(number)),
            ..Self::of(model)
        }
    }

    /// The markers' names.
    pub fn markers(&self) -> &[String] {
        &self.points[self.chassis + self.free..]
    }

    /// The wheel centre's name.
    pub fn wheel_centre(&self) -> Option<&str> {
        let [_, centre] = self.wheel?.axis;
        Some(&self.points[centre])
    }

    /// The drives' names.
    pub fn of_drives(&self) -> Vec<&str> {
        let drives = self.drives.iter();
        drives.map(|drive| drive.name.as_str()).collect()
    }

    /// The measures' names.
    pub fn of_measures(&self) -> Vec<&str> {
        let measures = self.measures.iter();
        measures.map(|measure| measure.name.as_str()).collect()
    }

    /// The number of the drive that an option names; without one that of the only drive.
    ///
    /// # Errors
    ///
    /// What is wrong, in words.
    pub fn chosen_drive(&self, wanted: Option<&str>) -> Result<usize, String> {
        let names = self.of_drives();
        let all = names.join(", ");
        match (wanted, names.as_slice()) {
            (None, [_]) => Ok(0),
            (None, _) => Err(format!("--drive must say which: {all}")),
            (Some(wanted), _) => {
                let found = names.iter().position(|name| *name == wanted);
                found.ok_or_else(|| match self.of_measures().contains(&wanted) {
                    true => format!("`{wanted}` is a measure, no drive; the drives are {all}"),
                    false => format!("unknown drive `{wanted}`; known are {all}"),
                })
            }
        }
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
        let only = self.wheel.filter(|_| wheel == 0)?;
        Some(WheelPlaces {
            name: "",
            axis: only.axis,
            carrier: only.carrier,
            kingpin: self.kingpin,
        })
    }
}
