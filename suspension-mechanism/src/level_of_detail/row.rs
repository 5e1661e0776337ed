//! The rows of a table of figures.

use serde::de::{Deserialize, Deserializer, Error};

use suspension_core::step::bounded::Outputs;

use crate::level_of_detail::{Detail, Points};

/// One measurement of a table, without the columns that are not needed here.
#[derive(Clone, Debug, serde::Deserialize)]
pub(super) struct Row {
    method: String,
    scalar: String,
    lanes: u32,
    pub(super) step_s: f64,
    #[serde(deserialize_with = "outputs")]
    outputs: Outputs,
    nanoseconds: f64,
    error_position_m: f64,
    /// The points whose position it is.
    points: Points,
}

impl Row {
    /// `None` if it is not for one suspension in `f64`, or is there for comparison only.
    pub(super) fn detail(&self) -> Option<Detail> {
        let method = self.method.parse().ok()?;
        (self.scalar == "f64" && self.lanes == 1).then_some(Detail {
            method,
            outputs: self.outputs,
            points: self.points,
            nanoseconds: self.nanoseconds,
            error: self.error_position_m,
        })
    }
}

fn outputs<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Outputs, D::Error> {
    match String::deserialize(deserializer)?.as_str() {
        "position" => Ok(Outputs::Position),
        "velocity" => Ok(Outputs::Velocity),
        "acceleration" => Ok(Outputs::Acceleration),
        other => Err(D::Error::custom(format!("unknown outputs `{other}`"))),
    }
}
