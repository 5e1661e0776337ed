//! `suspension sweep`: all quantities and their derivatives on a grid of the drives.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::characteristics::GridTable;
use crate::failure::Failure;
use crate::file::Source;
use crate::grid::{Swept, counted_from, grid};
use crate::mechanism::DerivativeOrder;
use crate::option_numbers::derivatives;
use crate::output::default_path::target;
use crate::output::destinations::table_targets;
use crate::output::files::announce;
use crate::output::heading::{Header, Heading};
use crate::output::notes::with_notes_printed;
use crate::output::progress::Progress;
use crate::output::rows::Rows;
use crate::prepare::load;

/// The arguments of `suspension sweep`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// A drive and COUNT values of it, evenly spaced from FROM to TO (both included), or one value. They are changes from
    /// the design position, in the file's units; the drive's column has its own values. Give the option several times
    /// for a grid. Drives joined by commas move together, with a minus the opposite way: bump_left,-bump_right is
    /// roll. Changes of a drive in several options add up, as those of heave and roll do.
    #[arg(
        long = "drive",
        value_name = "NAME=FROM:TO:COUNT",
        required = true,
        allow_hyphen_values = true
    )]
    drives: Vec<Swept>,
    /// Take the values as the drives' own, as in the file and the columns, not as changes.
    #[arg(long)]
    absolute: bool,
    /// Derivatives of each quantity with respect to each drive: none, the first, or the first and second.
    #[arg(long, value_name = "0|1|2", default_value_t = 1, allow_negative_numbers = true, value_parser = derivatives())]
    derivatives: u8,
    /// Write the rows as comma-separated values to PATH, or to standard output for `-`. Without --csv, --json and --parquet
    /// they go to out/NAME_sweep.csv, where NAME is the motion file's name.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
    /// Write JSON to PATH, or to standard output for `-`: a header with units and axes, and the rows under the same
    /// names.
    #[arg(long, value_name = "PATH")]
    json: Option<PathBuf>,
    /// Write the rows as Parquet to PATH, or to standard output for `-`, with units and axes as metadata. The program must be
    /// built with the feature `parquet`.
    #[arg(long, value_name = "PATH")]
    parquet: Option<PathBuf>,
}

impl Arguments {
    /// Solves the mechanism at each place of the grid.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. The table omits places that have no configuration, and places that are not solved before an
    /// interrupt.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let mut tables = table_targets([&self.csv, &self.json, &self.parquet]);
        if tables.is_empty() {
            tables.csv = Some(target(None, &self.file, "_sweep.csv"));
        }
        let loaded = load(&source)?;
        tables.check()?;
        let mechanism = &*with_notes_printed(loaded.at_design()?);
        let from = counted_from(self.absolute);
        let grid = grid(mechanism, source.name(), &self.drives, from)?;
        let table = GridTable::new(mechanism, self.derivatives.into());
        let mut progress = Progress::new(grid.places().unwrap_or_default(), "places");
        let order = match self.derivatives {
            2 => DerivativeOrder::Second,
            _ => DerivativeOrder::First,
        };
        let visited = mechanism.visit(&grid, order, interrupted, &mut |place| {
            progress.step();
            table.row(place)
        });
        // A table without rows would take the place of an earlier one that has some.
        if visited.places.iter().any(Option::is_some) {
            let headings = table.names(mechanism).into_iter();
            let headings: Vec<Heading> = headings.map(Heading::new).collect();
            let mut rows = Rows::create(&tables, &Header::new(mechanism), &headings)?;
            for row in visited.places.iter().flatten() {
                rows.add(row)?;
            }
            rows.finish()?;
            announce(tables.files().map(|(path, _)| path));
        }
        visited.failure(source.name()).map_or(Ok(()), Err)
    }
}

const NOTES: &str = "\
The table has one row for each place of the grid; the last drive given changes fastest. Its columns are the drives and all
quantities that positions determine, including those that need the [vehicle] table of the file (suspension motion --help
explains the quantities and the table). Columns of drives have the drives' own values, as [drives] of the file states them,
even where --drive states changes from the design position: bump=-0.08:0.08:161 of a wheel centre 0.30 m high gives 0.22 to
0.38.

Derivatives follow: camber_rad_per_bump is the derivative of camber with respect to the drive bump, the other drives held;
camber_rad_per_bump2 is the second derivative. They come from the equations, not from differences.

The mechanism is driven to each place from the design position, which is that of the file's points. Places beyond a lock
have no rows.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 some places have no configuration, 130 interrupted. With
3 and 130, what was solved is written; no file if that is nothing.

Example:
  suspension sweep examples/double_wishbone_pushrod.toml --drive bump=-0.08:0.08:161 --drive steer=-0.03:0.03:41 --csv -";
