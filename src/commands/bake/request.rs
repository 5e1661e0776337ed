//! What the command line asks for, carried out on a mechanism.

mod curve;
mod doubt;
mod measure;
mod surface;

use std::sync::atomic::{AtomicBool, Ordering};

use suspension_core::SolveError;

use crate::bake::source::{About, Ranged, Sheet, Table};
use crate::bake::{Continuity, Wish};
use crate::failure::Failure;
use crate::file::Dimension;
use crate::kinematics::Kinematics;
use crate::mechanism::{Angle, Description, Drive, Unit, ends};
use crate::number::{exact, number};

pub use measure::WishedMeasure;

/// Digits of a range that is proposed, rounded to lie within the possible one.
const DIGITS: usize = 12;

/// What to bake of the mechanism of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The variables on which the baked functions depend.
    pub along: Variables,
    /// The largest error of a point, m.
    pub tolerance: f64,
    /// How many derivatives are continuous where segments join.
    pub continuity: Continuity,
    /// The points to bake.
    pub wish: Wish,
}

/// The variables on which the baked functions depend.
#[derive(Clone, Debug, PartialEq)]
pub enum Variables {
    /// One drive for a curve, two for a surface.
    Drives(Vec<Wished>),
    /// A measure in place of a drive, for a curve.
    Measure(WishedMeasure),
}

/// A drive and its range.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wished {
    /// The drive's name; `None` where there is only one.
    pub drive: Option<String>,
    /// The drive's first and last value; the ends of the file's motion where not given.
    pub range: [Option<f64>; 2],
}

/// An order with the mechanism and the name of its file.
pub struct Baking<'a> {
    /// The file's name.
    pub file: &'a str,
    /// The mechanism.
    pub mechanism: &'a dyn Kinematics,
    /// What to bake.
    pub request: &'a Request,
    /// Set when the user interrupts the program.
    pub interrupted: &'a AtomicBool,
}

/// A drive, or a measure that leads in place of it, over its range.
struct Along {
    drive: usize,
    measure: Option<usize>,
    /// The range in the file's coordinates, angles in radians.
    range: [f64; 2],
    /// The range in local coordinates.
    local: [f64; 2],
}

