//! `suspension assemblies`.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::assemblies::{self, Wish};
use crate::failure::Failure;
use crate::input::setup;
use crate::input::source::Source;
use crate::output::csv_file::{CsvFile, Target};
use crate::output::files::{print, refuse_input};

/// The command's arguments.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// The motion file (TOML), as for `suspension motion`.
    file: PathBuf,
    /// The drive's values, in rad (angles) or the file's unit; else that of the file's first
    /// instant.
    #[arg(long, value_name = "VALUE", num_args = 1.., allow_negative_numbers = true)]
    at: Vec<f64>,
    /// The drive; needed with --at where the linkage has several. The others are held as at the
    /// file's first instant.
    #[arg(long, value_name = "NAME")]
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
        let target = self.csv.map(super::target);
        if let Some(Target::File(csv)) = &target {
            refuse_input(csv, &self.file, "--csv")?;
        }
        let (study, _) = setup::load(&source)?;
        let wish = Wish {
            drive: self.drive,
            at: self.at,
        };
        let columns = assemblies::columns(&*study);
        let table = target.as_ref().map(|csv| CsvFile::create(csv, &columns));
        let mut table = table.transpose()?;
        let done = study.assemblies(source.name(), &wish, interrupted, &mut |listed| {
            if target != Some(Target::Stdout) {
                print(&format!("{}\n", assemblies::text(listed, study.unit())))?;
            }
            let Some(table) = &mut table else {
                return Ok(());
            };
            assemblies::rows(listed).try_for_each(|row| table.row(&row))
        });
        if matches!(done, Ok(()) | Err(Failure::Interrupted(_)))
            && let Some(table) = table
        {
            table.finish()?;
            if let Some(Target::File(path)) = &target {
                crate::job::announce(std::slice::from_ref(path));
            }
        }
        done
    }
}

pub(super) const NOTES: &str = "\
An assembly is a way to put the parts together at the given value of the drive. Distances are from
the configuration of the file's first instant: over all coordinates of free points, and of the
point that lies farthest away. A pivot near zero is a singularity near by, where two assemblies meet.
Mirrored are points on the wrong side of those that links join them to: such an assembly has all
lengths but cannot be built. A `body` is never mirrored.

The list is ordered by distance; one row each in the CSV file, with every free point and marker.

How: over complex numbers all assemblies of a mechanism of general lengths hang together. They are
found from random starts and by going round loops of such mechanisms, and followed from there to
the file's. The trace test confirms that none is missing: their sum is linear in the drive. A
complex assembly cannot be built. The numbers are those of rounded arithmetic, not a proof.

Exit codes: 0 done, 1 the table cannot be written, 2 wrong input or no such drive, 3 the file's
mechanism has no configuration at its first instant, 130 interrupted: what was found is kept.

Example:
  suspension assemblies examples/five_link.toml --at 0.7 1.2 --csv assemblies.csv";
