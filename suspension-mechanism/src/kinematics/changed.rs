//! A mechanism with changed hardpoints and lengths.

use nalgebra::Vector3;
use suspension_core::{GeometryError, Motion, Newton, SolveError, Values, assemble};

use crate::mechanism::{
    Description, DriveLaws, Mechanism, Names, Spring, Suspension, inputs_at_rest,
};

/// The differences of another mechanism, in the file's axes and unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changes {
    /// Points by number, each with its displacement.
    pub points: Vec<(usize, Vector3<f64>)>,
    /// Lengths by number, each with its increase.
    pub lengths: Vec<(usize, f64)>,
}

impl Changes {
    /// The changes multiplied by a factor.
    pub fn times(&self, by: f64) -> Self {
        let points = self.points.iter().map(|(point, unit)| (*point, unit * by));
        let lengths = self
            .lengths
            .iter()
            .map(|(length, unit)| (*length, unit * by));
        Self {
            points: points.collect(),
            lengths: lengths.collect(),
        }
    }

    /// The sum of all changes.
    pub fn sum(all: impl Iterator<Item = Self>) -> Self {
        all.fold(Self::default(), |mut together, each| {
            together.points.extend(each.points);
            together.lengths.extend(each.lengths);
            together
        })
    }
}

/// Why there is no mechanism with changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unbuilt {
    /// It cannot be built from these points and lengths.
    Geometry(GeometryError),
    /// There is no configuration near these points.
    Apart(SolveError<f64>),
}

impl Unbuilt {
    /// The reason as a sentence.
    pub fn in_words(&self, names: &Names) -> String {
        match self {
            Self::Geometry(error) => error.named(names).to_string(),
            Self::Apart(error) => names.cause(error),
        }
    }
}

/// The mechanism with changes, at rest in the configuration nearest to its start: it is built from the changed points there,
/// with the drives that these give; then lengths change, with the drives held.
pub(super) fn changed<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    changes: &Changes,
) -> Result<Mechanism<L, N>, Unbuilt> {
    let mut points = mechanism.start_points();
    for (point, by) in &changes.points {
        let [at] = points.at([*point]);
        points = points.with(*point, at + by);
    }
    let mut model = L::of(mechanism.model.listing(), &points).map_err(Unbuilt::Geometry)?;
    let drives = model.drives_at(&points);
    if !changes.lengths.is_empty() {
        let mut lengths = model.lengths();
        for (length, by) in &changes.lengths {
            let [now] = lengths.at([*length]);
            lengths = lengths.with(*length, now + by);
        }
        model = model.with_lengths(&lengths).map_err(Unbuilt::Geometry)?;
    }
    assemble_nearest(mechanism, model, &points, drives)
}

/// The configuration nearest to some points.
fn assemble_nearest<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    model: L,
    points: &L::Points,
    drives: L::Drives,
) -> Result<Mechanism<L, N>, Unbuilt> {
    let mut position = model.unknowns(points);
    let inputs = inputs_at_rest(drives);
    // If only the points were changed, they are the solution.
    let nearby = Newton::default().solve(&model, &inputs, &mut position);
    if nearby.is_err() {
        assemble(&Newton::from_afar(), &model, &inputs, &mut position).map_err(Unbuilt::Apart)?;
    }
    let there = Motion::at_rest(position).points(&model, &inputs);
    let places: Vec<_> = there.value.values().collect();
    let mut names = mechanism.names.clone().designed(&places);
    let measures: Vec<f64> = model.measures(&there).value.values().collect();
    let design_measures = mechanism.measures_in_file(&measures);
    let springs = names.vehicle.springs.iter().map(|spring| Spring {
        design: design_measures[spring.measure],
        ..spring.clone()
    });
    names.vehicle.springs = springs.collect();
    if let Some(wheel) = &mut names.vehicle.steering_wheel {
        wheel.design = mechanism.drives_in_file(drives.values())[wheel.drive];
    }
    let masses = names.vehicle.masses.iter();
    let metre = mechanism.unit.metre();
    names.vehicle.masses = masses.map(|mass| mass.held_at(&places, metre)).collect();
    Ok(Mechanism {
        description: Description {
            drives: DriveLaws::held(drives.values()),
            names,
            design_measures,
            ..mechanism.description.clone()
        },
        model,
        start: Motion::at_rest(position),
        lead: None,
        design_derivatives: mechanism.design_derivatives,
    })
}
