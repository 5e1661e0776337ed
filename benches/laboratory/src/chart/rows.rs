//! The rows of the chart: our methods' and the rivals'.

use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use suspension::failure::Failure;

/// One method in one number type at one time step: a row of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The method.
    pub method: String,
    /// Its number type.
    pub scalar: String,
    /// Suspensions that a step moves.
    pub lanes: usize,
    /// The time step, s.
    pub step_s: f64,
    /// The last output of a step: `position`, `velocity`, `acceleration`, each with the ones before.
    pub outputs: String,
    /// The median time of a step, per suspension.
    pub nanoseconds: f64,
    /// The range of the middle half of the times.
    pub spread_ns: f64,
    /// The worst error of a coordinate over the motion.
    pub error_position_m: Option<f64>,
    /// The worst error of a velocity.
    pub error_velocity_m_s: Option<f64>,
    /// The worst error of an acceleration.
    pub error_acceleration_m_s2: Option<f64>,
    /// The points of the errors: `all` here, `wheel` in other tables.
    pub points: String,
}

/// A row of the table that `benches/rivals` writes.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Rival {
    /// The program or library.
    pub method: String,
    /// Its version.
    pub version: String,
    /// How it was compiled.
    pub flags: String,
    /// `newton`: an iteration; `position`: the position of a step; `step`: with velocity and
    /// acceleration.
    pub quantity: String,
    /// The time step, s.
    pub step_s: Option<f64>,
    /// The median time.
    pub nanoseconds: Option<f64>,
    /// The range of the middle half of the times.
    pub spread_ns: Option<f64>,
    /// The worst error of a coordinate.
    pub error_position_m: Option<f64>,
    /// The worst error of a velocity.
    pub error_velocity_m_s: Option<f64>,
    /// The worst error of an acceleration.
    pub error_acceleration_m_s2: Option<f64>,
    /// A remark.
    pub note: String,
}

impl Row {
    /// Returns the method, the number type unless it is `f64`, and the lanes if there are several.
    pub fn name(&self) -> String {
        let scalar = if self.scalar == "f64" {
            ""
        } else {
            &self.scalar
        };
        let lanes = match self.lanes {
            1 => String::new(),
            lanes => format!("×{lanes}"),
        };
        let parts = [&self.method, scalar, &lanes];
        let parts = parts.into_iter().filter(|part| !part.is_empty());
        parts.collect::<Vec<_>>().join(" ")
    }

    /// Returns the error of the row's last output.
    pub fn error(&self) -> Option<f64> {
        match self.outputs.as_str() {
            "position" => self.error_position_m,
            "velocity" => self.error_velocity_m_s,
            _ => self.error_acceleration_m_s2,
        }
    }
}

impl Rival {
    /// Returns time and error if the row computes exactly `outputs` in steps of `step_s`. Rows of our own methods in the
    /// table of rivals are omitted.
    pub fn point(&self, outputs: &str, step_s: f64) -> Option<(f64, f64)> {
        let is_rival = !self.method.starts_with("ours");
        let error = match (self.quantity.as_str(), outputs) {
            ("position", "position") => self.error_position_m,
            ("step", "acceleration") => self.error_acceleration_m_s2,
            _ => None,
        };
        let same_step = (self.step_s? - step_s).abs() < 1e-6 * step_s;
        (is_rival && same_step).then_some((self.nanoseconds?, error?))
    }
}

/// The columns: the fields of a [`Row`].
const COLUMNS: [&str; 11] = [
    "method",
    "scalar",
    "lanes",
    "step_s",
    "outputs",
    "nanoseconds",
    "spread_ns",
    "error_position_m",
    "error_velocity_m_s",
    "error_acceleration_m_s2",
    "points",
];

/// The rows as comma-separated values.
///
/// # Errors
///
/// [`Failure::Output`].
pub fn to_csv(rows: &[Row]) -> Result<String, Failure> {
    // The header is written even without rows.
    let mut writer = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(Vec::new());
    let header = writer.write_record(COLUMNS);
    let written = header.and_then(|()| rows.iter().try_for_each(|row| writer.serialize(row)));
    let text = written
        .map_err(|error| error.to_string())
        .and_then(|()| writer.into_inner().map_err(|error| error.to_string()))
        .and_then(|bytes| String::from_utf8(bytes).map_err(|error| error.to_string()));
    text.map_err(|error| Failure::Output(format!("the table cannot be written: {error}")))
}

/// Reads a table of comma-separated values; empty if there is no file.
///
/// # Errors
///
/// [`Failure::Input`] if the file is not such a table.
pub fn from_csv<R: DeserializeOwned>(path: &Path) -> Result<Vec<R>, Failure> {
    if !path.exists() {
        return Ok(Vec::new());
    }
    let rows = csv::Reader::from_path(path).and_then(|mut reader| reader.deserialize().collect());
    rows.map_err(|error| Failure::Input(format!("{}: {error}", path.display())))
}
