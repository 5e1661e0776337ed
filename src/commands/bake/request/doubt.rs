//! Ranges that seem to count from the design position.

use crate::commands::bake::request::{Along, Baking, DIGITS};
use crate::failure::Failure;
use crate::file::{Dimension, tell};
use crate::grid::doubt;
use crate::mechanism::{CountedFrom, Description, Drive};
use crate::number::{number, rounded};

impl Baking<'_> {
    /// Notes that a range, `stated` in the file's units, seems to count from the design position, as those of other commands
    /// do.
    ///
    /// # Errors
    ///
    /// The same note as an error, if no part of the range is within reach.
    pub(super) fn check_doubt(&self, along: &Along, stated: [f64; 2]) -> Result<(), Failure> {
        let Description { names, unit, .. } = &**self.mechanism;
        let Drive { name, kind } = &names.drives[along.drive];
        let design = self.mechanism.design[along.drive] * Dimension::from(*kind).file_factor(*unit);
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
        tell(format_args!("note: {}: {doubt}", self.file));
        Ok(())
    }
}
