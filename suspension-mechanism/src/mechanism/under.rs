//! A mechanism under forces.

use std::ops::Range;

use nalgebra::Vector3;
use suspension_core::statics::{Loads, Statics};
use suspension_core::{Signal, Values};

use crate::mechanism::names::Suspension;
use crate::mechanism::ready::Mechanism;
use crate::mechanism::state::State;

/// What forces at the points do to a mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Borne {
    /// The work of the forces per unit of each drive, which what moves the drive bears: N, and N times the unit of lengths
    /// about angles.
    pub on_drives: Vec<f64>,
    /// The forces that each group of equations exerts on the points, N.
    pub by_groups: Vec<Vec<Vector3<f64>>>,
}

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// What forces at chassis points and free points do at a state, and groups of equations to the points; `None`
    /// where the mechanism locks.
    pub fn under(
        &self,
        state: &State,
        forces: &[Vector3<f64>],
        groups: &[Vec<Range<usize>>],
    ) -> Option<Borne> {
        let position = self.model.unknowns(&points(state));
        let given = state.drives.iter().zip(&self.drive_offsets);
        let drives = L::Drives::from_values(given.map(|(given, offset)| given - offset));
        let statics = Statics::new(&self.model, drives, &position).ok()?;
        let loads = statics.under(&points_of(forces)).ok()?;
        let count = self.names.drives.len();
        Some(Borne {
            on_drives: loads.on_drives().values().take(count).collect(),
            by_groups: groups.iter().map(|group| self.by(&loads, group)).collect(),
        })
    }

    fn by(&self, loads: &Loads<'_, L, N>, group: &[Range<usize>]) -> Vec<Vector3<f64>> {
        let mut sum = vec![Vector3::zeros(); self.names.points.len()];
        for equations in group {
            let forces = loads.by(equations.clone());
            for (sum, force) in sum.iter_mut().zip(forces.values()) {
                *sum += force;
            }
        }
        sum
    }

    /// The derivative of a measure with respect to each point, at a state.
    pub fn gradient(&self, state: &State, measure: usize) -> Vec<Vector3<f64>> {
        let still = L::Points::from_values([]);
        let points: L::Points = points(state);
        let along = |point: usize, axis: Vector3<f64>| {
            let moving = Signal {
                value: points,
                rate: still.with(point, axis),
                second_rate: still,
            };
            let rates = self.model.measures(&moving).rate;
            rates.values().nth(measure).unwrap_or_default()
        };
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        (0..self.names.points.len())
            .map(|point| Vector3::from(axes.map(|axis| along(point, axis))))
            .collect()
    }
}

/// The points of a state, as the linkage has them.
fn points<P: Values<Vector3<f64>>>(state: &State) -> P {
    points_of(&state.points.value)
}

fn points_of<P: Values<Vector3<f64>>>(points: &[Vector3<f64>]) -> P {
    P::from_values(points.iter().copied())
}
