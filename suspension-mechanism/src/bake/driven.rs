//! The exact motion of a mechanism whose drives move on straight lines.

use nalgebra::Vector3;
use suspension_core::directions::Directions;
use suspension_core::step::stepper::Stopped;
use suspension_core::{Inputs, Motion, Signal, SolveError, Values};

use crate::mechanism::{Names, Suspension, tracker};

/// The points whose motion is baked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RequestedPoints {
    /// Every free point and marker.
    AllPoints,
    /// The wheel of this number: its centre and its spin axis. A linkage without this wheel has no outputs.
    Wheel(usize),
}

/// Three coordinates of a curve.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Output {
    /// A point's position.
    Point(String),
    /// The wheel centre's position.
    WheelCentre,
    /// The spin axis, of unit length, outboard.
    SpinAxis,
}

impl Output {
    /// Its name: that of a point, or what it is of the wheel.
    pub fn name(&self) -> &str {
        match self {
            Self::Point(name) => name,
            Self::WheelCentre => "wheel_centre",
            Self::SpinAxis => "spin_axis",
        }
    }

    /// The length that a difference of one in it counts as, if a metre is `metre`: a spin axis counts as a point one
    /// metre from the wheel centre.
    pub fn lever(&self, metre: f64) -> f64 {
        match self {
            Self::SpinAxis => metre,
            Self::Point(_) | Self::WheelCentre => 1.0,
        }
    }
}

/// A value with its first and second derivative with respect to a drive.
pub type Derivatives = [Vector3<f64>; 3];

/// A mechanism and the outputs that are read from it.
#[derive(Clone, Debug)]
pub(super) struct Driven<'a, L> {
    model: &'a L,
    reading: Reading,
}

/// The outputs that are read from the points.
#[derive(Clone, Debug)]
enum Reading {
    /// The points from this number on, with their names.
    From(usize, Vec<String>),
    /// The spin axis from one point to another, which is the wheel centre.
    Axis([usize; 2]),
}

impl Reading {
    fn new(names: &Names, points: RequestedPoints) -> Self {
        match points {
            RequestedPoints::AllPoints => {
                Self::From(names.chassis, names.points[names.chassis..].to_vec())
            }
            RequestedPoints::Wheel(number) => match names.wheels.get(number) {
                Some(wheel) => Self::Axis(wheel.points.axis),
                None => Self::From(names.points.len(), Vec::new()),
            },
        }
    }
}

impl<'a, L> Driven<'a, L> {
    /// The requested outputs of a model.
    pub(super) fn new<const N: usize>(model: &'a L, points: RequestedPoints) -> Self
    where
        L: Suspension<N>,
    {
        let reading = Reading::new(&Names::new(model), points);
        Self { model, reading }
    }

    /// Moves the drives from one set of values to another.
    pub(super) fn follow<const N: usize>(
        &self,
        [from, to]: [&L::Drives; 2],
        motion: &mut Motion<f64, N>,
    ) -> Result<(), Stopped<f64>>
    where
        L: Suspension<N>,
    {
        // The rates of the last motion belong to another way.
        *motion = motion.stopped();
        let rate = from.combined(to, |from, to| to - from);
        let inputs = |part: f64| Inputs::still(Signal::line(*from, rate, part));
        let followed = tracker().advance(self.model, inputs, 0.0, 1.0, motion);
        followed.map(drop)
    }

    /// The outputs with their derivatives in directions in which drives move at `rates`, at a motion's position and
    /// these values of the drives.
    pub(super) fn derivatives<const N: usize, const K: usize>(
        &self,
        motion: &Motion<f64, N>,
        at: L::Drives,
        rates: [L::Drives; K],
    ) -> Result<[Vec<Derivatives>; K], SolveError<f64>>
    where
        L: Suspension<N>,
    {
        Directions::at(self.model, at, &motion.position, |directions| {
            let mut derivatives = [const { Vec::new() }; K];
            for (place, rate) in derivatives.iter_mut().zip(rates) {
                *place = self.read(&directions.points(rate)?);
            }
            Ok(derivatives)
        })
    }

    pub(super) fn model(&self) -> &'a L {
        self.model
    }

    /// The outputs of points.
    pub(super) fn read<P: Values<Vector3<f64>>>(&self, points: &Signal<P>) -> Vec<Derivatives> {
        let by_order = [&points.value, &points.rate, &points.second_rate];
        let by_order = by_order.map(|points| points.values().collect::<Vec<_>>());
        let point = |point: usize| [0, 1, 2].map(|order| by_order[order][point]);
        match &self.reading {
            Reading::From(first, names) => (*first..first + names.len()).map(point).collect(),
            Reading::Axis(ends) => {
                let [inner, centre] = ends.map(point);
                let axis = [0, 1, 2].map(|order| centre[order] - inner[order]);
                // Both points belong to one body, so their distance does not change.
                let length = axis[0].norm();
                vec![centre, axis.map(|axis| axis / length)]
            }
        }
    }

    pub(super) fn outputs(&self) -> Vec<Output> {
        match &self.reading {
            Reading::From(_, names) => names.iter().cloned().map(Output::Point).collect(),
            Reading::Axis(_) => vec![Output::WheelCentre, Output::SpinAxis],
        }
    }
}
