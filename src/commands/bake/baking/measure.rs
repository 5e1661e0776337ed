//! A motion that a measure prescribes in place of a drive.

use std::str::FromStr;

use suspension_core::SolveError;

use crate::bake::{OutOfReach, Unmet};
use crate::commands::bake::baking::curve::Within;
use crate::commands::bake::baking::variable::own_values;
use crate::commands::bake::baking::{Baking, Variable};
use crate::failure::Failure;

/// A measure, its range, and the drive that it replaces.
#[derive(Clone, Debug, PartialEq)]
pub struct RequestedMeasure {
    /// The measure's name.
    pub name: String,
    /// The measure's first and last value, in the file's units.
    pub range: [f64; 2],
    /// The drive that becomes free; `None` if the linkage has only one.
    pub drive: Option<String>,
}

impl FromStr for RequestedMeasure {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, range) = text
            .split_once('=')
            .ok_or("write MEASURE=FROM:TO, as damper=0.30:0.40")?;
        let range = own_values(range)?;
        Ok(Self {
            name: name.trim().to_owned(),
            range,
            drive: None,
        })
    }
}

impl Baking<'_> {
    pub(super) fn along_measure(&self, requested: &RequestedMeasure) -> Result<Variable, Failure> {
        let names = &self.mechanism.names;
        let (name, all) = (requested.name.as_str(), names.measure_names());
        let measure = all.iter().position(|other| *other == name);
        let measure = measure.ok_or_else(|| {
            self.refuse(
                &match (names.drive_names().contains(&name), all.as_slice()) {
                    (true, _) => {
                        format!("`{name}` is a drive; --drive {name}=FROM:TO bakes along it")
                    }
                    (false, []) => format!("the linkage has no measure `{name}`, nor any other"),
                    (false, all) => format!(
                        "unknown measure `{name}`; the measures are {}",
                        all.join(", ")
                    ),
                },
            )
        })?;
        let drive = match (&requested.drive, names.drive_names().as_slice()) {
            (None, several @ [_, _, ..]) => Err(format!(
                "--drive must say in place of which drive `{name}` leads: {}",
                several.join(", ")
            )),
            (wanted, _) => names.chosen_drive(wanted.as_deref()),
        };
        let drive = drive.map_err(|message| self.refuse(&message))?;
        let per = self
            .mechanism
            .unit
            .file_factor(names.measures[measure].kind);
        let (range, offset) = (
            requested.range.map(|end| end / per),
            self.mechanism.measure_offsets[measure],
        );
        Ok(Variable {
            drive,
            measure: Some(measure),
            range,
            local: range.map(|end| end - offset),
        })
    }

    /// Says how far a measure leads the mechanism, and why no further.
    pub(super) fn reach_of_measure(&self, along: &Variable, unmet: &Unmet) -> (String, Within) {
        let [from, to] = along.local;
        let (why, range) = match unmet {
            Unmet::TooManySegments { .. } => (String::new(), along.local),
            Unmet::OutOfReach(error) => {
                let [first, last] = error.reached;
                (
                    self.describe_failure(along, error),
                    [first.max(from), last.min(to)],
                )
            }
        };
        let kept = [0, 1].map(|end| range[end] == along.local[end]);
        (why, Within { range, kept })
    }

    /// Says why the measure does not lead through its range.
    fn describe_failure(&self, along: &Variable, error: &OutOfReach) -> String {
        match &error.cause {
            Some(SolveError::TurningPoint { extreme, .. }) => format!(
                "the measure turns back at {}, there is none beyond on this branch",
                self.in_words(along, *extreme)
            ),
            cause => {
                let [from, to] = error.reached.map(|end| self.in_words(along, end));
                let cause = self.cause(*cause);
                format!("the mechanism is led from {from} to {to} only{cause}")
            }
        }
    }
}
