//! The end of a motion.

use crate::failure::Failure;
use crate::mechanism::parts::words::advice;
use crate::number::number;

/// The end of a motion.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// The motion reached its last instant.
    Complete,
    /// The receiver of the rows ended it.
    Cut,
    /// The solver found no further configuration.
    Stopped(Stop),
}

impl End {
    /// The failure to report for the motion of `file` if it did not reach its last instant, with what was `done`.
    pub fn failure(&self, file: &str, done: &str) -> Option<Failure> {
        match self {
            Self::Complete => None,
            Self::Cut => Some(Failure::Interrupted(format!("{file}: interrupted; {done}"))),
            Self::Stopped(stop) => {
                let why = stop.in_words(file);
                Some(Failure::Solver(format!("{file}: {why}; {done}")))
            }
        }
    }
}

/// Where and why the solver stopped.
#[derive(Clone, Debug, PartialEq)]
pub struct Stop {
    /// The requested instant, s.
    pub asked: f64,
    /// The drives at the requested instant.
    pub drives_asked: String,
    /// The last time at which the mechanism has a configuration, s.
    pub reached: f64,
    /// Why the mechanism goes no further, in words.
    pub cause: String,
    /// Whether drives lead it, and not a measure.
    pub is_driven: bool,
}

impl Stop {
    /// One sentence: what was requested, how far the mechanism goes, and why no further. `file` is the file of the
    /// motion.
    pub fn in_words(&self, file: &str) -> String {
        let Self {
            asked,
            drives_asked,
            reached,
            cause,
            ..
        } = self;
        let [asked, reached] = [*asked, *reached].map(number);
        let advice = if self.is_driven {
            format!("; {}", advice(file))
        } else {
            String::new()
        };
        format!(
            "no configuration at t = {asked} s with {drives_asked}: the motion ends at t = {reached} s: {cause}{advice}"
        )
    }
}
