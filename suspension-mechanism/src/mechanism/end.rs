//! The end of a motion.

use crate::failure::Failure;
use crate::mechanism::words::advice;
use crate::number::number;

/// How a motion ended.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// At the last instant.
    Complete,
    /// Where the receiver of the rows wanted it.
    Cut,
    /// Where the solver found no further configuration.
    Stopped(Stop),
}

impl End {
    /// What remains to be said of the motion of `file` where it did not reach its last instant, and of what was `done`.
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
    /// The instant that was asked for, s.
    pub asked: f64,
    /// The drives there.
    pub drives_asked: String,
    /// The last time at which the mechanism has a configuration, s.
    pub reached: f64,
    /// Why the mechanism goes no further, in words.
    pub cause: String,
    /// Whether drives, not a measure, lead it.
    pub is_driven: bool,
}

impl Stop {
    /// In one sentence: what was asked for, how far the mechanism goes, and why no further. `file` is the motion's.
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
