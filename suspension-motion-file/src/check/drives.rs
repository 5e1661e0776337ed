//! Drives over time.

use std::f64::consts::TAU;
use std::ops::Range;

use toml::Spanned;

use super::each;
use crate::failure::Failure;
use crate::source::Source;
use crate::tables::entries::Table;
use crate::tables::stated_law::{Sine, StatedLaw};

/// A place and what is wrong there.
type Fault = (Range<usize>, &'static str);

/// Checks the drives over time: at least one coefficient each, a positive frequency, all numbers and the rates of a sine finite.
///
/// # Errors
///
/// [`Failure::Input`] at each other drive.
pub fn drives(source: &Source, table: &Table<StatedLaw>) -> Result<(), Failure> {
    each(table, |name, law| {
        let fault = match law.get_ref() {
            StatedLaw::Polynomial(coefficients) => {
                polynomial_fault(coefficients).map(|fault| (law.span(), fault))
            }
            StatedLaw::Sine(sine) => sine_fault(sine),
            StatedLaw::Recorded(recording) => {
                not_finite([&recording.factor].into_iter().chain(&recording.offset))
            }
        };
        fault.map_or(Ok(()), |(place, fault)| {
            Err(source.refuse(&place, format!("drive `{name}` {fault}")))
        })
    })
}

fn polynomial_fault(coefficients: &[f64]) -> Option<&'static str> {
    if coefficients.is_empty() {
        Some("needs at least one coefficient")
    } else if coefficients.iter().any(|c| !c.is_finite()) {
        Some("has a coefficient that is not a finite number")
    } else {
        None
    }
}

fn sine_fault(sine: &Sine) -> Option<Fault> {
    let numbers = [&sine.mean, &sine.amplitude, &sine.frequency, &sine.phase];
    let [amplitude, frequency] = [&sine.amplitude, &sine.frequency].map(|number| *number.get_ref());
    let second_rate = amplitude * (TAU * frequency).powi(2);
    not_finite(numbers).or_else(|| {
        let fault = if frequency <= 0.0 {
            "needs a positive frequency, in periods per second"
        } else if !second_rate.is_finite() {
            "has a frequency that is too large to compute with"
        } else {
            return None;
        };
        Some((sine.frequency.span(), fault))
    })
}

fn not_finite<'a>(numbers: impl IntoIterator<Item = &'a Spanned<f64>>) -> Option<Fault> {
    let mut numbers = numbers.into_iter();
    let number = numbers.find(|number| !number.get_ref().is_finite())?;
    Some((number.span(), "has a number that is not finite"))
}
