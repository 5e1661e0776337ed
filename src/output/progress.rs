//! A progress bar on standard error, for work that takes more than a second.

use std::io::{IsTerminal, stderr};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

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
        if self.bar.is_none() && self.began.elapsed() > Duration::from_secs(1) {
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
