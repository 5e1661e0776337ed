//! The mechanism at one place of its motion, for any linkage.

use std::rc::Rc;

use nalgebra::Vector3;
use suspension_core::{Signal, Values};

use crate::file::Axes;
use crate::mechanism::driven_linkage::Mechanism;
use crate::mechanism::parts::mass::Mass;
use crate::mechanism::parts::spring::Spring;
use crate::mechanism::points::Points;
use crate::mechanism::suspension::Suspension;

/// A mechanism at one place of its motion: positions and rates, from which all quantities follow.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The time, s.
    pub t: f64,
    /// The drives' values, in the file's coordinates.
    pub drives: Vec<f64>,
    /// All points with their velocities and accelerations, in local coordinates.
    pub points: Signal<Points>,
    /// The vector to be added to a position to get the file's coordinates.
    pub origin: Vector3<f64>,
    /// The axes of all coordinates.
    pub axes: Axes,
    /// The measures of the linkage, in the file's coordinates, with their rates.
    pub measures: Signal<Vec<f64>>,
    /// Velocities of all points when a drive moves them, with the others held, by the number of the drive, with their
    /// derivatives along the rates of `points`, which are NaN if they are not known. `None` for drives that neither
    /// move a wheel up and down nor steer it, and if the mechanism locks.
    pub velocities: Vec<Option<Signal<Points>>>,
    /// The states with derivatives along movements of the wheels up and down; present if there are springs or masses.
    pub moved: Rc<[Moved]>,
    /// Springs and anti-roll bars.
    pub springs: Rc<[Spring]>,
    /// Parts that have a mass.
    pub masses: Rc<[Mass]>,
    /// The number of units of length in a metre.
    pub metre: f64,
    /// The number of iterations of Newton's method, including those of intermediate steps.
    pub iterations: usize,
    /// The largest residual, in the unit of lengths.
    pub residual: f64,
}

/// A way in which wheels move up and down, with the other drives held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WheelMovement {
    /// A drive of travel moves its wheel; the wheel beside it is held at its height if it has a drive of its own.
    Travel(usize),
    /// Both wheels of an axle, by number, move by drives of their own so that their centres rise by the same amount.
    Heave([usize; 2]),
    /// The two move so that the centre of the first rises as that of the second falls.
    Roll([usize; 2]),
}

/// A state with derivatives along a movement.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved {
    /// The movement.
    pub movement: WheelMovement,
    /// The state.
    pub state: State,
}

impl State {
    /// A point in the file's coordinates.
    pub fn position(&self, point: usize) -> Vector3<f64> {
        self.points.value[point] + self.origin
    }

    /// The load of a spring: N, or N m for an angle.
    pub(crate) fn load_of(&self, spring: &Spring) -> f64 {
        spring.load_at(self.measures.value[spring.measure])
    }

    /// The state along a movement, if it is known.
    pub fn moved_along(&self, movement: WheelMovement) -> Option<&State> {
        let mut moved = self.moved.iter();
        moved
            .find(|moved| moved.movement == movement)
            .map(|moved| &moved.state)
    }

    /// The velocities of all points when a drive moves them, if they are known.
    pub fn moved_by(&self, drive: usize) -> Option<&Signal<Points>> {
        self.velocities.get(drive)?.as_ref()
    }
}

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// The state for points with their rates, at local values of the drives.
    pub fn state(&self, t: f64, drives: &L::Drives, points: &Signal<L::Points>) -> State {
        let listed = points.map(|points| self.listed(points));
        self.state_of(t, drives, listed, self.measured(points))
    }

    /// The state for lists of points and for the measures of the linkage.
    pub(crate) fn state_of(
        &self,
        t: f64,
        drives: &L::Drives,
        points: Signal<Points>,
        measures: Signal<Vec<f64>>,
    ) -> State {
        State {
            t,
            drives: self.drives_in_file(drives.values()),
            points,
            origin: self.origin,
            axes: self.axes,
            measures,
            velocities: Vec::new(),
            moved: Rc::new([]),
            springs: self.names.vehicle.springs.clone(),
            masses: self.names.vehicle.masses.clone(),
            metre: self.unit.metre(),
            iterations: 0,
            residual: 0.0,
        }
    }

    /// The points of the listing.
    pub(crate) fn listed(&self, points: &L::Points) -> Points {
        let mut points = points.values();
        let each = self.names.points.iter();
        each.map(|_| points.next().unwrap_or_default()).collect()
    }

    /// The measures for points with their rates, in the file's coordinates.
    pub(crate) fn measured(&self, points: &Signal<L::Points>) -> Signal<Vec<f64>> {
        let count = self.names.measures.len();
        let listed = |all: &L::Measures| all.values().take(count).collect::<Vec<f64>>();
        let measures = self.model.measures(points).map(listed);
        Signal {
            value: self.measures_in_file(&measures.value),
            ..measures
        }
    }

    /// The same at rest.
    pub(crate) fn state_at_rest(&self, t: f64, drives: &L::Drives, points: L::Points) -> State {
        let still = L::Points::from_values([]);
        let points = Signal {
            value: points,
            rate: still,
            second_rate: still,
        };
        self.state(t, drives, &points)
    }
}
