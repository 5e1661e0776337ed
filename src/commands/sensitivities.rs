//! `suspension sensitivities`: the effect of moving each hardpoint on the quantities of a design.

mod report;
mod scatter;

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;

use crate::failure::Failure;
use crate::file::Source;
use crate::kinematics::Kinematics;
use crate::mechanism::report_of_singular;
use crate::option_numbers::whole_number;
use crate::output::destinations::table_targets;
use crate::output::files::{announce, print};
use crate::output::notes::{print_notes, with_notes_printed};
use crate::output::progress::Progress;
use crate::prepare::{Loaded, load};
use crate::sensitivities::{Sensitivities, sensitivities};
use crate::tolerances::{Tolerance, first_order, sampled};
use report::Report;
use scatter::Scatter;

/// The arguments of `suspension sensitivities`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// Print the quantities whose names begin with NAME, such as camber or toe; give the option several times for several.
    /// Without it all.
    #[arg(long = "of", value_name = "NAME")]
    of: Vec<String>,
    /// How many hardpoint coordinates and lengths to print for each quantity, those with the largest effect first.
    #[arg(
        long,
        value_name = "COUNT",
        default_value = "5",
        allow_negative_numbers = true,
        value_parser = whole_number::<usize>("COUNT", 1)
    )]
    largest: usize,
    /// How many suspensions to build with random changes, for a file with [tolerances]. Without it 1000.
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, value_parser = whole_number::<usize>("COUNT", 2))]
    samples: Option<usize>,
    /// The seed of the random changes, for a file with [tolerances]: the same number gives the same changes. Without it 1.
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true, value_parser = whole_number::<u64>("NUMBER", 0))]
    seed: Option<u64>,
    /// Write all numbers as comma-separated values to PATH, or to standard output for `-`: a row for each coordinate and length.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
}

impl Arguments {
    /// Computes the sensitivities, and prints or writes them.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(&self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let tables = table_targets([&self.csv, &None, &None]);
        let loaded = load(&source)?;
        tables.check()?;
        let mechanism = &*with_notes_printed(loaded.at_design()?);
        if !mechanism.is_determined() {
            return Err(Failure::Solver(format!(
                "{}: the design position is singular, where quantities have no derivatives; {}",
                source.name(),
                report_of_singular(source.name())
            )));
        }
        let changes = loaded.changes(mechanism)?;
        let tolerances = self.tolerances(&loaded, mechanism, source.name())?;
        let stopped = || Failure::nothing_written(source.name());
        let mut progress = Progress::new(changes.len(), "changes");
        let found = sensitivities(mechanism, &changes, interrupted, || progress.step());
        let found = found.ok_or_else(stopped)?;
        drop(progress);
        let mut report = Report {
            file: source.name(),
            mechanism,
            found: &found,
            scatter: None,
        };
        let known = report.check(&self.of);
        known.map_err(|message| Failure::input(source.name(), message))?;
        report.scatter = self.scatter(mechanism, &found, &tolerances, interrupted);
        if interrupted.load(Ordering::Relaxed) {
            return Err(stopped());
        }
        if !tables.is_to_stdout() {
            print(&report.text(&self.of, self.largest))?;
        }
        report.write(&tables)?;
        announce(tables.files().map(|(path, _)| path));
        Ok(())
    }

    /// Returns the tolerances of the file, and prints a note on a doubtful one.
    fn tolerances(
        &self,
        loaded: &Loaded<'_>,
        mechanism: &dyn Kinematics,
        file: &str,
    ) -> Result<Vec<Tolerance>, Failure> {
        let tolerances = loaded.tolerances(mechanism)?;
        if tolerances.is_empty() && (self.samples.is_some() || self.seed.is_some()) {
            let message =
                "--samples and --seed need [tolerances] for the random changes; the file has none";
            return Err(Failure::input(file, message));
        }
        print_notes(loaded.doubtful_tolerance());
        Ok(tolerances)
    }

    /// Computes the scatter of quantities if the file has tolerances.
    fn scatter(
        &self,
        mechanism: &dyn Kinematics,
        found: &Sensitivities,
        tolerances: &[Tolerance],
        interrupted: &AtomicBool,
    ) -> Option<Scatter> {
        if tolerances.is_empty() {
            return None;
        }
        let drawn = (self.samples.unwrap_or(SAMPLES), self.seed.unwrap_or(SEED));
        let mut progress = Progress::new(drawn.0, "samples");
        Some(Scatter {
            first_order: first_order(found, tolerances),
            sampled: sampled(mechanism, tolerances, drawn, interrupted, || {
                progress.step()
            }),
            drawn,
        })
    }
}

const SAMPLES: usize = 1000;
const SEED: u64 = 1;

const NOTES: &str = "\
For each quantity at the design position, and for its derivative with respect to each drive (bump steer is the derivative of
toe), this prints the hardpoint coordinates and link lengths that change it most, per mm (per inch in a file in inches).

Each hardpoint is moved alone, together with a marker that the file states as an offset from it. The suspension is built from
the points and read at its own design position, like a changed drawing. If a point lies on a line between two chassis
points, like a rack in its housing, moving it across the line moves the line and the other points on it too: rack_left.z is
the height of the rack. Points that do not satisfy the listing, such as one beside its plane, are changed from where they are
assembled. A link's length is changed with the chassis points and the drives held, as a turnbuckle does; markers stay where
they are in their bodies. A centre of mass moves with the point by which [masses] states it; one stated in coordinates does
not move. The numbers are exact derivatives except for rounding, also where an instant centre is far away; those of what
springs do, such as wheel_rate, spring_load and roll_rate, are sixth-order differences over thousandths of the
suspension's size.

If the file has [tolerances], the standard deviation of each quantity is printed too: to first order, and from --samples
suspensions built with normally distributed changes. A tolerance is the standard deviation of each coordinate of a point, or
of a link's length, in the unit of the file; all are independent of each other.

  [tolerances]
  tie_ball = 0.0005
  tie_rod = 0.0002

The moves of [tune], such as a turnbuckle, a shim or a rack's height, are changes under their own names.

The CSV file has a row for each coordinate and length, then one for each move; with tolerances also the rows
standard_deviation and standard_deviation_of_samples. It has a column for each number, per unit of length of the file, in
that unit and the file's unit of angles: camber_rad, camber_rad_per_bump.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 the design does not assemble, 130 interrupted.

Example:
  suspension sensitivities examples/double_wishbone_pushrod.toml --of toe --of camber";
