//! The end of a motion that its drives lead: the drive that turns there, and the link or hinge that limits it.

mod at_drives;
mod blocking_link;
pub(super) mod end_of_angle;
mod turning_drive;

use nalgebra::SVector;
use suspension_core::SolveError;
use suspension_core::listing::DriveKind;
use suspension_core::step::stepper::Stopped;

use crate::file::{Dimension, Unit};
use crate::mechanism::lock::blocking_link::{BlockingLink, find_hinge_at_lock};
use crate::mechanism::lock::end_of_angle::EndOfAngle;
use crate::mechanism::lock::turning_drive::{is_near, turning_drive};
use crate::mechanism::motion::drive_laws::DriveLaws;
use crate::mechanism::parts::driven_length::DrivenLength;
use crate::mechanism::parts::hinge::Hinge;
use crate::mechanism::parts::names::Names;
use crate::mechanism::parts::words::advice;
use crate::mechanism::suspension::Suspension;
use crate::number::rounded;

/// The end of a motion that drives lead.
#[derive(Clone, Debug, PartialEq)]
pub struct Lock {
    /// The drives there, in the file's coordinates.
    pub drives: Vec<f64>,
    /// The number of the drive that turns there, if one does: led by it, the mechanism locks.
    pub turns: Option<usize>,
    blocking: Option<BlockingLink>,
    /// The hinge with the greatest share in the lock, if no link's length is the cause.
    hinge: Option<Hinge>,
    /// The driven angle that is at the end of its range, if any.
    end_of_angle: Option<EndOfAngle>,
    /// The driven length that is zero, if any.
    at_zero: Option<DrivenLength>,
    cause: Option<SolveError<f64>>,
}

impl Lock {
    /// The lock at which a motion stopped on the way to the time `asked`, with `q` its last configuration. `given`
    /// contains the drives in the file's coordinates.
    pub(crate) fn new<L: Suspension<N>, const N: usize>(
        model: &L,
        names: &Names,
        laws: &DriveLaws,
        stopped: &Stopped<f64>,
        asked: f64,
        q: &SVector<f64, N>,
        given: impl Fn(&L::Drives) -> Vec<f64>,
    ) -> Self {
        let there = laws.inputs::<L::Drives>(stopped.reached);
        let cause = stopped.refused.map(|(_, cause)| cause);
        let drives = given(&there.drives.value);
        let end_of_angle = EndOfAngle::find(names, cause.as_ref(), &drives);
        let lengths = &names.driven_lengths;
        let at_zero = DrivenLength::at_zero(lengths, &drives, model.size()).cloned();
        let locks = end_of_angle.is_none() && at_zero.is_none();
        let reached = stopped.reached;
        let blocking = || BlockingLink::find(model, names, laws, [reached, asked], q);
        let blocking = locks.then(blocking).flatten();
        let hinge = || find_hinge_at_lock(model, names, laws, reached, q);
        let hinge = (locks && blocking.is_none()).then(hinge).flatten();
        Self {
            drives,
            turns: locks.then(|| turning_drive(model, &there, q)).flatten(),
            blocking,
            hinge: hinge.cloned(),
            end_of_angle,
            at_zero,
            cause,
        }
    }

    /// A description of what prevents going on by a little: the link and whether it is too long or too short, or
    /// otherwise the hinge.
    pub fn fault(&self) -> Option<String> {
        let blocking = self.blocking.as_ref().map(BlockingLink::fault);
        blocking.or_else(|| self.hinge.as_ref().map(Hinge::fault))
    }

    /// A description of the lock; `design` are the drives at the design position.
    pub fn in_words(&self, names: &Names, unit: Unit, design: &[f64]) -> String {
        if let Some(end) = &self.end_of_angle {
            return end.in_words(names, unit);
        }
        if let Some(length) = &self.at_zero {
            let drive = &names.drives[length.drive].name;
            return format!("the drive `{drive}` ends: {}", length.fault());
        }
        let drives = names.drives_in_words(&self.drives, unit, None);
        let end = match self.turns {
            _ if self.is_at(design) => {
                format!(
                    "the design position is singular: {}",
                    self.why_singular(names)
                )
            }
            Some(turns) => {
                let drive = &names.drives[turns];
                let change = self.drives[turns] - design[turns];
                let change = describe_change_from_design(change, drive.kind, unit);
                format!("the drive `{}` locks {change} ({drives})", drive.name)
            }
            None => {
                let cause = self
                    .cause
                    .map(|error| format!(" ({})", names.cause(&error)));
                format!(
                    "the mechanism goes no further than {drives}{}",
                    cause.unwrap_or_default()
                )
            }
        };
        let blocking = self
            .blocking
            .as_ref()
            .map(|blocking| blocking.in_words(unit));
        match blocking.or_else(|| self.fault()) {
            Some(fault) => format!("{end}; {fault}"),
            None => end,
        }
    }

    /// The remedy, made of the file's name; `design` are the drives at the design position.
    pub fn remedy(&self, design: &[f64]) -> fn(&str) -> String {
        if self.is_at(design) {
            report_of_singular
        } else {
            advice
        }
    }

    /// Whether the drives have these values.
    pub fn is_at(&self, drives: &[f64]) -> bool {
        let mut pairs = self.drives.iter().zip(drives);
        pairs.all(|(here, there)| is_near(*here, *there))
    }

    /// Why the design position is singular, if that is where it locks.
    fn why_singular(&self, names: &Names) -> String {
        match self.turns {
            Some(turns) => format!("the drive `{}` locks there", names.drives[turns].name),
            None => "the drives do not determine the motion there".to_owned(),
        }
    }
}

/// The remedy for the singular design position of a file.
pub fn report_of_singular(file: &str) -> String {
    format!(
        "`suspension check {file}` names the equations that depend on each other there and the unknowns that are free"
    )
}

/// A description of a drive's change from the design position, such as `at +0.0712 m from the design`.
pub fn describe_change_from_design(change: f64, kind: DriveKind, unit: Unit) -> String {
    const DIGITS: usize = 4;
    let dimension = Dimension::from(kind);
    let size = rounded((change * unit.file_factor(dimension)).abs(), DIGITS);
    let sign = if change < 0.0 { "-" } else { "+" };
    format!("at {sign}{size} {} from the design", dimension.symbol(unit))
}
