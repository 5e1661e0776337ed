//! Drives as polynomials of time.

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
