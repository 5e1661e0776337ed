//! The progress of a search for assemblies, which an interrupt ends.

use std::io::{IsTerminal, stderr};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use indicatif::ProgressBar;

use super::{LONG, spinner};
use crate::assemblies::Stage;
use crate::failure::Failure;
use crate::file::tell;

/// Shows how many assemblies are found, once the search has taken a second and only on a terminal. A first interrupt ends the
/// search; a second one ends the work that follows it.
#[derive(Debug)]
pub struct Search<'a> {
    file: &'a str,
    began: Instant,
    line: OnceLock<ProgressBar>,
    visible: bool,
    interrupted: &'a AtomicBool,
    is_ended: AtomicBool,
}

impl<'a> Search<'a> {
    /// Starts to watch the search in a file's mechanism.
    pub fn new(file: &'a str, interrupted: &'a AtomicBool) -> Self {
        Self {
            file,
            began: Instant::now(),
            line: OnceLock::new(),
            visible: stderr().is_terminal(),
            interrupted,
            is_ended: AtomicBool::new(false),
        }
    }

    /// Shows the count; returns whether the search goes on.
    pub fn goes_on(&self, stage: Stage, count: usize) -> bool {
        self.show(count);
        if stage == Stage::Follow {
            return !self.interrupted.load(Ordering::Relaxed);
        }
        let ends = self.interrupted.swap(false, Ordering::Relaxed);
        if ends {
            self.is_ended.store(true, Ordering::Relaxed);
            let note = format!(
                "note: {}: the search has stopped; the assemblies found are now followed to the file's lengths; interrupt again to stop this too",
                self.file
            );
            match self.line.get() {
                Some(line) => line.suspend(|| tell(note)),
                None => tell(note),
            }
        }
        !ends
    }

    fn show(&self, count: usize) {
        const SHOWN: &str =
            "{spinner} {pos} assemblies of such a mechanism with general dimensions ({elapsed})";
        if self.visible && self.began.elapsed() > LONG {
            let line = self.line.get_or_init(|| spinner(SHOWN));
            line.set_position(count as u64);
        }
    }

    /// Removes the progress before other output.
    pub fn clear(&self) {
        if let Some(line) = self.line.get() {
            line.finish_and_clear();
        }
    }

    /// Returns the failure of a second interrupt, which says what was given up after `done`.
    pub fn given_up(&self, done: &str) -> Failure {
        Failure::Interrupted(format!("{}: interrupted {done}", self.file))
    }

    /// Returns an error if an interrupt ended the search.
    ///
    /// # Errors
    ///
    /// [`Failure::Interrupted`].
    pub fn ended(&self) -> Result<(), Failure> {
        if self.is_ended.load(Ordering::Relaxed) {
            return Err(self.given_up("in its search for assemblies, of which there may be more"));
        }
        Ok(())
    }
}

impl Drop for Search<'_> {
    fn drop(&mut self) {
        self.clear();
    }
}
