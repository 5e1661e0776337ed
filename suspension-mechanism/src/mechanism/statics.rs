//! A mechanism under forces.

use std::f64::consts::TAU;
use std::ops::Range;

use nalgebra::{SVector, Vector3};
use suspension_core::listing::DriveKind;
use suspension_core::solve::motion::Prescribed;
use suspension_core::statics::Statics;
use suspension_core::{Signal, Values};
use suspension_runtime::PartForces;

use crate::mechanism::driven_linkage::Mechanism;
use crate::mechanism::motion::drive_laws::inputs_at_rest;
use crate::mechanism::state::State;
use crate::mechanism::suspension::Suspension;

/// The effect of forces at the points on a mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Borne {
    /// The work of the forces per unit of each drive, which is borne by whatever moves the drive: N, and N times the
    /// unit of lengths about angles.
    pub on_drives: Vec<f64>,
    /// The forces that each part exerts on the points, N.
    pub by_parts: Vec<Vec<Vector3<f64>>>,
    /// The moments, N m, on parts by number, each with the name of the statement that drives or holds the angle about
    /// which it acts.
    pub on_parts: Vec<(usize, String, Vector3<f64>)>,
}

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// The effect of forces at chassis points and free points at a state, and the forces of parts on the points;
    /// `None` if the mechanism locks.
    pub fn apply_forces(
        &self,
        state: &State,
        forces: &[Vector3<f64>],
        parts: &[PartForces],
    ) -> Option<Borne> {
        let at: L::Points = points_of(&state.points.value);
        let position = self.model.unknowns(&at);
        let given = state.drives.iter().zip(&self.drive_offsets);
        let drives = L::Drives::from_values(given.map(|(given, offset)| given - offset));
        let drives = self.with_nearest_turns(&position, drives);
        let statics = Statics::new(&self.model, drives, &position).ok()?;
        let loads = statics.under(&points_of(forces)).ok()?;
        let count = self.names.drives.len();
        let forces: Vec<[SVector<f64, N>; 3]> = match parts {
            [] => Vec::new(),
            _ => loads.by_equation().collect(),
        };
        let by = |rows: &Range<usize>| {
            let sum = |along: &SVector<f64, N>| along.as_slice()[rows.clone()].iter().sum();
            let each = forces
                .iter()
                .map(|xyz| Vector3::from(xyz.each_ref().map(sum)));
            L::Points::from_values(each)
        };
        let of_part = |part: &PartForces| {
            let forces = part.forces(by, &at);
            forces.values().take(self.names.points.len()).collect()
        };
        let metre = self.unit.metre();
        let on_parts = parts.iter().enumerate().flat_map(|(number, part)| {
            let moments = part.moments(by, &at).into_iter();
            moments.map(move |(angle, moment)| (number, angle.to_owned(), moment / metre))
        });
        Some(Borne {
            on_parts: on_parts.collect(),
            on_drives: loads.on_drives().values().take(count).collect(),
            by_parts: parts.iter().map(of_part).collect(),
        })
    }

    /// The drives, with angles about axes put on the turn on which unknowns read from the points are: within half a
    /// turn of the design.
    fn with_nearest_turns(&self, position: &SVector<f64, N>, mut drives: L::Drives) -> L::Drives {
        const TURNS: [f64; 3] = [0.0, TAU, -TAU];
        let named = self.names.drives.iter().enumerate();
        for (place, _) in named.filter(|(_, drive)| drive.kind == DriveKind::Turn) {
            let value = drives.values().nth(place).unwrap_or_default();
            let turned = TURNS.map(|turn| drives.with(place, value + turn));
            let off = |drives: &L::Drives| {
                let Prescribed { fixed, drives } =
                    Prescribed::new(&self.model, &inputs_at_rest(*drives));
                let residual = self.model.residual(position, &fixed.value, &drives.value);
                residual.norm()
            };
            let nearest = turned.into_iter().min_by(|a, b| off(a).total_cmp(&off(b)));
            drives = nearest.unwrap_or(drives);
        }
        drives
    }

    /// The derivative of each measure with respect to each point, at a state.
    pub fn gradients(&self, state: &State) -> Vec<Vec<Vector3<f64>>> {
        let still = L::Points::from_values([]);
        let value: L::Points = points_of(&state.points.value);
        let mut gradients =
            vec![vec![Vector3::zeros(); self.names.points.len()]; self.names.measures.len()];
        for point in 0..self.names.points.len() {
            for axis in 0..3 {
                let moving = Signal {
                    value,
                    rate: still.with(point, Vector3::ith(axis, 1.0)),
                    second_rate: still,
                };
                let rates = self.model.measures(&moving).rate;
                for (gradient, rate) in gradients.iter_mut().zip(rates.values()) {
                    gradient[point][axis] = rate;
                }
            }
        }
        gradients
    }
}

fn points_of<P: Values<Vector3<f64>>>(points: &[Vector3<f64>]) -> P {
    P::from_values(points.iter().copied())
}
