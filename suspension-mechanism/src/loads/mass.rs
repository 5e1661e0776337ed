//! Parts that have a mass.

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_core::inertia::{RigidBody, rod};

use crate::mechanism::{Points, State};

/// A part that has a mass.
#[derive(Clone, Debug, PartialEq)]
pub enum Mass {
    /// At a free point or a marker, kg.
    At(usize, f64),
    /// Of a uniform rod between two points, kg.
    Rod([usize; 2], f64),
    /// Of a body that is held by three points, in metres.
    Body([usize; 3], RigidBody<f64>),
}

/// A motion in metres.
pub(super) struct InMetres<'a> {
    pub(super) state: &'a State,
    /// Units of length in a metre.
    pub(super) metre: f64,
}

impl InMetres<'_> {
    /// Positions, velocities and accelerations of some points.
    pub(super) fn of<const K: usize>(&self, points: [usize; K]) -> Signal<[Vector3<f64>; K]> {
        let of = |all: &Points| points.map(|point| all[point] / self.metre);
        self.state.points.map(of)
    }

    /// The forces at three points of a body; `None` where these are in line.
    pub(super) fn of_body(
        &self,
        points: [usize; 3],
        body: &RigidBody<f64>,
        field: &Vector3<f64>,
    ) -> Option<[Vector3<f64>; 3]> {
        body.forces(&self.of(points), field)
    }

    /// The forces at the ends of a rod.
    pub(super) fn of_rod(
        &self,
        ends: [usize; 2],
        mass: f64,
        field: &Vector3<f64>,
    ) -> [Vector3<f64>; 2] {
        rod(mass, self.of(ends).second_rate, field)
    }
}
