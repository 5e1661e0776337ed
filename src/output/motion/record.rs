//! The record of a motion: every state in files, some kept for tables and plots, and the totals.

use std::sync::atomic::AtomicBool;

use crate::failure::Failure;
use crate::interrupt::unless_set;
use crate::kinematics::Kinematics;
use crate::mechanism::{Description, End, Instants, State};
use crate::number::number;
use crate::output::file_table::{Column, Table};
use crate::output::heading::Header;
use crate::output::progress::Progress;
use crate::output::rows::TableTargets;
use crate::quantities::{self, Shown, catalogue};

/// The result of a motion.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The reason for its end.
    pub end: End,
    /// The number of instants solved.
    pub solved: usize,
    /// The last instant solved, s; the first instant of the motion if none was solved.
    pub last: f64,
    /// The number of Newton iterations of all instants.
    pub iterations: usize,
    /// The largest number of iterations of an instant.
    pub most_iterations: usize,
    /// The largest residual.
    pub residual: f64,
    /// Some states, evenly spread, the first and the last among them.
    pub kept: Vec<State>,
}

/// Moves through the instants, writes every state in all `tables` and keeps about `keep` of them.
///
/// A file is complete and has its name even if the solver stops or the user interrupts.
///
/// # Errors
///
/// If a row cannot be written.
pub fn record(
    mechanism: &dyn Kinematics,
    instants: &Instants,
    tables: &TableTargets,
    keep: usize,
    interrupted: &AtomicBool,
) -> Result<Outcome, Failure> {
    let mut table = Table::create(tables, &Header::new(mechanism), columns_of(mechanism))?;
    let [first, _] = instants.ends();
    let mut outcome = Outcome {
        end: End::Complete,
        solved: 0,
        last: first,
        iterations: 0,
        most_iterations: 0,
        residual: 0.0,
        kept: Vec::new(),
    };
    let every = instants.count().div_ceil(keep);
    let mut last = None;
    let mut progress = Progress::new(instants.count(), "instants");
    outcome.end = mechanism.move_through(instants, &mut |state| {
        table.add(&state)?;
        last = outcome.add(state, every);
        progress.step();
        Ok(unless_set(interrupted))
    })?;
    outcome.kept.extend(last);
    table.finish()?;
    Ok(outcome)
}

/// Returns the columns of the catalogue's quantities, one per number.
fn columns_of(mechanism: &Description) -> Vec<Column<State>> {
    let all = quantities::columns(catalogue(), &mechanism.names).into_iter();
    let tabled = all.filter(|column| column.quantity.shown != Shown::InSummaries);
    tabled
        .map(|column| Column::of_state(column, mechanism.unit, |state| state))
        .collect()
}

impl Outcome {
    /// Counts a state and keeps one of `every`; returns the state if it is not kept.
    fn add(&mut self, state: State, every: usize) -> Option<State> {
        let is_kept = self.solved.is_multiple_of(every);
        self.solved += 1;
        self.last = state.t;
        self.iterations += state.iterations;
        self.most_iterations = self.most_iterations.max(state.iterations);
        self.residual = self.residual.max(state.residual);
        if is_kept {
            self.kept.push(state);
            None
        } else {
            Some(state)
        }
    }

    /// Returns the last time at which the mechanism is known to have a configuration, s.
    pub fn farthest(&self) -> f64 {
        match &self.end {
            End::Stopped(stop) => stop.reached,
            End::Complete | End::Cut => self.last,
        }
    }

    /// Returns the failure of a motion that did not reach its last instant. It says that rows are kept if a table was
    /// written.
    pub fn failure(&self, source: &str, tables: &TableTargets) -> Option<Failure> {
        let done = self.done_in_words(!tables.is_empty());
        self.end.failure(source, &done)
    }

    fn done_in_words(&self, kept: bool) -> String {
        let (what, done) = if kept {
            ("row", "kept")
        } else {
            ("instant", "solved")
        };
        let last = number(self.last);
        match self.solved {
            0 => format!("no {what} was {done}"),
            1 => format!("1 {what} was {done}, at t = {last} s"),
            count => format!("{count} {what}s were {done}, up to t = {last} s"),
        }
    }
}
