//! Parts that have a mass.

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_core::inertia::{RigidBody, rod};

use crate::mechanism::points::Points;

/// A part that has a mass.
#[derive(Clone, Debug, PartialEq)]
pub enum Mass {
    /// A mass at a point that moves, kg.
    At(usize, f64),
    /// The mass of a uniform rod between two points, kg.
    Rod([usize; 2], f64),
    /// The mass of a body.
    Body {
        /// Three points that hold it.
        held: [usize; 3],
        /// The body, in metres.
        body: RigidBody<f64>,
        /// The point relative to which its centre of mass is stated, and with which it moves.
        centre: Option<usize>,
    },
}

impl Mass {
    /// Weight in a field, m/s^2, and inertia as forces, N, at the points of the part, which move as `points` do, in
    /// units of which `metre` are a metre; `None` if three points that hold a body are collinear.
    pub fn forces(
        &self,
        points: &Signal<Points>,
        metre: f64,
        field: &Vector3<f64>,
    ) -> Option<Vec<(usize, Vector3<f64>)>> {
        let accelerations = |point: &usize| points.second_rate[*point] / metre;
        Some(match self {
            Self::At(point, mass) => vec![(*point, (field - accelerations(point)) * *mass)],
            Self::Rod(ends, mass) => {
                let forces = rod(*mass, ends.each_ref().map(accelerations), field);
                ends.iter().copied().zip(forces).collect()
            }
            Self::Body { held, body, .. } => {
                let at = points.map(|all: &Points| held.map(|point| all[point] / metre));
                held.iter().copied().zip(body.forces(&at, field)?).collect()
            }
        })
    }

    /// Twice the kinetic energy, J, of points at `places` with `velocities`: the work of the inertia forces if the
    /// velocities were accelerations.
    pub(crate) fn twice_energy(
        &self,
        places: &Points,
        velocities: &Points,
        metre: f64,
    ) -> Option<f64> {
        let points = Signal {
            value: places.clone(),
            rate: places.iter().map(|_| Vector3::zeros()).collect(),
            second_rate: velocities.clone(),
        };
        let forces = self.forces(&points, metre, &Vector3::zeros())?;
        let work = forces
            .iter()
            .map(|(point, force)| force.dot(&velocities[*point]));
        Some(-work.sum::<f64>() / metre)
    }

    /// The same part of a mechanism whose points are elsewhere. Its centre of mass is where it was, or moves with the
    /// point relative to which it is stated.
    pub(crate) fn held_at(&self, places: &[Vector3<f64>], metre: f64) -> Self {
        match self {
            Self::Body { held, body, centre } => Self::Body {
                held: *held,
                body: RigidBody {
                    points: held.map(|point| places[point] / metre),
                    centre: centre.map_or(body.centre, |point| places[point] / metre),
                    ..*body
                },
                centre: *centre,
            },
            other => other.clone(),
        }
    }
}
