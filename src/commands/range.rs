//! `suspension range`: the range of each drive, and the curve beyond it.

mod plot;
mod report;

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;

use crate::characteristics::columns_of_positions;
use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::{Description, Names, report_of_singular};
use crate::output::destinations::table_targets;
use crate::output::file_table::{Column, Table};
use crate::output::files::{announce, print};
use crate::output::heading::Header;
use crate::output::notes::with_notes_printed;
use crate::output::progress::Busy;
use crate::output::rows::TableTargets;
use crate::output::svg_folder::SvgFolder;
use crate::prepare::load;
use crate::quantities::{self, DRIVES};
use crate::reach::{DriveRange, Station};

/// The arguments of `suspension range`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// The drive whose range to find; give the option several times for several drives. Without it all drives.
    #[arg(long = "drive", value_name = "NAME")]
    drives: Vec<String>,
    /// Write every place of the curves as comma-separated values to PATH, or to standard output
    /// for `-`.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
    /// Draw wheel-centre height over each drive's whole curve as SVG into the folder DIR; where the height is the drive
    /// itself, or stays, the toe angle or the camber angle.
    #[arg(long, value_name = "DIR")]
    plots: Option<PathBuf>,
}

impl Arguments {
    /// Finds the range of each drive, the others held as at the first instant.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. If the user interrupts, the files hold the curves found so far.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let tables = table_targets([&self.csv, &None, &None]);
        let loaded = load(&source)?;
        tables.check()?;
        let mechanism = &*with_notes_printed(loaded.within_reach()?);
        let chosen = self.chosen(&mechanism.names);
        let chosen = chosen.map_err(|message| Failure::input(source.name(), message))?;
        let plots = self.plots.as_deref();
        let plots = plots.map(|folder| SvgFolder::new(folder, &self.file));
        let name = |drive: &str| format!("range_{drive}");
        if let Some(folder) = &plots {
            let drives = chosen.iter().map(|drive| &mechanism.names.drives[*drive]);
            let names: Vec<String> = drives.map(|drive| name(&drive.name)).collect();
            folder.refuse_tables(&tables, names.iter().map(String::as_str))?;
        }
        let ranges = {
            let _shown = Busy::new("following the curve of each drive");
            let drives = chosen.iter();
            let ranges = drives.map(|drive| mechanism.range(*drive, interrupted));
            ranges.collect::<Result<Vec<_>, _>>()
        };
        let ranges = ranges.map_err(|failure| no_start(mechanism, source.name(), failure))?;
        table(mechanism, &ranges, &tables)?;
        let mut written: Vec<PathBuf> = tables.files().map(|(path, _)| path.clone()).collect();
        if let Some(folder) = &plots {
            let charts = ranges.iter();
            let charts = charts
                .filter_map(|range| Some((name(&range.name), plot::chart(mechanism, range)?)));
            written.extend(folder.draw(charts)?);
        }
        if !tables.is_to_stdout() {
            print(&report::text(mechanism, &ranges))?;
        }
        announce(&written);
        if interrupted.load(Ordering::Relaxed) {
            let message = format!("{}: interrupted; the curves are cut short", source.name());
            return Err(Failure::Interrupted(message));
        }
        Ok(())
    }

    /// Returns the chosen drives by number, each once and in the order of the listing.
    fn chosen(&self, names: &Names) -> Result<Vec<usize>, String> {
        if self.drives.is_empty() {
            return Ok((0..names.drives.len()).collect());
        }
        let named = self.drives.iter();
        let named = named.map(|name| names.chosen_drive(Some(name)));
        let chosen = named.collect::<Result<BTreeSet<usize>, _>>()?;
        Ok(chosen.into_iter().collect())
    }
}

/// Returns the failure of curves that do not start, with the remedy.
fn no_start(mechanism: &Description, file: &str, failure: Failure) -> Failure {
    let Failure::Solver(why) = failure else {
        return failure;
    };
    let first = mechanism.drives_in_file(mechanism.first_drives());
    // At the end of an angle the curves of other drives cannot start.
    if let Some(end) = mechanism.end_of_angle(&first) {
        return Failure::Solver(format!(
            "{file}: the curves cannot start at the end of an angle: {end}"
        ));
    }
    let remedy = if first == mechanism.design {
        report_of_singular(file)
    } else {
        "write another first instant under [drives]".to_owned()
    };
    Failure::Solver(format!("{file}: {why}; {remedy}"))
}

fn table(
    mechanism: &Description,
    ranges: &[DriveRange],
    tables: &TableTargets,
) -> Result<(), Failure> {
    let mut table = Table::create(tables, &Header::new(mechanism), columns(mechanism))?;
    let mut stations = ranges.iter().flat_map(|range| &range.curve);
    stations.try_for_each(|station| table.add(station))?;
    table.finish()
}

/// Returns the columns: the drives, and all quantities of the catalogue that positions determine.
fn columns(mechanism: &Description) -> Vec<Column<Station>> {
    let unit = mechanism.unit;
    let of_state = |column| Column::of_state(column, unit, |station: &Station| &station.state);
    let (drives, others): (Vec<quantities::Column>, Vec<_>) =
        columns_of_positions(mechanism).partition(|column| column.is(&DRIVES));
    let mut columns = vec![
        Column::new("freed", |station: &Station| station.freed as f64 + 1.0),
        Column::new("turns", |station| f64::from(u8::from(station.turns))),
    ];
    columns.extend(drives.into_iter().map(of_state));
    let speed = format!("speed_{}", unit.symbol());
    columns.push(Column::new(speed, |station| station.speed));
    columns.extend(others.into_iter().map(of_state));
    columns
}

const NOTES: &str = "\
Sets each drive free in turn, the others held as at the file's first instant. Then it follows the mechanism through the
turning points of the drive, which the drive itself cannot pass, until its curve closes or another curve crosses it. With
--drive it does so for the named drives alone. It prints for each drive:

  lower end, upper end   the values between which the drive leads the mechanism from the first instant,
                         and what ends them: a turning point, where the mechanism locks and
                         velocities grow without bound, with the link that is too long or too short to go
                         on, or else the body that reaches no further on its hinge or joint;
                         0 or pi, where an angle itself ends; a length of zero, where its points meet; a
                         bifurcation, where the mechanism can go either way
  motion                 when the file's motion reaches an end, if it moves no other drive
  poor                   where the transmission is poor: per unit of the drive the free points
                         move (root of the sum of squares) more than five times as far as where they
                         move least in the range
  curve                  whether it is closed, and how often the drive turns on it

The table has one row for each place, in order along the curve:

  freed              the number of the drive that is free, from 1
  turns              1 where this drive turns, else 0
  each drive         in the file's units
  speed_UNIT         how far the free points move per unit of the drive, per radian for an angle; inf where the drive
                     turns, except at the end of an angle
  points             _x _y _z, in the unit
  other quantities   all that positions determine, such as kingpin, caster, camber and toe, as in the table of sweep;
                     last the residual in the unit

If the first instant is out of reach, the ranges start from the design position, and a note says so.

Exit codes: 0 done, even if the file's own motion is out of reach (check and motion then return 3), because the ranges
are known; 1 a result cannot be written; 2 wrong input; 3 the mechanism does not assemble, or starts at a bifurcation
or where another drive is at the end of its angle; 130 interrupted (what was found is kept).

Example:
  suspension range examples/five_link.toml --csv curve.csv --plots plots
  suspension range examples/steered_axle.toml --drive steer";
