//! A search for assemblies that shows its progress and can be interrupted.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::assemblies::Stage;
use crate::failure::Failure;
use crate::output::progress::Found;

/// Shows how many assemblies are found. A first interrupt ends the search; a second one ends the work that follows it.
pub struct Watched<'a> {
    file: &'a str,
    found: Found,
    interrupted: &'a AtomicBool,
    is_ended: AtomicBool,
}

impl<'a> Watched<'a> {
    /// Starts to watch the search in a file's mechanism.
    pub fn new(file: &'a str, interrupted: &'a AtomicBool) -> Self {
        Self {
            file,
            found: Found::new("assemblies of such a mechanism with general dimensions"),
            interrupted,
            is_ended: AtomicBool::new(false),
        }
    }

    /// Shows the count; returns whether the search goes on.
    pub fn goes_on(&self, stage: Stage, count: usize) -> bool {
        self.found.show(count);
        if stage == Stage::Follow {
            return !self.interrupted.load(Ordering::Relaxed);
        }
        let ends = self.interrupted.swap(false, Ordering::Relaxed);
        if ends {
            self.is_ended.store(true, Ordering::Relaxed);
            self.found.tell(format_args!(
                "note: {}: the search has stopped; the assemblies found are now followed to the file's lengths; interrupt again to stop this too",
                self.file
            ));
        }
        !ends
    }

    /// Removes the progress line.
    pub fn clear(&self) {
        self.found.clear();
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
