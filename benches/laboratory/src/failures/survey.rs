//! Every method at every point of every axis.

use std::sync::atomic::{AtomicBool, Ordering};

use rand_pcg::Pcg64;

use super::method::Method;
use super::outcome::{Counts, Outcome};
use super::rows::LongRow;
use super::rows::{Axis, Row};
use suspension::output::progress::Progress;

/// The number of trials.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Trials behind each point; of whole motions a tenth.
    pub starts: usize,
    /// Steps of the long runs.
    pub long_run: u64,
    /// The seed of the random numbers.
    pub seed: u64,
}

/// All counts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counted {
    /// A row a method, closure, number type and point.
    pub rows: Vec<Row>,
    /// Rows of the long runs.
    pub long_runs: Vec<LongRow>,
}

/// The results so far.
pub struct Survey<'a> {
    /// The number of trials.
    pub effort: &'a Effort,
    /// A metre in the unit of the motion.
    pub metre: f64,
    /// Set if the user interrupts.
    pub interrupted: &'a AtomicBool,
    /// Counts.
    pub counted: Counted,
    /// The progress.
    pub progress: Progress,
}

/// The labels of a point of the map.
pub struct Place<'a> {
    /// The formulation of bodies.
    pub closure: &'a str,
    /// The number type.
    pub scalar: &'static str,
    /// The varied quantity.
    pub axis: Axis,
    /// The value of the varied quantity.
    pub value: f64,
    /// The unit of the value.
    pub unit: &'static str,
}

impl Survey<'_> {
    /// Returns whether the user has interrupted.
    pub fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }

    /// Counts the outcomes of the trials, each with the residual of its result, and adds a row. Omits a point at which the
    /// user interrupts.
    pub fn count<R>(
        &mut self,
        place: &Place<'_>,
        method: Method,
        trials: &[R],
        outcome: impl Fn(&R) -> (Outcome, f64),
    ) {
        let mut counts = Counts::default();
        for trial in trials {
            if self.is_interrupted() {
                return;
            }
            let (outcome, residual) = outcome(trial);
            counts.add(outcome, residual / self.metre);
        }
        self.counted.rows.push(Row {
            axis: place.axis,
            value: place.value,
            unit: place.unit.to_owned(),
            method: method.name().to_owned(),
            closure: place.closure.to_owned(),
            scalar: place.scalar.to_owned(),
            trials: counts.trials,
            right: counts.right,
            wrong_branch: counts.wrong,
            mirrored: counts.mirrored,
            no_root: counts.no_root,
            residual_m: counts.residual,
            seed: self.effort.seed,
        });
        self.progress.step();
    }

    /// Returns the same random numbers for every method, closure and number type.
    pub fn random(&self, axis: Axis, index: usize) -> Pcg64 {
        let stream = ((axis as u64) << 32) | index as u64;
        Pcg64::new(self.effort.seed.into(), stream.into())
    }
}
