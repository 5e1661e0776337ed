//! `suspension check`: a check of whether hardpoints make a working mechanism, and of its conditioning.

mod condition;
mod near_lock;
mod report;
mod zero_length;

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use suspension_runtime::Listing;

use crate::characteristics::parameters;
use crate::failure::Failure;
use crate::file::Source;
use crate::kinematics::Kinematics;
use crate::mechanism::Description;
use crate::output::files::print;
use crate::output::progress::Busy;
use crate::output::progress::search::Search;
use crate::output::pulling;
use crate::prepare::load;
use crate::reach::DriveRange;
use condition::Condition;
use report::Report;

/// The arguments of `suspension check`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// Also count the assemblies at the design position, after everything else. This takes seconds, or minutes for a
    /// steered beam axle.
    #[arg(long)]
    assemblies: bool,
}

impl Arguments {
    /// Checks the mechanism at its design position.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. The report of a singular design is printed.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let loaded = load(&source)?;
        let (name, mechanism) = (source.name(), &*loaded.at_design()?);
        loaded.check_analyses(mechanism)?;
        let condition = Condition::analyse(mechanism);
        let is_singular = condition.is_singular();
        let (ranges, motion_ends) = if is_singular {
            (Ok(Vec::new()), None)
        } else {
            let _shown = Busy::new("following each drive to its locks");
            let ranges = ranges(mechanism, interrupted)?;
            (ranges, loaded.own_motion_ends(interrupted)?)
        };
        let is_interrupted = interrupted.load(Ordering::Relaxed);
        let notes = notes(
            (name, mechanism, loaded.listing()),
            ranges.as_deref().unwrap_or_default(),
        );
        let is_known = !is_singular && !is_interrupted;
        let report = Report {
            file: name,
            mechanism,
            condition,
            ranges,
            motion: is_known.then(|| in_words(motion_ends.as_deref())),
            notes: &notes,
        };
        print(&report.text())?;
        if self.assemblies {
            count_assemblies(&report, mechanism, interrupted)?;
        }
        ended(&report, motion_ends.as_deref(), interrupted)
    }
}

/// Returns why the check does not end well, if it does not.
fn ended(
    report: &Report<'_>,
    motion_ends: Option<&str>,
    interrupted: &AtomicBool,
) -> Result<(), Failure> {
    let name = report.file;
    if interrupted.load(Ordering::Relaxed) {
        return Err(Failure::Interrupted(format!(
            "{name}: interrupted; what is not in the report was not looked at"
        )));
    }
    if report.condition.is_singular() {
        return Err(singular(name, report.mechanism));
    }
    let why = match (&report.ranges, motion_ends) {
        (Err(_), _) => "the reach of the drives is not known",
        (Ok(_), Some(_)) => "the file's own motion is out of reach",
        (Ok(_), None) => return Ok(()),
    };
    Err(Failure::Solver(format!(
        "{name}: {why}; the report says why"
    )))
}

/// Returns the notes on the file, those that other commands print too before those of this one.
fn notes(
    (file, mechanism, listing): (&str, &dyn Kinematics, &Listing),
    ranges: &[DriveRange],
) -> Vec<String> {
    let of_design = parameters(mechanism, mechanism.unit);
    let own = near_lock::notes(mechanism, ranges)
        .chain(pulling::notes(&of_design))
        .chain(zero_length::notes(mechanism, listing));
    let own = own.map(|note| format!("{file}: {note}"));
    mechanism.notes.iter().cloned().chain(own).collect()
}

/// Returns the range of each drive, or why the solver does not find one.
fn ranges(
    mechanism: &dyn Kinematics,
    interrupted: &AtomicBool,
) -> Result<Result<Vec<DriveRange>, String>, Failure> {
    let drives = 0..mechanism.names.drives.len();
    let ranges = drives.map(|drive| mechanism.range(drive, interrupted));
    match ranges.collect() {
        Ok(ranges) => Ok(Ok(ranges)),
        Err(Failure::Solver(why)) => Ok(Err(why)),
        Err(failure) => Err(failure),
    }
}

/// Says whether the file's own motion is within reach, or why it ends.
fn in_words(ends: Option<&str>) -> String {
    match ends {
        None => "the file's own is within reach, from its first instant to its last".to_owned(),
        Some(why) => format!("the file's own is OUT OF REACH: {why}"),
    }
}

fn singular(name: &str, mechanism: &Description) -> Failure {
    let why = mechanism.end_of_angle(&mechanism.design);
    let remedy = "move a point of the equations that depend on each other, or replace one of their statements by \
                  one that holds the unknowns that are not determined";
    let why = why.unwrap_or_else(|| remedy.to_owned());
    Failure::Solver(format!(
        "{name}: the design position is singular: drives do not determine the motion there; {why}"
    ))
}

/// Adds the number of assemblies to the report.
fn count_assemblies(
    report: &Report<'_>,
    mechanism: &dyn Kinematics,
    interrupted: &AtomicBool,
) -> Result<(), Failure> {
    if interrupted.load(Ordering::Relaxed) {
        return Ok(());
    }
    let progress = Search::new(report.file, interrupted);
    let watch = |stage, count| progress.goes_on(stage, count);
    let mut search = mechanism.assemblies(&watch);
    if let Some((_, tally)) = search.at(&mechanism.first_drives()) {
        progress.clear();
        print(&report.assemblies(&tally))?;
    }
    progress.ended()
}

const NOTES: &str = "\
Prints a report on the design position, which is that of the file's points:

  points, equations, freedom  what the listing states; each drive controls one degree of freedom
  residual                    how far the equations are off where the design assembles
  rank                        of the Jacobian; the report names equations that depend on each other (one of them is redundant)
                              and unknowns that no equation determines
  conditioning                the singular values of the Jacobian; a value near zero means that the design is near a singularity.
                              Equations and unknowns are lengths, so these values have no unit and need no scaling
  elimination                 the smallest pivot in the order that real-time steps keep, and the pivot growth: how much elimination
                              may magnify rounding errors there; 1000 or less is good
  reach                       for each drive, from the design position with the other drives held: the nearest lock to either side
                              and, where it is known, the link that is in the way, or the body on its hinge or joint.
                              suspension range starts from the first instant and follows the whole curve
  motion                      whether the file's own motion is within reach from its first instant to its last
  notes                       statements of the file that its author may not have meant, locks very near the design, springs that
                              pull a wheel up there, and measured lengths that are zero there
  assemblies                  with --assemblies: how many ways there are to put the parts together

Mistakes anywhere in the file are wrong input, also those under [loads], [tolerances] and [tune], which other commands read.

Exit codes: 0 the design is healthy, 1 the report cannot be written, 2 wrong input, 3 the design does not assemble or is
singular, or the file's own motion is out of reach, 130 interrupted.

Example:
  suspension check examples/double_wishbone_pushrod.toml";
