//! A motion that a measure prescribes in place of a drive.

use suspension_core::SolveError;

use crate::bake::fit::{MOST_SEGMENTS, Unmet};
use crate::bake::source::Ranged;
use crate::bake::widest::widest;
use crate::bake::{Baked, OutOfReach, Wanted, bake};
use crate::commands::bake::request::possible::possible_in_few_digits;
use crate::commands::bake::request::{Baking, DIGITS};
use crate::failure::Failure;
use crate::file::Dimension;
use crate::mechanism::Unit;
use crate::number::{number, rounded};

/// A measure, its range, and the drive that it replaces.
#[derive(Clone, Debug, PartialEq)]
pub struct WishedMeasure {
    /// The measure's name.
    pub name: String,
    /// The measure's first and last value, in the file's units.
    pub range: [f64; 2],
    /// The drive that becomes free; `None` if the linkage has only one.
    pub drive: Option<String>,
}

/// A measure over its range.
pub(super) struct AlongMeasure {
    pub(super) measure: usize,
    /// The drive that becomes free.
    pub(super) drive: usize,
    /// The range in the file's coordinates, angles in radians.
    range: [f64; 2],
}

impl Baking<'_> {
    pub(super) fn along_measure(&self, wished: &WishedMeasure) -> Result<AlongMeasure, Failure> {
        let names = &self.mechanism.names;
        let (name, all) = (wished.name.as_str(), names.measure_names());
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
        let drive = match (&wished.drive, names.drive_names().as_slice()) {
            (None, several @ [_, _, ..]) => Err(format!(
                "--drive must say in place of which drive `{name}` leads: {}",
                several.join(", ")
            )),
            (wanted, _) => names.chosen_drive(wanted.as_deref()),
        };
        let drive = drive.map_err(|message| self.refuse(&message))?;
        let per = Dimension::from(names.measures[measure].kind).file_factor(self.mechanism.unit);
        Ok(AlongMeasure {
            measure,
            drive,
            range: wished.range.map(|end| end / per),
        })
    }

    /// Describes the measure and its range; `unit` is that of the baked functions.
    pub(super) fn ranged(&self, along: &AlongMeasure, unit: Unit) -> Ranged {
        let names = &self.mechanism.names;
        let measure = &names.measures[along.measure];
        Ranged {
            name: measure.name.clone(),
            unit: Dimension::from(measure.kind).symbol(unit),
            range: along.range,
            in_place_of: Some(names.drives[along.drive].name.clone()),
        }
    }

    pub(super) fn curve_along(&self, along: &AlongMeasure) -> Result<Baked, Failure> {
        let metre = self.mechanism.unit.metre();
        let offset = self.mechanism.measure_offsets[along.measure];
        let wanted = Wanted {
            range: along.range.map(|end| end - offset),
            tolerance: self.request.tolerance * metre,
            metre,
            continuity: self.request.continuity,
        };
        let baked = self.bake_along(along, &wanted);
        let baked = baked.map_err(|unmet| self.unmet_along(along, &wanted, &unmet))?;
        Ok(baked.moved(self.mechanism.origin.into(), along.range))
    }

    fn bake_along(&self, along: &AlongMeasure, wanted: &Wanted) -> Result<Baked, Unmet> {
        let AlongMeasure { measure, drive, .. } = *along;
        let path = self
            .mechanism
            .led_path([measure, drive], wanted.range, self.request.wish)?;
        bake(wanted, &*path)
    }

    fn unmet_along(&self, along: &AlongMeasure, wanted: &Wanted, unmet: &Unmet) -> Failure {
        let name = &self.mechanism.names.measures[along.measure].name;
        let (reason, inside) = match unmet {
            Unmet::TooManySegments { at } => {
                let tolerance = rounded(self.request.tolerance, 3);
                let at = self.format_value(along, *at);
                let reason =
                    format!("{MOST_SEGMENTS} segments do not meet {tolerance} m about {at}");
                (reason, wanted.range)
            }
            Unmet::OutOfReach(error) => (self.describe_failure(along, error), error.reached),
        };
        let possible = self.possible_along(
            along,
            &Wanted {
                range: inside,
                ..*wanted
            },
        );
        let advice = possible.map_or_else(
            || "no part of the range can be baked".to_owned(),
            |[from, to]| format!("possible is --along {name}={from}:{to}"),
        );
        let [from, to] = along
            .range
            .map(|end| number(self.measured_in_file(along, end)));
        Failure::Solver(format!(
            "{}: {name} cannot be baked from {from} to {to}: {reason}; {advice}",
            self.file
        ))
    }

    /// Says why the measure does not lead through its range.
    fn describe_failure(&self, along: &AlongMeasure, error: &OutOfReach) -> String {
        let names = &self.mechanism.names;
        match &error.cause {
            Some(SolveError::TurningPoint { extreme, .. }) => format!(
                "the measure turns back at {}, there is none beyond on this branch",
                self.format_value(along, *extreme)
            ),
            cause => {
                let [from, to] = error.reached.map(|end| self.format_value(along, end));
                let cause = cause.map(|cause| format!(" ({})", names.cause(&cause)));
                let cause = cause.unwrap_or_default();
                format!("the mechanism is led from {from} to {to} only{cause}")
            }
        }
    }

    /// Returns the part of a range that can be baked, in the file's coordinates and units.
    fn possible_along(&self, along: &AlongMeasure, wanted: &Wanted) -> Option<[String; 2]> {
        let AlongMeasure { measure, drive, .. } = *along;
        let offset = self.mechanism.measure_offsets[measure];
        let asked = along.range.map(|end| end - offset);
        let range = [wanted.range[0].max(asked[0]), wanted.range[1].min(asked[1])];
        let kept = [0, 1].map(|end| range[end] == asked[end]);
        let in_file = |end| self.measured_in_file(along, end + offset);
        let widest = possible_in_few_digits(range, kept, in_file, |range| {
            let path = self
                .mechanism
                .led_path([measure, drive], range, self.request.wish);
            widest(&Wanted { range, ..*wanted }, &*path.ok()?)
        })?;
        Some(widest.map(|end| rounded(end, DIGITS)))
    }

    /// Formats a local value of the measure with its unit.
    fn format_value(&self, along: &AlongMeasure, local: f64) -> String {
        let measure = &self.mechanism.names.measures[along.measure];
        let given = local + self.mechanism.measure_offsets[along.measure];
        let symbol = Dimension::from(measure.kind).symbol(self.mechanism.unit);
        format!(
            "{} = {} {symbol}",
            measure.name,
            number(self.measured_in_file(along, given))
        )
    }

    /// Converts a value to the file's units.
    fn measured_in_file(&self, along: &AlongMeasure, given: f64) -> f64 {
        let kind = self.mechanism.names.measures[along.measure].kind;
        given * Dimension::from(kind).file_factor(self.mechanism.unit)
    }
}
