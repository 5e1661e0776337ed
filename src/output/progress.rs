//! The progress of work that takes more than a second, on standard error.

use std::fmt::Display;
use std::io::{IsTerminal, stderr};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use crate::file::tell;

/// What takes longer is shown.
const LONG: Duration = Duration::from_secs(1);

/// Counts steps; shows a bar once the work has taken a second and only on a terminal.
#[derive(Debug)]
pub struct Progress {
    began: Instant,
    total: usize,
    units: &'static str,
    done: usize,
    bar: Option<ProgressBar>,
    visible: bool,
}

impl Progress {
    /// Of work in `total` steps, each one of the `units`.
    pub fn new(total: usize, units: &'static str) -> Self {
        Self {
            began: Instant::now(),
            total,
            units,
            done: 0,
            bar: None,
            visible: stderr().is_terminal(),
        }
    }

    /// One more step is done.
    pub fn step(&mut self) {
        /// Reading the clock takes as long as a step of a small mechanism.
        const STEPS_A_LOOK: usize = 64;
        self.done += 1;
        if !self.visible || !self.done.is_multiple_of(STEPS_A_LOOK) {
            return;
        }
        if self.bar.is_none() && self.began.elapsed() > LONG {
            self.bar = Some(bar(self.total, self.units));
        }
        if let Some(bar) = &self.bar {
            bar.set_position(self.done as u64);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn bar(total: usize, units: &str) -> ProgressBar {
    let bar = ProgressBar::new(total as u64);
    let style =
        ProgressStyle::with_template(&format!("{{bar:40}} {{percent}} % of {{len}} {units}"));
    match style {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// Tells how many are found so far, of what nobody knows the number of; shown once the search has taken a second and only
/// on a terminal.
#[derive(Debug)]
pub struct Found {
    began: Instant,
    units: &'static str,
    line: OnceLock<ProgressBar>,
    visible: bool,
}

impl Found {
    /// None yet of the `units`.
    pub fn new(units: &'static str) -> Self {
        Self {
            began: Instant::now(),
            units,
            line: OnceLock::new(),
            visible: stderr().is_terminal(),
        }
    }

    /// So many are found.
    pub fn show(&self, count: usize) {
        if self.visible && self.began.elapsed() > LONG {
            let line = self.line.get_or_init(|| counter(self.units));
            line.set_position(count as u64);
        }
    }

    /// Tells something above what is shown.
    pub fn tell(&self, note: impl Display) {
        match self.line.get() {
            Some(line) => line.suspend(|| tell(note)),
            None => tell(note),
        }
    }

    /// Takes the line away for good, before something else is written.
    pub fn clear(&self) {
        if let Some(line) = self.line.get() {
            line.finish_and_clear();
        }
    }
}

impl Drop for Found {
    fn drop(&mut self) {
        self.clear();
    }
}

fn counter(units: &str) -> ProgressBar {
    let line = ProgressBar::new_spinner();
    let style = ProgressStyle::with_template(&format!("{{spinner}} {{pos}} {units} ({{elapsed}})"));
    match style {
        Ok(style) => line.with_style(style),
        Err(_) => line,
    }
}
