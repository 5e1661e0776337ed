//! A motion along one drive, or the possible part of it.

use crate::bake::fit::{MOST_SEGMENTS, Unmet};
use crate::bake::widest::widest;
use crate::bake::{Baked, Exact, OutOfReach, Wanted, bake};
use crate::commands::bake::request::possible::possible_in_few_digits;
use crate::commands::bake::request::{Along, Baking, DIGITS};
use crate::failure::Failure;
use crate::file::Dimension;
use crate::mechanism::advice;
use crate::number::{number, rounded};

impl Baking<'_> {
    pub(super) fn curve(&self, along: &Along) -> Result<Baked, Failure> {
        let metre = self.mechanism.unit.metre();
        let wanted = Wanted {
            range: along.local,
            tolerance: self.request.tolerance * metre,
            metre,
            continuity: self.request.continuity,
        };
        let baked = self.bake(along.drive, &wanted)?;
        Ok(baked.moved(self.mechanism.origin.into(), along.range))
    }

    fn bake(&self, drive: usize, wanted: &Wanted) -> Result<Baked, Failure> {
        let path = self.path(drive, wanted.range).map_err(Unmet::from);
        let unmet = match path.and_then(|path| bake(wanted, &*path)) {
            Ok(baked) => return Ok(baked),
            Err(unmet) => unmet,
        };
        let (inside, locks) = self.reach(drive, wanted.range);
        let mut kept = locks.each_ref().map(Option::is_none);
        let reason = match unmet {
            Unmet::TooManySegments { at } => format!(
                "{MOST_SEGMENTS} segments do not meet {} m about {}",
                rounded(self.request.tolerance, 3),
                self.in_words(drive, self.given(drive, at))
            ),
            Unmet::OutOfReach(error) if locks == [None, None] => {
                kept = [false; 2];
                self.lost_between(drive, &error)
            }
            Unmet::OutOfReach(_) => {
                let locks: Vec<String> = locks.into_iter().flatten().collect();
                format!("{}; {}", locks.join("; "), advice(self.file))
            }
        };
        let possible = self.possible(
            drive,
            &Wanted {
                range: inside,
                ..*wanted
            },
            kept,
        );
        let [from, to] = wanted.range.map(|end| number(self.in_file(drive, end)));
        let advice = possible.map_or_else(
            || "no part of the range can be baked".to_owned(),
            |ends| {
                let [from, to] = ends.map(|end| rounded(end, DIGITS));
                format!("possible is --from {from} --to {to}")
            },
        );
        let name = &self.mechanism.names.drives[drive].name;
        Err(Failure::Solver(format!(
            "{}: {name} cannot be baked from {from} to {to}: {reason}; {advice}",
            self.file
        )))
    }

    /// Returns the part of a range through which the drive leads the mechanism, and for either end, in words, what limits
    /// it.
    pub(super) fn reach(&self, drive: usize, range: [f64; 2]) -> ([f64; 2], [Option<String>; 2]) {
        let mut locks = [None, None];
        let now = self.first(drive);
        let [from, to] = range;
        let mut reached = [from.min(now), to.max(now)];
        for ((end, wanted), in_the_way) in reached.iter_mut().zip(range).zip(&mut locks) {
            // The path to the other end passes this end if it is beyond the first instant.
            if *end != wanted {
                continue;
            }
            if let Some(lock) = self.mechanism.lock_before(drive, *end) {
                *in_the_way = Some(self.mechanism.lock_in_words(&lock));
                *end = lock.drives[drive] - self.mechanism.drive_offsets[drive];
            }
        }
        let [low, high] = reached;
        let inside = [low.max(from), high.min(to)];
        // The message for a range beyond a lock gives the part up to the lock.
        let inside = if inside[0] < inside[1] {
            inside
        } else {
            reached
        };
        (inside, locks)
    }

    /// Returns the part of a range that can be baked, in a few digits, in the file's coordinates and units.
    fn possible(&self, drive: usize, wanted: &Wanted, kept: [bool; 2]) -> Option<[f64; 2]> {
        possible_in_few_digits(
            wanted.range,
            kept,
            |end| self.in_file(drive, end),
            |range| {
                let path = self.path(drive, range).ok()?;
                widest(&Wanted { range, ..*wanted }, &*path)
            },
        )
    }

    /// Converts a local value to the file's coordinates and units.
    fn in_file(&self, drive: usize, local: f64) -> f64 {
        let kind = self.mechanism.names.drives[drive].kind;
        self.given(drive, local) * Dimension::from(kind).file_factor(self.mechanism.unit)
    }

    fn path(&self, drive: usize, range: [f64; 2]) -> Result<Box<dyn Exact + '_>, OutOfReach> {
        self.mechanism.path(drive, range, self.request.wish)
    }

    /// Says at which value, within the reach of the drive, the solver lost the motion.
    fn lost_between(&self, drive: usize, error: &OutOfReach) -> String {
        let [from, to] = error.reached.map(|end| number(self.in_file(drive, end)));
        let names = &self.mechanism.names;
        let cause = error
            .cause
            .map(|error| format!(" ({})", names.cause(&error)));
        format!(
            "the motion is lost between {from} and {to}{}",
            cause.unwrap_or_default()
        )
    }
}
