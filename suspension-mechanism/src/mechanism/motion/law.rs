//! A quantity over time.

use std::f64::consts::TAU;

use suspension_core::Signal;

use crate::mechanism::motion::spline::Spline;

/// A quantity as a function of time in seconds.
#[derive(Clone, Debug)]
pub enum Law {
    /// A polynomial with these coefficients, constant first.
    Polynomial(Vec<f64>),
    /// A harmonic motion.
    Sine(Sine),
    /// Recorded values.
    Recorded(Spline),
}

/// `mean + amplitude sin(2 pi frequency t + phase)`.
#[derive(Clone, Copy, Debug)]
pub struct Sine {
    /// The value about which the quantity moves.
    pub mean: f64,
    /// Half of the distance between its ends.
    pub amplitude: f64,
    /// Periods in a second.
    pub frequency: f64,
    /// The angle at time 0, rad.
    pub phase: f64,
}

impl Law {
    /// The straight line that is `from` at time 0 and `to` at time 1.
    pub fn line(from: f64, to: f64) -> Self {
        Self::Polynomial(vec![from, to - from])
    }

    /// The quantity with its rates at time `t`.
    pub fn at(&self, t: f64) -> Signal<f64> {
        Signal {
            value: self.derivative(0, t),
            rate: self.derivative(1, t),
            second_rate: self.derivative(2, t),
        }
    }

    /// Its derivative of the given order at time `t`; the value itself for order 0.
    pub(super) fn derivative(&self, order: u8, t: f64) -> f64 {
        match self {
            Self::Polynomial(coefficients) => polynomial(coefficients, order, t),
            Self::Sine(sine) => sine.derivative(order, t),
            Self::Recorded(spline) => spline.derivative(order, t),
        }
    }
}

fn polynomial(coefficients: &[f64], order: u8, t: f64) -> f64 {
    let order = usize::from(order);
    let terms = coefficients.iter().enumerate().skip(order);
    terms.rfold(0.0, |sum, (power, coefficient)| {
        let derived = |factor: f64, by: usize| (power - by) as f64 * factor;
        sum * t + (0..order).fold(*coefficient, derived)
    })
}

impl Sine {
    fn derivative(&self, order: u8, t: f64) -> f64 {
        let rate = TAU * self.frequency;
        let (sine, cosine) = (rate * t + self.phase).sin_cos();
        let shape = [sine, cosine, -sine, -cosine][usize::from(order % 4)];
        let moving = self.amplitude * rate.powi(i32::from(order)) * shape;
        if order == 0 {
            self.mean + moving
        } else {
            moving
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomial_has_its_value_and_derivatives() {
        let law = Law::Polynomial(vec![1.0, 2.0, 3.0]);
        let all = [0, 1, 2, 3].map(|order| law.derivative(order, 2.0));
        assert_eq!(all, [17.0, 14.0, 6.0, 0.0]);
        assert_eq!(Law::Polynomial(vec![4.0]).derivative(1, 9.0), 0.0);
    }

    #[test]
    fn a_sine_has_the_derivatives_of_its_taylor_series() {
        let law = Law::Sine(Sine {
            mean: 0.3,
            amplitude: 0.05,
            frequency: 1.5,
            phase: 0.4,
        });
        for h in [-0.02, 0.02] {
            let series = (0..12).rfold(0.0, |sum, order| {
                law.derivative(order, 0.7) + sum * h / f64::from(order + 1)
            });
            assert!((law.at(0.7 + h).value - series).abs() < 1e-15);
        }
    }
}
