//! `suspension loads`: the forces in a mechanism under the load cases of its file.

mod found;
mod report;
mod table;

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::failure::Failure;
use crate::file::Source;
use crate::grid::{Swept, grid};
use crate::kinematics::Kinematics;
use crate::load::load;
use crate::loads::{Case, Outcome, Structure};
use crate::mechanism::{Order, State};
use crate::output::files::{announce, print};
use crate::output::progress::Progress;
use crate::output::rows::Forms;
use crate::output::target::Target;
use found::Found;
use report::Report;

/// What `suspension loads` is given.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML) with the load cases, see below.
    file: PathBuf,
    /// A drive and COUNT values of it, or one value, as for `suspension sweep`; from where it is at the design position.
    /// Without it the loads are those at the design position.
    #[arg(
        long = "drive",
        value_name = "NAME=FROM:TO:COUNT",
        allow_hyphen_values = true
    )]
    drives: Vec<Swept>,
    /// The values are the drives' own, as the file has them.
    #[arg(long)]
    absolute: bool,
    /// Write a row for each place as comma-separated values to PATH, or to standard output for `-`; on a grid without it
    /// to out/NAME_loads.csv, NAME being the motion file's.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
    /// Write the rows as JSON to PATH, or to standard output for `-`.
    #[arg(long, value_name = "PATH")]
    json: Option<PathBuf>,
}

impl Arguments {
    /// Loads the mechanism at each place.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. Places that have no configuration have no rows.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let forms = self.forms();
        forms.check(&self.file)?;
        let loaded = load(&source)?;
        let mechanism = &*loaded.at_design()?;
        let cases = loaded.load_cases(mechanism)?;
        if cases.is_empty() {
            let message = "no load case; write [loads.braking] with a line for each load, as contact = [-3000.0, 0.0, 4000.0]";
            return Err(source.refuse(&(0..0), message));
        }
        let structure = Structure::of(loaded.listing());
        let work = Work {
            source: source.name(),
            mechanism,
            structure: &structure,
            cases: &cases,
        };
        work.on(&self, &forms, interrupted)
    }

    fn forms(&self) -> Forms {
        let stem = self.file.file_stem().unwrap_or_default().to_string_lossy();
        let beside = || Path::new("out").join(format!("{stem}_loads.csv"));
        let is_grid = !self.drives.is_empty() && self.json.is_none();
        let csv = self.csv.clone().or_else(|| is_grid.then(beside));
        Forms {
            csv: csv.map(Target::from),
            json: self.json.clone().map(Target::from),
            parquet: None,
        }
    }
}

struct Work<'a> {
    source: &'a str,
    mechanism: &'a dyn Kinematics,
    structure: &'a Structure<'a>,
    cases: &'a [Case],
}

impl Work<'_> {
    fn on(
        &self,
        arguments: &Arguments,
        forms: &Forms,
        interrupted: &AtomicBool,
    ) -> Result<(), Failure> {
        let grid = grid(self.mechanism, &arguments.drives, arguments.absolute);
        let grid = grid.map_err(Failure::Input)?;
        let mut progress = Progress::new(grid.places().unwrap_or_default(), "places");
        let visited = self
            .mechanism
            .visit(&grid, Order::First, interrupted, &mut |place| {
                progress.step();
                let cases = self.cases.iter();
                let outcomes = cases.map(|case| self.structure.under(self.mechanism, case, place));
                (place.state(), outcomes.collect::<Vec<_>>())
            });
        let failure = visited.failure(self.source);
        let places = visited.places.into_iter().flatten();
        let (states, outcomes): (Vec<State>, Vec<_>) = places.unzip();
        if !states.is_empty() {
            self.write(&states, outcomes, forms)?;
        }
        failure.map_or(Ok(()), Err)
    }

    /// `outcomes` are those of each case, at each place.
    fn write(
        &self,
        states: &[State],
        outcomes: Vec<Vec<Option<Outcome>>>,
        forms: &Forms,
    ) -> Result<(), Failure> {
        let found = self.cases.iter().enumerate().map(|(number, case)| {
            let of_case = outcomes.iter().map(|outcomes| outcomes[number].clone());
            Found::new(self.source, case, of_case.collect())
        });
        let found = found.collect::<Result<Vec<_>, _>>()?;
        if !forms.is_empty() {
            table::write(self.mechanism, self.structure, states, &found, forms)?;
            let written: Vec<PathBuf> = forms.files().map(|(path, _)| path.clone()).collect();
            announce(&written);
        }
        if [&forms.csv, &forms.json].contains(&&Some(Target::Stdout)) {
            return Ok(());
        }
        let report = Report {
            file: self.source,
            mechanism: self.mechanism,
            structure: self.structure,
        };
        found
            .iter()
            .try_for_each(|found| print(&report.text(found)))
    }
}

const NOTES: &str = "\
Load cases are tables of the motion file, a line for each load:

  [loads.braking]
  contact = [-3000.0, 0.0, 4000.0]     # N, in the file's axes, where the tyre touches the ground
  wheel_centre = { force = [0.0, 500.0, 0.0], moment = [0.0, -90.0, 0.0] }   # N, and N m, at a point of a body
  bump_stop = 1200.0                   # N in a measured length, pushing its ends apart
  bump = \"damper\"                    # the spring along the measure damper carries the wheel, not the drive bump

A load acts at a point of the listing by its name, at `contact` (left_contact of a wheel named left; the file states
wheel_radius under [vehicle]), or in a measure: a number, positive where it makes the measure larger, N m of an angle.
What acts at the contact point goes into the carrier, as with brakes at the wheel or a locked hub. A wheel that rolls
freely, or that a shaft drives, takes a longitudinal force at its centre: state that there.

All is quasi-static and without friction: no weight, no inertia. What a drive bears is the work of the loads per unit of
the drive: what holds the drive must bear it. With bump = \"damper\" the drive bears nothing, and the force in the measure
damper that takes its load is printed: negative where a spring pulls.

Links: tension is positive. Joints: the force that a body, or what else a statement is, exerts at each of its points, on
the chassis or on the parts that it joins there, in the file's axes.

Over a grid of drives the least and the greatest are printed, and a row for each place is written: the drives, then of
each case what drives and measures bear, links and joints: braking_bump_N, braking_damper_N, braking_tie_rod_N,
braking_upright_lower_ball_x_N.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 some places have no configuration, 130 interrupted.

Example:
  suspension loads examples/double_wishbone_rocker.toml --drive bump=-0.05:0.05:21";
