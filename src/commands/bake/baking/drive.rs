//! A drive and the range over which it is baked.

use std::str::FromStr;

use crate::commands::bake::baking::variable::own_values;
use crate::commands::bake::baking::{Baking, DIGITS, Variable};
use crate::failure::Failure;
use crate::grid::doubt;
use crate::mechanism::{CountedFrom, Description, Drive, ends};
use crate::number::{number, rounded};
use crate::output::notes::print_notes_on;

/// A drive and its range.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RequestedDrive {
    /// The drive's name; `None` where there is only one.
    pub drive: Option<String>,
    /// The drive's first and last value; the ends of the file's motion where not given.
    pub range: [Option<f64>; 2],
}

impl FromStr for RequestedDrive {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, range) = match text.split_once('=') {
            Some((name, range)) => (name, own_values(range)?.map(Some)),
            None => (text, [None; 2]),
        };
        Ok(Self {
            drive: Some(name.trim().to_owned()),
            range,
        })
    }
}

impl Baking<'_> {
    pub(super) fn along_drive(&self, requested: &RequestedDrive) -> Result<Variable, Failure> {
        let drive = self
            .mechanism
            .names
            .chosen_drive(requested.drive.as_deref());
        let drive = drive.map_err(|message| self.refuse(&message))?;
        let range = self.range(drive, requested)?;
        let offset = self.mechanism.drive_offsets[drive];
        let along = Variable {
            drive,
            measure: None,
            range,
            local: range.map(|end| end - offset),
        };
        if let [Some(from), Some(to)] = requested.range {
            self.check_doubt(&along, [from, to])?;
        }
        let Description { names, unit, .. } = &**self.mechanism;
        let kind = names.drives[drive].kind;
        let mut ends = range.into_iter();
        match ends.find_map(|end| unit.angle.bounds_exceeded(kind, end)) {
            Some(bounds) => {
                Err(self.refuse(&format!("{}: {bounds}", self.range_in_words(drive, range))))
            }
            None => Ok(along),
        }
    }

    /// Notes that a range, `stated` in the file's units, seems to count from the design position, as those of other commands
    /// do.
    ///
    /// # Errors
    ///
    /// The same note as an error, if no part of the range is within reach.
    fn check_doubt(&self, along: &Variable, stated: [f64; 2]) -> Result<(), Failure> {
        let Description { names, unit, .. } = &**self.mechanism;
        let Drive { name, kind } = &names.drives[along.drive];
        let design = self.mechanism.design[along.drive] * unit.file_factor(*kind);
        let [from, to] = stated.map(|end| rounded(design + end, DIGITS));
        let way = format!("; for that range about the design write --drive {name}={from}:{to}");
        let range = (stated, self.mechanism.unit);
        let Some(doubt) = doubt(self.mechanism, along.drive, range, CountedFrom::Zero, &way) else {
            return Ok(());
        };
        let ([low, high], _) = self.reach(along);
        let [first, last] = along.local;
        if high <= first || low >= last {
            let [from, to] = stated.map(number);
            return Err(Failure::Solver(format!(
                "{}: {name} cannot be baked from {from} to {to}: {doubt}",
                self.file
            )));
        }
        print_notes_on(self.file, [doubt]);
        Ok(())
    }

    /// Returns a drive's range in the file's coordinates.
    fn range(&self, drive: usize, requested: &RequestedDrive) -> Result<[f64; 2], Failure> {
        let times = self.mechanism.instants.iter();
        let through = times.map(|t| self.given(drive, self.value(drive, t)));
        let [low, high] = ends(through).unwrap_or_default();
        let Description { names, unit, .. } = &**self.mechanism;
        let kind = names.drives[drive].kind;
        let inside = |end: f64| end / unit.file_factor(kind);
        let [from, to] = requested.range.map(|end| end.map(inside));
        let range = [from.unwrap_or(low), to.unwrap_or(high)];
        if low == high && requested.range == [None, None] {
            let name = &names.drives[drive].name;
            return Err(self.refuse(&format!(
                "the file's motion holds {name}; say its range, as --drive {name}=FROM:TO"
            )));
        }
        if !(range[0] < range[1] && range.iter().all(|end| end.is_finite())) {
            let in_words = self.range_in_words(drive, range);
            return Err(self.refuse(&format!(
                "{in_words} is not a range; --from must be less than --to"
            )));
        }
        Ok(range)
    }

    fn range_in_words(&self, drive: usize, range: [f64; 2]) -> String {
        let Description { names, unit, .. } = &**self.mechanism;
        let ends = range.map(|end| names.drive_in_words(drive, end, *unit));
        ends.join(" to ")
    }
}
