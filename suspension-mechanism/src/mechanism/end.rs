//! How a motion ends.

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
