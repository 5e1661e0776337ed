//! The progress on standard error of work that takes more than a second.

pub mod search;

use std::io::{IsTerminal, stderr};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// Progress of longer work is shown.
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
    /// Starts the progress of work in `total` steps, which are called `units`.
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

    /// Counts a step.
    pub fn step(&mut self) {
        /// The most steps between two readings of the clock, which takes as long as a step of a small mechanism.
        const STEPS_A_LOOK: usize = 64;
        self.done += 1;
        // A step of a hundred may take a second.
        let steps_a_look = (self.total / 100).clamp(1, STEPS_A_LOOK);
        if !self.visible || !self.done.is_multiple_of(steps_a_look) {
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
    let template = format!("{{bar:40}} {{percent}} % of {{len}} {units}");
    styled(ProgressBar::new(total as u64), &template)
}

/// Says what work of unknown length does, and for how long, once it has taken a second and only on a terminal.
#[derive(Debug)]
pub struct Busy {
    end: Option<Sender<()>>,
    shown: Option<JoinHandle<()>>,
}

impl Busy {
    /// Starts work, for example "baking".
    pub fn new(work: &'static str) -> Self {
        let (end, ended) = channel();
        let show = move || show_until(&ended, work);
        let visible = stderr().is_terminal();
        // Without a thread the work goes on unseen.
        let shown = visible.then(|| Builder::new().spawn(show).ok()).flatten();
        Self {
            end: Some(end),
            shown,
        }
    }
}

impl Drop for Busy {
    fn drop(&mut self) {
        drop(self.end.take());
        if let Some(shown) = self.shown.take() {
            let _ = shown.join();
        }
    }
}

fn show_until(ended: &Receiver<()>, work: &str) {
    const REDRAWN: Duration = Duration::from_millis(100);
    let goes_on = |time| ended.recv_timeout(time) == Err(RecvTimeoutError::Timeout);
    if !goes_on(LONG) {
        return;
    }
    let line = spinner(&format!("{{spinner}} {work} ({{elapsed}})")).with_elapsed(LONG);
    while goes_on(REDRAWN) {
        line.tick();
    }
    line.finish_and_clear();
}

fn spinner(template: &str) -> ProgressBar {
    styled(ProgressBar::new_spinner(), template)
}

fn styled(line: ProgressBar, template: &str) -> ProgressBar {
    match ProgressStyle::with_template(template) {
        Ok(style) => line.with_style(style),
        Err(_) => line,
    }
}
