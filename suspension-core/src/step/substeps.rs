//! An interval of time in as few steps as possible: after a refusal the step is halved, and from the second success in a row
//! on it is doubled.

use crate::arithmetic::scalar::Real;
use crate::error::{Cause, Explain, Facts, SolveError, messages};
use crate::solve::report::Report;

/// The number of steps that one advance may try by default.
pub(crate) const MAX_STEPS: usize = 200;

/// Where and why an advance ended early. The motion is then that of the last good step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stopped<T> {
    /// The time of the last good motion.
    pub reached: T,
    /// The length of the last step that was refused, and the reason; `None` if good steps have used up `max_steps`.
    pub refused: Option<(T, SolveError<T>)>,
}

impl<T: Real> Explain for Stopped<T> {
    fn facts(&self) -> Facts {
        let facts = match &self.refused {
            Some((_, error)) => error.facts(),
            None => Facts::new(Cause::StepsUsedUp, None),
        };
        Facts {
            reached: Some(self.reached.to_subset_unchecked()),
            ..facts
        }
    }
}

messages! {
    [T: Real] Stopped<T>;
}

/// Goes from one time to another, in either direction, trying at most `max_steps` steps. `step` makes the step to a
/// time, of a length, or leaves everything unchanged.
///
/// # Errors
///
/// [`Stopped`] if steps have shrunk to rounding or all are used up.
pub(crate) fn advance_in_steps<T: Real>(
    [from, to]: [T; 2],
    max_steps: usize,
    mut step: impl FnMut(T, T) -> Result<Report<T>, SolveError<T>>,
) -> Result<Report<T>, Stopped<T>> {
    let mut reached = from;
    let mut dt = to - from;
    let shortest = (from.abs().max(to.abs())) * T::EPSILON * T::constant(4.0);
    let mut advanced = Report::default();
    let mut refused = None;
    for _ in 0..max_steps {
        let last_step = (to - reached).abs() <= dt.abs();
        let next = if last_step { to } else { reached + dt };
        match step(next, next - reached) {
            Ok(report) => {
                reached = next;
                advanced = advanced.with_next(report);
                if last_step {
                    return Ok(advanced);
                }
                // Right after a refusal twice the step would be the one that was refused.
                if refused.take().is_none() {
                    dt *= T::constant(2.0);
                }
            }
            Err(error) => {
                refused = Some((next - reached, error));
                dt = (next - reached) * T::constant(0.5);
                // A NaN ends the advance too.
                let is_long_enough = dt.abs() > shortest;
                if !is_long_enough {
                    break;
                }
            }
        }
    }
    Err(Stopped { reached, refused })
}
