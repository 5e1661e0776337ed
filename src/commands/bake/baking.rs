//! What the command line asks for, carried out on a mechanism.

mod curve;
mod drive;
mod measure;
mod surface;
mod variable;

use std::sync::atomic::{AtomicBool, Ordering};

use suspension_core::SolveError;

use crate::bake::source::{About, BakedFile, Table};
use crate::bake::{Continuity, RequestedPoints};
use crate::failure::Failure;
use crate::file::Dimension;
use crate::kinematics::Kinematics;
use crate::mechanism::{Angle, Description, Drive, Unit};
use crate::number::exact;

use variable::Variable;

pub use drive::RequestedDrive;
pub use measure::RequestedMeasure;

/// Digits of a range that is proposed, rounded to lie within the possible one.
const DIGITS: usize = 12;

/// The variables on which the baked functions depend.
#[derive(Clone, Debug, PartialEq)]
pub enum Variables {
    /// One drive for a curve, two for a surface.
    Drives(Vec<RequestedDrive>),
    /// A measure in place of a drive, for a curve.
    Measure(RequestedMeasure),
}

impl Variables {
    /// The names of the drives that move, also in place of which a measure leads; `None` where there is only one.
    pub fn drives(&self) -> Vec<Option<&str>> {
        match self {
            Self::Drives(drives) => drives
                .iter()
                .map(|requested| requested.drive.as_deref())
                .collect(),
            Self::Measure(requested) => vec![requested.drive.as_deref()],
        }
    }
}

/// What to bake of the mechanism of a file.
pub struct Baking<'a> {
    /// The file's name.
    pub file: &'a str,
    /// The mechanism.
    pub mechanism: &'a dyn Kinematics,
    /// The variables on which the baked functions depend.
    pub variables: Variables,
    /// The largest error of a point, m.
    pub tolerance: f64,
    /// How many derivatives are continuous where segments join.
    pub continuity: Continuity,
    /// The points to bake.
    pub points: RequestedPoints,
    /// Set when the user interrupts the program.
    pub interrupted: &'a AtomicBool,
}

impl Baking<'_> {
    /// Bakes the ordered motion.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if drives, ranges or tolerance are wrong, [`Failure::Solver`] if the mechanism does not pass
    /// through the ranges or the tolerance is not met.
    pub fn execute(&self) -> Result<BakedFile, Failure> {
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
        let variables = match &self.variables {
            Variables::Drives(drives) => drives
                .iter()
                .map(|requested| self.along_drive(requested))
                .collect::<Result<Vec<_>, _>>()?,
            Variables::Measure(requested) => vec![self.along_measure(requested)?],
        };
        let baked = self.table(&variables)?;
        let arguments = variables.iter();
        let arguments = arguments.map(|variable| self.ranged(variable, inside));
        let wheel = match self.points {
            RequestedPoints::Wheel(number) => names.wheels.get(number),
            RequestedPoints::AllPoints => None,
        };
        let wheel = wheel.map(|wheel| wheel.title("wheel"));
        let file = BakedFile {
            about: About {
                file: self.file.to_owned(),
                linkage: linkage.clone(),
                wheel: wheel.unwrap_or_default(),
                arguments: arguments.collect(),
                unit: unit.length,
                axes: self.mechanism.axes.meaning(),
                held: self.held(&variables, inside),
            },
            baked,
        };
        if self.interrupted.load(Ordering::Relaxed) {
            return Err(Failure::nothing_written(self.file));
        }
        Ok(file)
    }

    /// Refuses a tolerance that is not positive, and the wheel of a listing without one.
    fn check(&self) -> Result<(), Failure> {
        let tolerance = self.tolerance;
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            let message =
                format!("--tolerance {tolerance} is not a positive number of metres, as 1e-6");
            return Err(self.refuse(&message));
        }
        if self.points != RequestedPoints::AllPoints && self.mechanism.names.wheels.is_empty() {
            return Err(
                self.refuse("the linkage has no wheel to bake; --points all bakes its points")
            );
        }
        Ok(())
    }

    /// Lists the drives that nothing moves with the values at which they are held, in a unit.
    fn held(&self, variables: &[Variable], unit: Unit) -> String {
        let drives = self.mechanism.names.drives.iter().enumerate();
        let held = drives.filter(|(drive, _)| variables.iter().all(|one| one.drive != *drive));
        let held = held.map(|(drive, _)| self.at_first_instant(drive, unit));
        held.collect::<Vec<_>>().join(", ")
    }

    /// A drive with its value at the first instant, in a unit.
    fn at_first_instant(&self, drive: usize, unit: Unit) -> String {
        let Drive { name, kind } = &self.mechanism.names.drives[drive];
        let value = exact(self.given(drive, self.first(drive)));
        format!("{name} = {value} {}", Dimension::from(*kind).symbol(unit))
    }

    fn table(&self, variables: &[Variable]) -> Result<Table, Failure> {
        match variables {
            [one] => Ok(Table::Curve(self.curve(one)?)),
            [first, second] if first.drive != second.drive => {
                Ok(Table::Surface(self.surface([first, second])?))
            }
            _ => Err(self.refuse("--drive names one drive, or two different ones")),
        }
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

    /// Adds to a message why the solver gave up.
    fn cause(&self, cause: Option<SolveError<f64>>) -> String {
        let names = &self.mechanism.names;
        cause.map_or_else(String::new, |cause| format!(" ({})", names.cause(&cause)))
    }

    fn refuse(&self, message: &str) -> Failure {
        Failure::input(self.file, message)
    }
}
