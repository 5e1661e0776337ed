//! `suspension motion`: the motion of a file.

mod help;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;
pub use help::text as help;

use crate::failure::Failure;
use crate::file::Source;
use crate::output::destinations::table_targets;
use crate::output::files::{announce, print};
use crate::output::motion::plots::{draw, height_and_angles};
use crate::output::motion::record::record;
use crate::output::motion::summary;
use crate::output::notes::with_notes_printed;
use crate::output::svg_folder::SvgFolder;
use crate::prepare::load;

/// The arguments of `suspension motion`.
#[derive(Args, Clone, Debug)]
pub struct Arguments {
    /// The motion file (TOML): linkage, points, lengths, instants and drives.
    file: PathBuf,
    /// Write every row as comma-separated values to PATH, or to standard output for `-`. Missing
    /// folders are created.
    #[arg(long, value_name = "PATH", help_heading = TABLES)]
    csv: Option<PathBuf>,
    /// Write JSON to PATH, or to standard output for `-`: a header with units and axes, and every row under the same
    /// names.
    #[arg(long, value_name = "PATH", help_heading = TABLES)]
    json: Option<PathBuf>,
    /// Write the rows as Parquet to PATH, or to standard output for `-`, with units and axes as metadata. The program must be
    /// built with the feature `parquet`.
    #[arg(long, value_name = "PATH", help_heading = TABLES)]
    parquet: Option<PathBuf>,
    /// Draw wheel-centre height, toe, camber, caster and kingpin angles, and the steer angles of a steered axle, over time as
    /// SVG into the folder DIR.
    #[arg(long, value_name = "DIR", help_heading = "Plots")]
    plots: Option<PathBuf>,
}

/// The heading of the options that write tables.
const TABLES: &str = "Tables";

/// States kept of a motion for the summary and as marks in the plots.
const KEPT: usize = 12;

impl Arguments {
    /// Solves the motion.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. If the solver stops or the user interrupts, the files hold what was solved.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let tables = table_targets([&self.csv, &self.json, &self.parquet]);
        let loaded = load(&source)?;
        tables.check()?;
        let mechanism = &*with_notes_printed(loaded.at_first_instant()?);
        let plots = self.plots.as_deref();
        let plots = plots.map(|folder| SvgFolder::new(folder, &self.file));
        if let Some(folder) = &plots {
            let charts = height_and_angles(mechanism, [&[], &[]]);
            folder.refuse_tables(&tables, charts.iter().map(|(name, _)| *name))?;
        }
        let outcome = record(mechanism, &mechanism.instants, &tables, KEPT, interrupted)?;
        let mut written: Vec<PathBuf> = tables.files().map(|(path, _)| path.clone()).collect();
        if let Some(folder) = &plots {
            written.extend(draw(mechanism, &outcome, folder, height_and_angles)?);
        }
        if tables.is_empty() && plots.is_none() {
            print(&summary::text(mechanism, &outcome))?;
        }
        announce(&written);
        let failure = outcome.failure(source.name(), &tables);
        failure.map_or(Ok(()), Err)
    }
}
