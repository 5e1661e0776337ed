//! `suspension check`: whether hardpoints make a mechanism that works, and how well.

mod condition;
mod report;

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;

use crate::assemblies::{Assemblies, Tally};
use crate::failure::Failure;
use crate::file::Source;
use crate::load::load;
use crate::mechanism::{Mechanism, Suspension, Work};
use crate::output::files::print;
use crate::reach::{DriveRange, range};
use condition::Condition;
use report::Report;

/// What `suspension check` is given.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// Count the assemblies at the design position too: seconds to minutes.
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
        load(&source)?.run_at_design(Check {
            source: source.name(),
            counts_assemblies: self.assemblies,
            interrupted,
        })
    }
}

struct Check<'a> {
    source: &'a str,
    counts_assemblies: bool,
    interrupted: &'a AtomicBool,
}

impl Work for Check<'_> {
    type Answer = ();

    const TELLS_NOTES: bool = true;

    fn on<L: Suspension<N>, const N: usize>(
        self,
        mechanism: &Mechanism<L, N>,
    ) -> Result<(), Failure> {
        let condition = Condition::of(mechanism);
        let is_singular = condition.is_singular();
        let ranges = if is_singular {
            Vec::new()
        } else {
            self.ranges(mechanism)?
        };
        let report = Report {
            file: self.source,
            linkage: &mechanism.linkage,
            names: &mechanism.names,
            unit: mechanism.unit,
            design: &mechanism.design,
            condition,
            ranges,
            tally: self.counts_assemblies.then(|| tally(mechanism)),
            notes: &mechanism.notes,
        };
        print(&report.text())?;
        let name = self.source;
        if self.interrupted.load(Ordering::Relaxed) {
            return Err(Failure::Interrupted(format!(
                "{name}: interrupted; the search for locks is cut short"
            )));
        }
        if is_singular {
            return Err(Failure::Solver(format!(
                "{name}: the design position is singular: drives do not determine the motion there"
            )));
        }
        Ok(())
    }
}

impl Check<'_> {
    fn ranges<L: Suspension<N>, const N: usize>(
        &self,
        mechanism: &Mechanism<L, N>,
    ) -> Result<Vec<DriveRange>, Failure> {
        let drives = 0..mechanism.names.drives.len();
        let ranges = drives.map(|drive| range(mechanism, drive, self.interrupted));
        ranges.collect()
    }
}

fn tally<L: Suspension<N>, const N: usize>(mechanism: &Mechanism<L, N>) -> Tally {
    let [first, _] = mechanism.instants.ends();
    let inputs = mechanism.drives.inputs(first);
    let position = &mechanism.start.position;
    Assemblies::new(&mechanism.model, position, &inputs)
        .at(&inputs)
        .tally
}

const NOTES: &str = "\
Reads a file as the other commands do and prints of its design position, that of the file's points:

  points, equations, freedom  what the listing states; each drive leads one degree of freedom
  residual                    by how much the equations are off where the design assembles
  rank                        of the Jacobian: equations that depend on each other are named, one of them is redundant,
                              and unknowns that no equation determines
  conditioning                the singular values of the Jacobian: near zero the design is near a singularity. Equations and
                              unknowns are lengths, so that they have no unit and need no scaling
  elimination                 the smallest pivot in the order that real-time steps keep, and how rounding grows there
  each drive                  the nearest lock to either side; suspension range has the whole curve
  assemblies                  with --assemblies: how many ways there are to put the parts together
  notes                       what the file says that its author may not have meant

Exit codes: 0 the design is healthy, 1 the report cannot be written, 2 wrong input, 3 the design does not assemble or is
singular, 130 interrupted.

Example:
  suspension check examples/double_wishbone.toml";
