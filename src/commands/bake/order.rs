//! What a user of the command line orders, carried out on a mechanism.

use std::f64::consts::PI;

use suspension_core::DriveKind;

use crate::bake::fit::{MOST_SEGMENTS, Unmet};
use crate::bake::source::Sheet;
use crate::bake::widest::widest;
use crate::bake::{Baked, Continuity, Exact, OutOfReach, Wanted, Wish, bake};
use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{Description, advice};
use crate::number::{exact, number, rounded};

/// An order: what to bake of the mechanism of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// The drive; `None` where there is only one.
    pub drive: Option<String>,
    /// The drive's first and last value; the ends of the file's motion where not given.
    pub range: [Option<f64>; 2],
    /// How far a point may be off, m.
    pub tolerance: f64,
    /// How segments join.
    pub continuity: Continuity,
    /// Which points.
    pub wish: Wish,
}

/// Digits of a range that is possible: it is rounded to lie within what is.
const DIGITS: usize = 12;

/// A mechanism and its file.
pub struct Ordered<'a> {
    /// The file's name.
    pub file: &'a str,
    /// The mechanism.
    pub mechanism: &'a dyn Kinematics,
    /// What to bake.
    pub order: &'a Order,
}

impl Ordered<'_> {
    /// Bakes.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] where drive, range or tolerance make no sense, [`Failure::Solver`] where
    /// the mechanism does not go through the range or the tolerance is not met.
    pub fn sheet(&self) -> Result<Sheet, Failure> {
        let Description {
            linkage,
            names,
            unit,
            ..
        } = &**self.mechanism;
        let drive = names.chosen_drive(self.order.drive.as_deref());
        let drive = drive.map_err(|message| self.refuse(&message))?;
        let metre = unit.metre();
        let range = self.range(drive)?;
        let offset = self.mechanism.drive_offsets[drive];
        let wanted = Wanted {
            range: range.map(|end| end - offset),
            tolerance: self.order.tolerance * metre,
            metre,
            continuity: self.order.continuity,
        };
        if !(wanted.tolerance > 0.0 && wanted.tolerance.is_finite()) {
            return Err(self.refuse("a tolerance is a positive number of metres"));
        }
        if self.order.wish == Wish::Wheel && names.wheels.is_empty() {
            return Err(
                self.refuse("the linkage has no wheel to bake; --points all bakes its points")
            );
        }
        let others = (0..names.drives.len()).filter(|other| *other != drive);
        let held = others
            .map(|other| {
                let drive = &names.drives[other];
                let value = exact(self.given(other, self.first(other)));
                format!("{} = {value} {}", drive.name, unit.of_drive(drive.kind))
            })
            .collect::<Vec<_>>();
        Ok(Sheet {
            baked: self
                .bake(drive, &wanted)?
                .moved(self.mechanism.origin.into(), range),
            file: self.file.to_owned(),
            linkage: linkage.clone(),
            drive: names.drives[drive].name.clone(),
            drive_unit: unit.of_drive(names.drives[drive].kind),
            unit: unit.symbol(),
            held: held.join(", "),
        })
    }

    fn range(&self, drive: usize) -> Result<[f64; 2], Failure> {
        let times = self.mechanism.instants.iter();
        let through = times.map(|t| self.given(drive, self.value(drive, t)));
        let (low, high) = through.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let [from, to] = self.order.range;
        let range = [from.unwrap_or(low), to.unwrap_or(high)];
        let in_words = range.map(|end| self.in_words(drive, end)).join(" to ");
        if !(range[0] < range[1] && range.iter().all(|end| end.is_finite())) {
            return Err(self.refuse(&format!(
                "{in_words} is no range; --from must be less than --to"
            )));
        }
        let angle = self.mechanism.names.drives[drive].kind == DriveKind::Angle;
        if angle && !(0.0 <= range[0] && range[1] <= PI) {
            return Err(self.refuse(&format!(
                "{in_words}: the angle of a link from an axis lies between 0 and pi"
            )));
        }
        Ok(range)
    }

    fn bake(&self, drive: usize, wanted: &Wanted) -> Result<Baked, Failure> {
        let path = self.path(drive, wanted.range).map_err(Unmet::from);
        let unmet = match path.and_then(|path| bake(wanted, &*path)) {
            Ok(baked) => return Ok(baked),
            Err(unmet) => unmet,
        };
        let (inside, locks) = self.reach(drive, wanted.range);
        let reason = match unmet {
            Unmet::TooManySegments { at } => format!(
                "{MOST_SEGMENTS} segments do not meet {} m about {}",
                rounded(self.order.tolerance, 3),
                self.in_words(drive, self.given(drive, at))
            ),
            Unmet::OutOfReach(error) if locks.is_empty() => self.between(drive, &error),
            Unmet::OutOfReach(_) => format!("{}; {}", locks.join("; "), advice(self.file)),
        };
        let possible = self.possible(
            drive,
            &Wanted {
                range: inside,
                ..*wanted
            },
        );
        let [from, to] = wanted.range.map(|end| number(self.given(drive, end)));
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

    /// The part of a range through which the drive leads the mechanism, and in words where it locks.
    fn reach(&self, drive: usize, range: [f64; 2]) -> ([f64; 2], Vec<String>) {
        let mut locks = Vec::new();
        let now = self.first(drive);
        let [from, to] = range;
        let mut reached = [from.min(now), to.max(now)];
        for (end, wanted) in reached.iter_mut().zip(range) {
            // Beyond what the first instant has, the way to the other end leads past this one.
            if *end != wanted {
                continue;
            }
            if let Some(lock) = self.mechanism.lock_before(drive, *end) {
                locks.push(self.mechanism.lock_in_words(&lock));
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

    /// The part of a range that can be baked, in a few digits and the file's coordinates.
    fn possible(&self, drive: usize, wanted: &Wanted) -> Option<[f64; 2]> {
        /// Of a range: how close to a turning point the mechanism is solved.
        const CLOSE: f64 = 1e-6;
        let [from, to] = wanted.range;
        let range = [from + CLOSE * (to - from), to - CLOSE * (to - from)];
        let path = self.path(drive, range).ok()?;
        let widest = widest(&Wanted { range, ..*wanted }, &*path)?;
        let [from, to] = widest.map(|end| self.given(drive, end));
        let steps_a_unit = 10_f64.powf(3.0 - (to - from).log10().floor());
        let (from, to) = (from * steps_a_unit, to * steps_a_unit);
        Some([from.ceil(), to.floor()].map(|end| end / steps_a_unit))
    }

    fn path(&self, drive: usize, range: [f64; 2]) -> Result<Box<dyn Exact + '_>, OutOfReach> {
        self.mechanism.path(drive, range, self.order.wish)
    }

    /// Where the motion is lost within what the drive reaches, in words.
    fn between(&self, drive: usize, error: &OutOfReach) -> String {
        let [from, to] = error.reached.map(|end| number(self.given(drive, end)));
        let names = &self.mechanism.names;
        let cause = error
            .cause
            .map(|error| format!(" ({})", names.cause(&error)));
        format!(
            "the motion is lost between {from} and {to}{}",
            cause.unwrap_or_default()
        )
    }

    /// A drive's value in the file's coordinates, from a local one.
    fn given(&self, drive: usize, local: f64) -> f64 {
        local + self.mechanism.drive_offsets[drive]
    }

    /// A drive's local value at the first instant.
    fn first(&self, drive: usize) -> f64 {
        self.value(drive, self.mechanism.instants.ends()[0])
    }

    fn value(&self, drive: usize, t: f64) -> f64 {
        self.mechanism.drives_at(t)[drive]
    }

    fn in_words(&self, drive: usize, value: f64) -> String {
        let Description { names, unit, .. } = &**self.mechanism;
        names.drive_in_words(drive, value, *unit)
    }

    fn refuse(&self, message: &str) -> Failure {
        Failure::Input(format!("{}: {message}", self.file))
    }
}
