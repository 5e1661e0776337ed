//! The results of one instant as a row of numbers, and the names of its columns.

use nalgebra::Vector3;
use suspension_core::wheel::{CarrierRotation, Kingpin, Wheel};
use suspension_core::{
    Advanced, HasKingpin, HasWheel, Inputs, MeasureKind, Motion, Named, Parts, Still, Values,
};

use crate::input::drives::unit_of;
use crate::input::file::Unit;
use crate::study::{Assembled, Suspension};

/// The names of a linkage's points, by what they are.
#[derive(Clone, Debug, PartialEq)]
pub struct PointNames {
    /// Free points, the unknowns.
    pub free: Vec<&'static str>,
    /// Markers carried by bodies.
    pub markers: Vec<&'static str>,
    /// The wheel centre.
    pub wheel_centre: &'static str,
    /// The kingpin's lower and upper point.
    pub kingpin: [&'static str; 2],
}

impl PointNames {
    /// Of a linkage. [`suspension_core::Linkage::Points`] lists chassis points, free points, markers.
    pub fn of<L: Suspension<N>, const N: usize>() -> Self {
        let names = <L::Points as Named<Vector3<f64>>>::NAMES;
        let chassis = <L::Fixed as Named<Vector3<f64>>>::NAMES.len();
        let (free, markers) = names[chassis..].split_at(N / 3);
        // The roles are given as positions: let each point's position be its number.
        let numbers = (0..names.len()).map(|number| Vector3::repeat(number as f64));
        let tags = L::Points::from_values(numbers);
        let name_of = |tag: Vector3<f64>| names[tag.x as usize];
        let [_, centre] = tags.wheel();
        Self {
            free: free.to_vec(),
            markers: markers.to_vec(),
            wheel_centre: name_of(centre),
            kingpin: tags.kingpin().map(name_of),
        }
    }
}

/// The columns' names; velocities are per second, accelerations per second squared, angular
/// velocities in rad/s, angular accelerations in rad/s^2.
pub fn names<L: Suspension<N>, const N: usize>(unit: Unit) -> Vec<String> {
    let points = PointNames::of::<L, N>();
    let drives = <L::Drives as Named<f64>>::NAMES.iter().enumerate();
    let mut columns = vec!["t_s".to_owned()];
    columns.extend(drives.map(|(drive, name)| {
        let kind = L::Listing::default().drive_kind(drive);
        format!("{name}_{}", unit_of(kind, unit))
    }));
    for kind in ["", "v", "a"] {
        columns.extend(points.free.iter().flat_map(|name| triple(name, kind)));
    }
    columns.extend(["omega", "alpha"].iter().flat_map(|name| triple(name, "")));
    for marker in &points.markers {
        columns.extend(["", "v", "a"].iter().flat_map(|kind| triple(marker, kind)));
    }
    let scalars = ["kingpin_rad", "caster_rad", "camber_rad", "toe_rad"];
    columns.extend(scalars.map(String::from));
    columns.extend(measures::<L, N>(unit));
    columns.push("iterations".to_owned());
    columns.push(format!("residual_{}", unit.symbol()));
    columns
}

/// The columns of what the linkage measures.
pub fn measures<L: Suspension<N>, const N: usize>(unit: Unit) -> Vec<String> {
    let names = <L::Measures as Named<f64>>::NAMES.iter();
    names
        .enumerate()
        .map(|(measure, name)| {
            let kind = L::Listing::default().measure_kind(measure);
            format!("{name}_{}", unit_of_measure(kind, unit))
        })
        .collect()
}

/// A measure's unit.
pub fn unit_of_measure(kind: MeasureKind, unit: Unit) -> &'static str {
    match kind {
        MeasureKind::Length => unit.symbol(),
        MeasureKind::Angle => "rad",
    }
}

fn triple(name: &str, kind: &str) -> [String; 3] {
    ["x", "y", "z"].map(|axis| format!("{name}_{kind}{axis}"))
}

/// The row of one instant, in the order of [`names`]. What is undefined in a configuration (the
/// wheel's angles where its axis has no direction) is NaN.
pub fn row<L: Suspension<N>, const N: usize>(
    assembled: &Assembled<L, N>,
    t: f64,
    inputs: &Inputs<Still, L::Drives>,
    motion: &Motion<f64, N>,
    advanced: &Advanced<f64>,
) -> Vec<f64> {
    let points = motion.points(&assembled.model, inputs);
    let origin = assembled.origin.position();
    let mut row = vec![t];
    row.extend(assembled.given(&inputs.drives.value).values());
    let coordinates = motion.position.iter().enumerate();
    row.extend(coordinates.map(|(index, x)| x + origin[index % 3]));
    row.extend(&motion.velocity);
    row.extend(&motion.acceleration);
    let undefined = Vector3::repeat(f64::NAN);
    let turning = CarrierRotation::of(&points.map(|points| points.carrier()));
    let [omega, alpha] = turning.map_or([undefined; 2], |turning| [turning.omega, turning.alpha]);
    row.extend(&omega);
    row.extend(&alpha);
    let markers = PointNames::of::<L, N>().markers.len();
    let first_marker = <L::Points as Named<Vector3<f64>>>::NAMES.len() - markers;
    for marker in 0..markers {
        let each = [&points.value, &points.rate, &points.second_rate];
        for (points, origin) in each
            .into_iter()
            .zip([origin, Vector3::zeros(), Vector3::zeros()])
        {
            let point = points.values().nth(first_marker + marker);
            row.extend(point.map(|point| point + origin).iter().flatten());
        }
    }
    let kingpin = Kingpin::of(points.value.kingpin(), points.value.wheel());
    let wheel = Wheel::of(points.value.wheel());
    let [camber, toe] = wheel.map_or([f64::NAN; 2], |wheel| [wheel.camber, wheel.toe]);
    row.extend([kingpin.angle, kingpin.caster, camber, toe]);
    let measures = assembled.model.measures(&points).value;
    let offsets = assembled.origin.of_measures(&assembled.model);
    row.extend(
        measures
            .values()
            .zip(offsets.values())
            .map(|(local, offset)| local + offset),
    );
    row.extend([advanced.iterations as f64, advanced.last.residual]);
    row
}