impl Baking<'_> {
    /// Bakes the ordered motion.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if drives, ranges or tolerance are wrong, [`Failure::Solver`] if the mechanism does not pass
    /// through the ranges or the tolerance is not met.
    pub fn execute(&self) -> Result<Sheet, Failure> {
        self.check()?;
        let Description {
            linkage,
            names,
            unit,
            ..
        } = &**self.mechanism;
        // Programs that read the baked file use radians.
        let inside = Unit {
            angle: Angle::Radian,
            ..*unit
        };
        let (along, baked) = match &self.request.along {
            Variables::Drives(drives) => self.by_drives(drives)?,
            Variables::Measure(wished) => {
                let along = self.along_measure(wished)?;
                let baked = Table::Curve(self.curve(&along)?);
                (vec![along], baked)
            }
        };
        let arguments = along.iter().map(|along| self.ranged(along, inside));
        let wheel = names.wheels.first();
        let wheel = wheel.map(|wheel| wheel.title("wheel"));
        let sheet = Sheet {
            about: About {
                file: self.file.to_owned(),
                linkage: linkage.clone(),
                wheel: wheel.unwrap_or_default(),
                arguments: arguments.collect(),
                unit: unit.symbol(),
                axes: self.mechanism.axes.meaning(),
                held: self.held(&along, inside),
            },
            baked,
        };
        if self.interrupted.load(Ordering::Relaxed) {
            return Err(interrupted(self.file));
        }
        Ok(sheet)
    }

    /// Refuses a tolerance that is not positive, and the wheel of a listing without one.
    fn check(&self) -> Result<(), Failure> {
        if !(self.request.tolerance > 0.0 && self.request.tolerance.is_finite()) {
            return Err(self.refuse("a tolerance is a positive number of metres"));
        }
        if self.request.wish == Wish::Wheel && self.mechanism.names.wheels.is_empty() {
            return Err(
                self.refuse("the linkage has no wheel to bake; --points all bakes its points")
            );
        }
        Ok(())
    }

    /// Lists the drives that nothing moves with the values at which they are held, in a unit.
    fn held(&self, along: &[Along], unit: Unit) -> String {
        let drives = self.mechanism.names.drives.iter().enumerate();
        let held = drives.filter(|(drive, _)| along.iter().all(|along| along.drive != *drive));
        let held = held.map(|(drive, Drive { name, kind })| {
            let value = exact(self.given(drive, self.first(drive)));
            format!("{name} = {value} {}", Dimension::from(*kind).symbol(unit))
        });
        held.collect::<Vec<_>>().join(", ")
    }

    /// Describes a drive or a measure and its range; `unit` is that of the baked functions.
    fn ranged(&self, along: &Along, unit: Unit) -> Ranged {
        let drive = &self.mechanism.names.drives[along.drive];
        Ranged {
            name: self.name(along).to_owned(),
            unit: self.dimension(along).symbol(unit),
            range: along.range,
            in_place_of: along.measure.map(|_| drive.name.clone()),
        }
    }

    /// Returns the ranges of the drives and the baked functions.
    fn by_drives(&self, drives: &[Wished]) -> Result<(Vec<Along>, Table), Failure> {
        let drives = drives.iter().map(|wished| self.along(wished));
        let drives = drives.collect::<Result<Vec<Along>, Failure>>()?;
        let baked = match drives.as_slice() {
            [along] => Table::Curve(self.curve(along)?),
            [first, second] if first.drive != second.drive => {
                Table::Surface(self.surface([first, second])?)
            }
            _ => return Err(self.refuse("--drive names one drive, or two different ones")),
        };
        Ok((drives, baked))
    }

    fn along(&self, wished: &Wished) -> Result<Along, Failure> {
        let drive = self.mechanism.names.chosen_drive(wished.drive.as_deref());
        let drive = drive.map_err(|message| self.refuse(&message))?;
        let range = self.range(drive, wished)?;
        let offset = self.mechanism.drive_offsets[drive];
        let along = Along {
            drive,
            measure: None,
            range,
            local: range.map(|end| end - offset),
        };
        if let [Some(from), Some(to)] = wished.range {
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

    /// Returns a drive's range in the file's coordinates.
    fn range(&self, drive: usize, wished: &Wished) -> Result<[f64; 2], Failure> {
        let times = self.mechanism.instants.iter();
        let through = times.map(|t| self.given(drive, self.value(drive, t)));
        let [low, high] = ends(through).unwrap_or_default();
        let Description { names, unit, .. } = &**self.mechanism;
        let kind = names.drives[drive].kind;
        let inside = |end: f64| end / Dimension::from(kind).file_factor(*unit);
        let [from, to] = wished.range.map(|end| end.map(inside));
        let range = [from.unwrap_or(low), to.unwrap_or(high)];
        if low == high && wished.range == [None, None] {
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

    /// Converts a drive's local value to the file's coordinates.
    fn given(&self, drive: usize, local: f64) -> f64 {
        local + self.mechanism.drive_offsets[drive]
    }

    /// Returns a drive's local value at the first instant.
    fn first(&self, drive: usize) -> f64 {
        self.value(drive, self.mechanism.instants.ends()[0])
    }

    fn value(&self, drive: usize, t: f64) -> f64 {
        self.mechanism.drives_at(t)[drive]
    }

    fn range_in_words(&self, drive: usize, range: [f64; 2]) -> String {
        let Description { names, unit, .. } = &**self.mechanism;
        let ends = range.map(|end| names.drive_in_words(drive, end, *unit));
        ends.join(" to ")
    }

    fn name(&self, along: &Along) -> &str {
        let names = &self.mechanism.names;
        match along.measure {
            Some(measure) => &names.measures[measure].name,
            None => &names.drives[along.drive].name,
        }
    }

    fn dimension(&self, along: &Along) -> Dimension {
        let names = &self.mechanism.names;
        match along.measure {
            Some(measure) => names.measures[measure].kind.into(),
            None => names.drives[along.drive].kind.into(),
        }
    }

    /// Converts a local value to the file's coordinates and units.
    fn in_file(&self, along: &Along, local: f64) -> f64 {
        let offset = match along.measure {
            Some(measure) => self.mechanism.measure_offsets[measure],
            None => self.mechanism.drive_offsets[along.drive],
        };
        (local + offset) * self.dimension(along).file_factor(self.mechanism.unit)
    }

    /// Formats a local value with its unit.
    fn in_words(&self, along: &Along, local: f64) -> String {
        let (name, value) = (self.name(along), number(self.in_file(along, local)));
        let symbol = self.dimension(along).symbol(self.mechanism.unit);
        format!("{name} = {value} {symbol}")
    }

    /// Adds to a message why the solver gave up.
    fn cause(&self, cause: Option<SolveError<f64>>) -> String {
        let names = &self.mechanism.names;
        cause.map_or_else(String::new, |cause| format!(" ({})", names.cause(&cause)))
    }

    fn refuse(&self, message: &str) -> Failure {
        Failure::Input(format!("{}: {message}", self.file))
    }
}

/// Returns the failure of an interrupt before the file is complete.
fn interrupted(file: &str) -> Failure {
    Failure::Interrupted(format!("{file}: interrupted; nothing was written"))
}
