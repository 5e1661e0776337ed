//! `suspension assemblies`: all ways to assemble a mechanism.

mod report;
pub mod search;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::Description;
use crate::option_numbers::number;
use crate::output::destinations::table_targets;
use crate::output::file_table::Table;
use crate::output::files::{announce, print};
use crate::output::heading::Header;
use crate::output::notes::with_notes_printed;
use crate::prepare::load;
use search::{Listed, Request, list};

/// The arguments of `suspension assemblies`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// Values of the drive in the file's units: its own, as in [drives], not changes from the design. Without
    /// --at and --drive the value at the file's first instant.
    #[arg(
        long,
        value_name = "VALUE",
        num_args = 1..,
        allow_negative_numbers = true,
        value_parser = number("this is not a number; the motion file stands before --at, which takes all that follow it")
    )]
    at: Vec<f64>,
    /// The drive of --at; needed if the linkage has several. The other drives are held as at the file's first instant.
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
        let tables = table_targets([&self.csv, &None, &None]);
        let loaded = load(&source)?;
        tables.check()?;
        let request = Request {
            drive: self.drive,
            at: self.at,
        };
        let mechanism = &*with_notes_printed(loaded.at_first_instant()?);
        let Description { names, unit, .. } = &**mechanism;
        let columns = report::columns(names, *unit);
        let mut table = Table::create(&tables, &Header::new(mechanism), columns)?;
        let mut on_listed = |listed: &Listed| {
            if !tables.is_to_stdout() {
                print(&format!("{}\n", report::text(names, *unit, listed)))?;
            }
            let mut assemblies = listed.assemblies.iter();
            assemblies.try_for_each(|assembly| table.add(assembly))
        };
        let file = source.name();
        let done = list(mechanism, file, &request, interrupted, &mut on_listed);
        if let Ok(()) | Err(Failure::Interrupted(_) | Failure::Solver(_)) = done {
            table.finish()?;
            announce(tables.files().map(|(path, _)| path));
        }
        done
    }
}

const NOTES: &str = "\
An assembly is a way to put the parts together at the given value of the drive. The table gives two distances of each
assembly from the configuration at the file's first instant, over all coordinates of free points and for the point that is
farthest away. It is ordered by distance. A singular value of the Jacobian near zero, as in `suspension check`, means that
a singularity is near, where two assemblies meet. Mirrored points are on the wrong side of the points to which links join
them: such an assembly has all lengths but cannot be built. A `body` is never mirrored. The CSV file has one row for each
assembly, with every free point and marker.

How: the mechanism is divided into parts that can be put together one after the other, such as the rack, either corner, or
the rocker of a pushrod. Over complex numbers, all assemblies of a part with general dimensions (lengths and chassis points)
are connected. The search finds them from random starts and by going round loops of such dimensions, and follows them from
there to the dimensions of the file. The trace test confirms that none is missing: a general plane takes the place of a
coordinate that a drive or another part gives, and as it turns, a sum over all assemblies changes linearly. Some assemblies
with a plane go to infinity as the plane becomes that of the coordinate. A complex assembly cannot be built. The numbers
come from rounded arithmetic and are not a proof.

The search takes seconds, or minutes where a whole axle is one part: a steered beam axle has 1,104 assemblies with general
dimensions. On a terminal it shows how many it has found. An interrupt (Ctrl-C) ends the search; the assemblies found so far
are followed to the file's lengths and listed, and the list says that it may not be complete. Another interrupt stops that
too. The search of a part ends by itself after 20,000 paths; the list has at most 10,000 assemblies.

Exit codes: 0 done, 1 the table cannot be written, 2 wrong input or no such drive, 3 there is no assembly at a value, or
the file's first instant is out of reach, 130 interrupted (what was found is kept).

Example:
  suspension assemblies examples/five_link.toml --at 0.7 1.2 --csv assemblies.csv";
