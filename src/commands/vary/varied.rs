//! What is varied, in words.

use crate::failure::Failure;
use crate::kinematics::{Kinematics, misplaced_points};
use crate::mechanism::quoted;
use crate::number::{rounded, without_rounding};
use crate::sensitivities::Change;

/// What is varied, in which suspension.
pub(super) struct Varied<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a dyn Kinematics,
    pub(super) change: Change,
}

impl Varied<'_> {
    /// Names a value, for example `rack.z 3 mm`.
    pub(super) fn in_words(&self, value: f64) -> String {
        let unit = self.mechanism.unit.symbol();
        format!("{} {} {unit}", self.change.name, label(value))
    }

    /// Adds to a failure that begins with the file's name with which value it is; the design has none.
    pub(super) fn with_value(&self, value: f64, failure: Failure) -> Failure {
        match failure {
            Failure::Solver(message) if value != 0.0 => {
                let named = format!("{} with {}", self.file, self.in_words(value));
                Failure::Solver(message.replacen(self.file, &named, 1))
            }
            other => other,
        }
    }

    /// Says which points are not where the file or the largest of the values puts them; `None` if there are none.
    pub(super) fn describe_elsewhere(&self, values: &[f64]) -> Option<String> {
        let largest = values.iter().copied();
        let largest = largest.max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
        let points = misplaced_points(self.mechanism, self.change.per_unit.times(largest).points);
        let names = &self.mechanism.names.points;
        let points = quoted(points.iter().map(|point| &names[*point]));
        (!points.is_empty()).then(|| {
            format!(
                "with {} the points do not satisfy the listing; the suspension is assembled with {points} elsewhere",
                self.in_words(largest)
            )
        })
    }

    /// Says that no value changes anything.
    pub(super) fn describe_no_effect(&self) -> String {
        format!(
            "{}: {} changes no quantity at the design position and no derivative there; vary another coordinate, or draw the curves \
             over travel with --html",
            self.file, self.change.name
        )
    }
}

/// Returns a value with the digits in which evenly spaced values are told.
pub(super) fn label(value: f64) -> String {
    const DIGITS: usize = 6;
    rounded(without_rounding(value), DIGITS)
}
