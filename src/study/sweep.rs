//! A sweep and those who look on: the CSV file, the rows kept for tables, the totals.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::failure::Failure;
use crate::input::instants::Instants;
use crate::number::number;
use crate::output::csv_file::{CsvFile, Target};
use crate::output::progress::Progress;
use crate::study::{End, Study};

/// The rows of a table: names above, numbers below.
#[derive(Clone, Debug, Default)]
pub struct Rows {
    /// The columns' names.
    pub columns: Vec<String>,
    /// One list of numbers an instant.
    pub rows: Vec<Vec<f64>>,
}

impl Rows {
    /// The values of a column; `None` where no column has the name.
    pub fn column(&self, name: &str) -> Option<Vec<f64>> {
        let index = self.columns.iter().position(|column| column == name)?;
        Some(self.rows.iter().map(|row| row[index]).collect())
    }
}

/// What a sweep came to.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// How it ended.
    pub end: End,
    /// Instants solved.
    pub solved: usize,
    /// The last of them, s.
    pub last: f64,
    /// Newton iterations of all instants.
    pub iterations: f64,
    /// The most that one instant took.
    pub most_iterations: f64,
    /// The largest residual.
    pub residual: f64,
    /// Rows kept: evenly spread, the first and the last among them.
    pub kept: Rows,
}

/// Sweeps through the instants, writes every row to `csv` and keeps about `keep` of them.
///
/// A file is complete and named even where the solver stops or the user interrupts.
///
/// # Errors
///
/// Where a row cannot be written.
pub fn run(
    study: &dyn Study,
    instants: &Instants,
    csv: Option<&Target>,
    keep: usize,
    interrupted: &AtomicBool,
) -> Result<Outcome, Failure> {
    let columns = study.columns();
    let mut csv = csv
        .map(|target| CsvFile::create(target, &columns))
        .transpose()?;
    let mut totals = Totals::new(columns, instants.count().div_ceil(keep));
    let mut progress = Progress::new(instants.count(), "instants");
    let end = study.sweep(instants, &mut |row| {
        if let Some(csv) = &mut csv {
            csv.row(row)?;
        }
        totals.add(row);
        progress.step();
        Ok(if interrupted.load(Ordering::Relaxed) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        })
    })?;
    if let Some(csv) = csv {
        csv.finish()?;
    }
    Ok(totals.outcome(end))
}

struct Totals {
    outcome: Outcome,
    every: usize,
    last_row: Vec<f64>,
    iterations_column: usize,
}

impl Totals {
    fn new(columns: Vec<String>, every: usize) -> Self {
        // Iterations and residual close each row.
        let iterations_column = columns.len() - 2;
        let kept = Rows {
            columns,
            rows: Vec::new(),
        };
        Self {
            outcome: Outcome {
                end: End::Complete,
                solved: 0,
                last: f64::NAN,
                iterations: 0.0,
                most_iterations: 0.0,
                residual: 0.0,
                kept,
            },
            every,
            last_row: Vec::new(),
            iterations_column,
        }
    }

    fn add(&mut self, row: &[f64]) {
        let Outcome {
            solved,
            last,
            iterations,
            most_iterations,
            residual,
            kept,
            ..
        } = &mut self.outcome;
        if solved.is_multiple_of(self.every) {
            kept.rows.push(row.to_vec());
        }
        *solved += 1;
        *last = row[0];
        *iterations += row[self.iterations_column];
        *most_iterations = most_iterations.max(row[self.iterations_column]);
        *residual = residual.max(row[self.iterations_column + 1]);
        self.last_row.clear();
        self.last_row.extend_from_slice(row);
    }

    fn outcome(self, end: End) -> Outcome {
        let mut outcome = Outcome {
            end,
            ..self.outcome
        };
        let kept = &mut outcome.kept.rows;
        if outcome.solved > 0 && kept.last() != Some(&self.last_row) {
            kept.push(self.last_row);
        }
        outcome
    }
}

impl Outcome {
    /// The last time at which the mechanism is known to have a configuration, s.
    pub fn farthest(&self) -> f64 {
        match &self.end {
            End::Stopped(stop) => stop.reached,
            End::Complete | End::Cut => self.last,
        }
    }

    /// What remains to be said where the sweep did not reach its last instant. Rows are kept
    /// where a table was written.
    pub fn failure(&self, source: &str, table: Option<&Target>) -> Option<Failure> {
        let done = self.done_in_words(table.is_some());
        match &self.end {
            End::Complete => None,
            End::Cut => Some(Failure::Interrupted(format!(
                "{source}: interrupted; {done}"
            ))),
            End::Stopped(stop) => Some(Failure::Solver(format!(
                "{source}: {}; {done}",
                stop.in_words()
            ))),
        }
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
