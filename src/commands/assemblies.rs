//! `suspension assemblies`: all ways to assemble a mechanism.

pub mod listed;
mod report;
pub mod watched;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::failure::Failure;
use crate::file::Source;
use crate::kinematics::Kinematics;
use crate::load::load;
use crate::mechanism::Description;
use crate::option::number;
use crate::output::files::{announce, print};
use crate::output::table::Table;
use crate::output::target::Target;
use listed::{Wish, list};
use report::Report;

/// What `suspension assemblies` is given.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), as for `suspension motion`.
    file: PathBuf,
    /// The drive's own values, as the file's [drives] have them, not changes from the design, in the file's units.
    /// Without it that of the file's first instant.
    #[arg(
        long,
        value_name = "VALUE",
        num_args = 1..,
        allow_negative_numbers = true,
        value_parser = number("this is not a number; the motion file stands before --at, which takes all that follow it")
    )]
    at: Vec<f64>,
    /// The drive; needed with --at where the linkage has several. The others are held as at the
    /// file's first instant.
    #[arg(long, value_name = "NAME", requires = "at")]
    drive: Option<String>,
    /// Write every assembly as comma-separated values to PATH, or to standard output for `-`.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
}

impl Arguments {
    /// Enumerates, and prints or writes the table.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let csv = self.csv.map(Target::from);
        let loaded = load(&source)?;
        if let Some(csv) = &csv {
            csv.refuse_input("--csv")?;
        }
        let wish = Wish {
            drive: self.drive,
            at: self.at,
        };
        let mechanism = loaded.at_first_instant()?;
        enumerate(&*mechanism, source.name(), &wish, csv.as_ref(), interrupted)
    }
}

/// Prints or writes the assemblies as they are found.
fn enumerate(
    mechanism: &dyn Kinematics,
    source: &str,
    wish: &Wish,
    csv: Option<&Target>,
    interrupted: &AtomicBool,
) -> Result<(), Failure> {
    let Description { names, unit, .. } = &**mechanism;
    let columns = || report::columns(names, *unit);
    let table = csv.map(|csv| Table::create(csv, columns()));
    let mut table = table.transpose()?;
    let report = Report::new(names, *unit);
    let done = list(mechanism, source, wish, interrupted, &mut |listed| {
        if csv != Some(&Target::Stdout) {
            print(&format!("{}\n", report.text(listed)))?;
        }
        let Some(table) = &mut table else {
            return Ok(());
        };
        let mut assemblies = listed.assemblies.iter();
        assemblies.try_for_each(|assembly| table.add(assembly))
    });
    if matches!(
        done,
        Ok(()) | Err(Failure::Interrupted(_) | Failure::Solver(_))
    ) && let Some(table) = table
    {
        table.finish()?;
        announce(csv.and_then(Target::path));
    }
    done
}

const NOTES: &str = "\
An assembly is a way to put the parts together at the given value of the drive. Distances are from
the configuration of the file's first instant: over all coordinates of free points, and of the
point that lies farthest away. A singular value of the Jacobian near zero, as `suspension check` has it, is a singularity near by,
where two assemblies meet.
Mirrored are points on the wrong side of those that links join them to: such an assembly has all
lengths but cannot be built. A `body` is never mirrored.

The list is ordered by distance; one row each in the CSV file, with every free point and marker.

How: the mechanism is put together part by part, as far as one part does not need the other: the rack, either corner, the rocker
of a pushrod. Over complex numbers all assemblies of a part of general dimensions, lengths and chassis points, hang together. They are
found from random starts and by going round loops of such parts, and followed from there to
the file's. The trace test confirms that none is missing: a general plane takes the place of a coordinate that a drive or another
part gives, and as it turns a sum over all assemblies changes linearly. Of those with a plane some go to infinity as it becomes
the coordinate's. A complex assembly cannot be built. The numbers are those of rounded arithmetic, not a proof.

It takes seconds, and minutes where a whole axle is one part, as a steered beam axle is: of 1,104 assemblies with general
dimensions. On a terminal it shows how many it has found. An interrupt (Ctrl-C) ends the search; what it has found is followed to
the file's lengths and listed, and the list says that it may not be complete. Another interrupt gives that up. The search of a
part ends by itself after 20,000 paths; the list has 10,000 assemblies at most.

Exit codes: 0 done, 1 the table cannot be written, 2 wrong input or no such drive, 3 there is no
assembly at a value, or the file's first instant is out of reach, 130 interrupted: what was found is kept.

Example:
  suspension assemblies examples/five_link.toml --at 0.7 1.2 --csv assemblies.csv";
