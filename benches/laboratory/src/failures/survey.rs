//! Every method at every point of every axis.

use std::sync::atomic::{AtomicBool, Ordering};

use rand_pcg::Pcg64;

use super::method::Method;
use super::outcome::{Counts, Outcome};
use super::rows::LongRow;
use super::rows::{Axis, Row};
use suspension::output::progress::Progress;

/// How much is tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Trials behind each point; of whole motions a tenth.
    pub starts: usize,
    /// Steps of the long runs.
    pub long_run: u64,
    /// Of the random numbers.
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

/// What was found so far.
pub struct Survey<'a> {
    /// How much is tried.
    pub effort: &'a Effort,
    /// A metre in the unit of the motion.
    pub metre: f64,
    /// Set where the user wants no more.
    pub interrupted: &'a AtomicBool,
    /// Counts.
    pub counted: Counted,
    /// How far it is.
    pub progress: Progress,
}

/// Of a point: whose it is and where it lies.
pub struct Place<'a> {
    /// How bodies are closed.
    pub closure: &'a str,
    /// The number type.
    pub scalar: &'static str,
    /// What is varied.
    pub axis: Axis,
    /// Its value.
    pub value: f64,
    /// The unit of the value.
    pub unit: &'static str,
}

impl Survey<'_> {
    /// Whether the user wants no more.
    pub fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }

    /// Counts what becomes of the trials, each with the residual of its result, and adds a row. A
    /// point at which the user interrupts is left out.
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

    /// The same numbers for every method, closure and number type.
    pub fn random(&self, axis: Axis, index: usize) -> Pcg64 {
        let stream = ((axis as u64) << 32) | index as u64;
        Pcg64::new(self.effort.seed.into(), stream.into())
    }
}
