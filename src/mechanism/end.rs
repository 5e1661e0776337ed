//! How a motion ends.

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
    /// The drives there.
    pub drives_reached: String,
    /// What the last refused step failed with.
    pub cause: String,
    /// The drive that turns there, where one does: led by it, the mechanism locks.
    pub turns: Option<String>,
    /// The link that is too short or too long for what was asked for, in words.
    pub misfit: Option<String>,
}

impl Stop {
    /// In one sentence: what was asked for, how far the mechanism goes, and why no further.
    pub fn in_words(&self) -> String {
        let Self {
            asked,
            drives_asked,
            reached,
            drives_reached,
            cause,
            turns,
            misfit,
        } = self;
        let locks = turns.as_ref().map_or_else(String::new, |drive| {
            format!(
                " there the mechanism locks, at a turning point of drive `{drive}` where \
                 velocities grow without bound;"
            )
        });
        let misfit = misfit
            .as_ref()
            .map_or_else(String::new, |misfit| format!(" {misfit};"));
        format!(
            "no configuration at t = {} s with {drives_asked}: the motion ends at \
             t = {} s with {drives_reached} ({cause});{locks}{misfit}",
            number(*asked),
            number(*reached)
        )
        .trim_end_matches(';')
        .to_owned()
    }
}
