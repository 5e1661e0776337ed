//! Drives as functions of time, and the inputs of the solver that follow from them.

use suspension_core::listing::Part;
use suspension_core::solve::report::Report;
use suspension_core::step::stepper::Stopped;
use suspension_core::{Inputs, Linkage, Motion, Signal, SolveError, Still, Tracker, Values};

use crate::mechanism::motion::law::Law;

/// The drives of a linkage over time, in the order of its drives.
#[derive(Clone, Debug)]
pub struct DriveLaws {
    laws: Vec<Law>,
}

impl DriveLaws {
    /// The drives that these laws describe, one for each drive.
    pub fn new(laws: impl IntoIterator<Item = Law>) -> Self {
        Self {
            laws: laws.into_iter().collect(),
        }
    }

    /// Drives that keep their values.
    pub fn held(values: impl Iterator<Item = f64>) -> Self {
        Self::new(values.map(|value| Law::Polynomial(vec![value])))
    }

    /// Whether a drive is recorded, so that nothing is known of it beyond the last instant.
    pub(crate) fn are_recorded(&self) -> bool {
        let mut laws = self.laws.iter();
        laws.any(|law| matches!(law, Law::Recorded(_)))
    }

    /// Each drive at time `t`.
    pub fn at(&self, t: f64) -> impl Iterator<Item = Signal<f64>> {
        self.laws.iter().map(move |law| law.at(t))
    }

    /// Taylor coefficients of the drives at time `t`, order 1 first.
    pub fn terms<D: Values<f64>, const K: usize>(&self, t: f64) -> [D; K] {
        let (mut order, mut factorial) = (0, 1.0);
        std::array::from_fn(|_| {
            order += 1;
            factorial *= f64::from(order);
            let derivatives = self.laws.iter().map(|law| law.derivative(order, t));
            D::from_values(derivatives.map(|derivative| derivative / factorial))
        })
    }

    /// The inputs at time `t`, with the chassis at rest.
    pub fn inputs<D: Values<f64>>(&self, t: f64) -> Inputs<Still, D> {
        let [value, rate, second_rate] = [0, 1, 2]
            .map(|order| D::from_values(self.laws.iter().map(|law| law.derivative(order, t))));
        Inputs::still(Signal {
            value,
            rate,
            second_rate,
        })
    }
}

/// The number of steps that the way from one instant to the next may take.
pub(crate) const MAX_STEPS: usize = 10_000;

/// The inputs with drives that keep these values, and the chassis at rest.
pub(crate) fn inputs_at_rest<D: Default>(drives: D) -> Inputs<Still, D> {
    Inputs::still(Signal::still(drives))
}

/// A change of one drive by one.
pub(crate) fn unit_change<D: Values<f64>>(drive: usize) -> D {
    D::from_values([]).with(drive, 1.0)
}

/// The settings with which motions are followed.
pub(crate) fn tracker() -> Tracker<f64> {
    Tracker {
        max_steps: MAX_STEPS,
        ..Tracker::default()
    }
}

/// Follows the motion from one time to another, in as many steps as it takes.
///
/// # Errors
///
/// [`Stopped`] if the mechanism goes no further.
pub fn follow<L: Linkage<N, Scalar = f64>, const N: usize>(
    model: &L,
    drives: &DriveLaws,
    times: [f64; 2],
    motion: &mut Motion<f64, N>,
) -> Result<Report<f64>, Stopped<f64>> {
    advance(model, |t| drives.inputs(t), times, motion)
}

/// The same for inputs that are a function of time. Angles that go beyond their range are refused, because the
/// equations have the sine or cosine of other angles there.
pub(crate) fn advance<L: Linkage<N, Scalar = f64>, const N: usize>(
    model: &L,
    inputs: impl Fn(f64) -> Inputs<Still, L::Drives>,
    [from, to]: [f64; 2],
    motion: &mut Motion<f64, N>,
) -> Result<Report<f64>, Stopped<f64>> {
    let asked = inputs(to).drives.value;
    let beyond = asked.values().enumerate().find_map(|(drive, asked)| {
        let end = model.drive_kind(drive).end_exceeded(asked)?;
        let part = Part::Drive(drive);
        Some(SolveError::OutOfRange { part, asked, end })
    });
    if let Some(error) = beyond {
        return Err(Stopped {
            reached: from,
            refused: Some((to - from, error)),
        });
    }
    tracker().advance(model, inputs, from, to, motion)
}
