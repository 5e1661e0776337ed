//! Drives as polynomials of time, and the inputs of the solver that follow from them.

use suspension_core::listing::Part;
use suspension_core::solve::report::Report;
use suspension_core::step::stepper::Stopped;
use suspension_core::{Inputs, Linkage, Motion, Signal, SolveError, Still, Tracker, Values};

/// A polynomial of time in seconds, constant first.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial(Vec<f64>);

impl Polynomial {
    /// The polynomial with these coefficients, constant first.
    pub fn new(coefficients: Vec<f64>) -> Self {
        Self(coefficients)
    }

    /// The straight line that is `from` at time 0 and `to` at time 1.
    pub fn line(from: f64, to: f64) -> Self {
        Self(vec![from, to - from])
    }

    /// The polynomial's value, or that of a derivative, at time `t`.
    pub fn at(&self, t: f64) -> f64 {
        self.0.iter().rfold(0.0, |sum, c| sum * t + c)
    }

    /// The first derivative.
    pub fn derivative(&self) -> Self {
        let rates = self.0.iter().enumerate().skip(1);
        Self(rates.map(|(power, c)| power as f64 * c).collect())
    }
}

/// A quantity over time: a polynomial with its first and second derivative.
#[derive(Clone, Debug)]
pub struct Law([Polynomial; 3]);

impl Law {
    /// The quantity that a polynomial describes.
    pub fn new(value: Polynomial) -> Self {
        let rate = value.derivative();
        let second_rate = rate.derivative();
        Self([value, rate, second_rate])
    }

    /// The quantity with its rates at time `t`.
    pub fn at(&self, t: f64) -> Signal<f64> {
        let [value, rate, second_rate] = self.0.each_ref().map(|law| law.at(t));
        Signal {
            value,
            rate,
            second_rate,
        }
    }
}

/// The drives of a linkage over time, in the order of its drives.
#[derive(Clone, Debug)]
pub struct DriveLaws {
    laws: Vec<Law>,
}

impl DriveLaws {
    /// The drives that these polynomials describe, one for each drive.
    pub fn new(polynomials: impl IntoIterator<Item = Polynomial>) -> Self {
        Self {
            laws: polynomials.into_iter().map(Law::new).collect(),
        }
    }

    /// Drives that keep their values.
    pub fn held(values: impl Iterator<Item = f64>) -> Self {
        Self::new(values.map(|value| Polynomial::new(vec![value])))
    }

    /// Each drive at time `t`.
    pub fn at(&self, t: f64) -> impl Iterator<Item = Signal<f64>> {
        self.laws.iter().map(move |law| law.at(t))
    }

    /// Taylor coefficients of the drives at time `t`, order 1 first.
    pub fn terms<D: Values<f64>, const K: usize>(&self, t: f64) -> [D; K] {
        let mut derivatives: Vec<Polynomial> =
            self.laws.iter().map(|law| law.0[0].clone()).collect();
        let mut factorial = 1.0;
        std::array::from_fn(|index| {
            factorial *= (index + 1) as f64;
            for derivative in &mut derivatives {
                *derivative = derivative.derivative();
            }
            let values = derivatives.iter().map(|derivative| derivative.at(t));
            D::from_values(values.map(|value| value / factorial))
        })
    }

    /// The inputs at time `t`, with the chassis at rest.
    pub fn inputs<D: Values<f64>>(&self, t: f64) -> Inputs<Still, D> {
        let [value, rate, second_rate] =
            [0, 1, 2].map(|order| D::from_values(self.laws.iter().map(|law| law.0[order].at(t))));
        Inputs::still(Signal {
            value,
            rate,
            second_rate,
        })
    }
}

/// The number of steps that the way from one instant to the next may take.
pub(crate) const MAX_STEPS: usize = 10_000;

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomial_has_its_value_and_derivatives() {
        let drive = Polynomial::new(vec![1.0, 2.0, 3.0]);
        assert_eq!(drive.at(2.0), 17.0);
        assert_eq!(drive.derivative().at(2.0), 14.0);
        assert_eq!(drive.derivative().derivative().at(2.0), 6.0);
        assert_eq!(Polynomial::new(vec![4.0]).derivative().at(9.0), 0.0);
    }
}
