//! The table of counts.

use serde::{Deserialize, Serialize};

use suspension::failure::Failure;

/// The varied quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// Normal deviation of every coordinate of a start, m.
    StartNoise,
    /// Length of the steps that follow the whole motion, s.
    Step,
    /// Distance from a turning point of the drive at which a step ends, m or rad.
    TurningPoint,
}

impl Axis {
    /// All axes in the order of figures.
    pub const ALL: [Self; 3] = [Self::StartNoise, Self::Step, Self::TurningPoint];

    /// Returns the quantity in words.
    pub fn in_words(self) -> &'static str {
        match self {
            Self::StartNoise => "noise of the start",
            Self::Step => "time step",
            Self::TurningPoint => "to the turning point",
        }
    }
}

/// One method at one point of an axis: a row of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The varied quantity.
    pub axis: Axis,
    /// The value of the varied quantity.
    pub value: f64,
    /// The unit of the value: m, s or rad.
    pub unit: String,
    /// The method.
    pub method: String,
    /// The formulation of bodies.
    pub closure: String,
    /// The number type.
    pub scalar: String,
    /// All trials.
    pub trials: usize,
    /// The number of trials that ended in the right configuration.
    pub right: usize,
    /// The number that ended in another one, reported as a result.
    pub wrong_branch: usize,
    /// The number of these in which a body is mirrored.
    pub mirrored: usize,
    /// The number without a root, as the method reports.
    pub no_root: usize,
    /// The largest residual of a result, m.
    pub residual_m: f64,
    /// The seed of the random numbers.
    pub seed: u64,
}

/// A stretch of a long run: a row of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LongRow {
    /// The method.
    pub method: String,
    /// The formulation of bodies.
    pub closure: String,
    /// The number type.
    pub scalar: String,
    /// Steps from the beginning.
    pub steps: u64,
    /// The largest residual after any step since the row before, m: the error of lengths.
    pub drift_m: f64,
    /// Iterations of a step since the row before; of an integrator none.
    pub iterations_a_step: f64,
    /// The reason for which the run ended here; empty if it continued or made all its steps.
    pub ended: String,
}

/// Rows as comma-separated values, under the names of their fields.
///
/// # Errors
///
/// [`Failure::Output`].
pub fn to_csv<R: Serialize>(rows: &[R]) -> Result<String, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let written = rows.iter().try_for_each(|row| writer.serialize(row));
    let text = written
        .map_err(|error| error.to_string())
        .and_then(|()| writer.into_inner().map_err(|error| error.to_string()))
        .and_then(|bytes| String::from_utf8(bytes).map_err(|error| error.to_string()));
    text.map_err(|error| Failure::Output(format!("the table cannot be written: {error}")))
}
