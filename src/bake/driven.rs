//! The exact motion of a mechanism whose drives move on straight lines.

use nalgebra::Vector3;
use suspension_core::{
    Build, HasWheel, Inputs, Kind, Motion, Part, Signal, SolveError, Still, Stopped, Tangent,
    Tracker, Values,
};

/// Which points are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// Every free point and marker.
    AllPoints,
    /// The wheel: its centre and its spin axis.
    Wheel,
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
    /// Its name: a point's, or what it is of the wheel.
    pub fn name(&self) -> &str {
        match self {
            Self::Point(name) => name,
            Self::WheelCentre => "wheel_centre",
            Self::SpinAxis => "spin_axis",
        }
    }

    /// What a difference of one in it counts as, in lengths, where a metre is `metre`: a spin axis
    /// counts as a point one metre from the wheel centre.
    pub fn lever(&self, metre: f64) -> f64 {
        match self {
            Self::SpinAxis => metre,
            Self::Point(_) | Self::WheelCentre => 1.0,
        }
    }
}

/// A value with its first and second derivative with respect to a drive.
pub type Derivatives = [Vector3<f64>; 3];

/// A mechanism and what is read of it.
#[derive(Clone, Debug)]
pub(super) struct Driven<'a, L> {
    pub(super) model: &'a L,
    pub(super) wish: Wish,
}

impl<L> Driven<'_, L> {
    /// Moves the drives from one set of values to another.
    pub(super) fn follow<const N: usize>(
        &self,
        [from, to]: [&L::Drives; 2],
        motion: &mut Motion<f64, N>,
    ) -> Result<(), Stopped<f64>>
    where
        L: Build<N, Scalar = f64>,
    {
        let tracker = Tracker {
            max_steps: 10_000,
            ..Tracker::default()
        };
        // The rates of the last motion are those of another way.
        *motion = Motion {
            positive_determinant: motion.positive_determinant,
            ..Motion::at_rest(motion.position)
        };
        let rate: L::Drives = combined(from, to, |from, to| to - from);
        let inputs = |part: f64| {
            let value = combined(from, &rate, |from, way| from + way * part);
            moving(value, rate)
        };
        let followed = tracker.advance(self.model, inputs, 0.0, 1.0, motion);
        followed.map(|_| ())
    }

    /// The outputs with their derivatives in the direction in which drives move at `rate`.
    pub(super) fn derivatives<const N: usize>(
        &self,
        motion: &Motion<f64, N>,
        at: L::Drives,
        rate: L::Drives,
    ) -> Result<Vec<Derivatives>, SolveError<f64>>
    where
        L: Build<N, Scalar = f64, Points: HasWheel<f64>>,
    {
        let inputs = moving(at, rate);
        let motion = Tangent::new(self.model, &inputs, &motion.position)?.motion()?;
        let points = motion.points(self.model, &inputs);
        let by_order = [&points.value, &points.rate, &points.second_rate];
        Ok(match self.wish {
            Wish::Wheel => {
                let [inner, centre] = [0, 1].map(|end| by_order.map(|points| points.wheel()[end]));
                let axis = [0, 1, 2].map(|order| centre[order] - inner[order]);
                // Both points belong to one body: their distance does not change.
                let length = axis[0].norm();
                vec![centre, axis.map(|axis| axis / length)]
            }
            Wish::AllPoints => {
                let each = by_order.map(|points| points.values().collect::<Vec<_>>());
                let count = each[0].len();
                let point = |point: usize| [0, 1, 2].map(|order| each[order][point]);
                (first_free(self.model)..count).map(point).collect()
            }
        })
    }

    /// What the outputs are.
    pub(super) fn outputs<const N: usize>(&self) -> Vec<Output>
    where
        L: Build<N, Scalar = f64>,
    {
        match self.wish {
            Wish::Wheel => vec![Output::WheelCentre, Output::SpinAxis],
            Wish::AllPoints => {
                let kinds = [Kind::ChassisPoint, Kind::FreePoint, Kind::Marker];
                let count = kinds.map(|kind| self.model.count(kind)).iter().sum();
                let free = first_free(self.model)..count;
                free.map(|point| Output::Point(self.model.name(Part::Point(point)).to_owned()))
                    .collect()
            }
        }
    }
}

/// Chassis points come first, then all that moves.
fn first_free<L: Build<N, Scalar = f64>, const N: usize>(model: &L) -> usize {
    model.count(Kind::ChassisPoint)
}

fn moving<D: Values<f64> + Default>(value: D, rate: D) -> Inputs<Still, D> {
    Inputs::still(Signal {
        value,
        rate,
        second_rate: D::default(),
    })
}

/// Two sets of drives, name by name.
fn combined<D: Values<f64>>(a: &D, b: &D, with: impl Fn(f64, f64) -> f64) -> D {
    D::from_values(a.values().zip(b.values()).map(|(a, b)| with(a, b)))
}
