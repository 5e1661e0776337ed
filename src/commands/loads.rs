//! `suspension loads`: the forces in a mechanism under the load cases of its file.

mod drawing;
mod found;
mod leading;
mod line;
mod note;
mod report;
mod run;
mod table;
mod unloaded;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::failure::Failure;
use crate::file::Source;
use crate::grid::Swept;
use crate::load::load;
use crate::loads::{Structure, contact_of};
use crate::mechanism::{Names, Place};
use crate::output::beside::{in_out, name_of};
use crate::output::rows::Forms;
use crate::output::target::Target;
use run::Run;

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
    #[arg(long, requires = "drives")]
    absolute: bool,
    /// Load the mechanism at each instant of the file's motion, its masses moving as they do there.
    #[arg(long, conflicts_with_all = ["drives", "absolute"])]
    motion: bool,
    /// Write a row for each place as comma-separated values to PATH, or to standard output for `-`; without it those of a
    /// grid to out/NAME_loads.csv, of a motion to out/NAME_loads_motion.csv, NAME being the motion file's.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
    /// Draw each case at the first place, with the forces along links, springs and other lengths in which something acts, as PATH/NAME_CASE.svg, NAME being the motion file's.
    #[arg(long, value_name = "PATH")]
    drawings: Option<PathBuf>,
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
        let loaded = load(&source)?;
        forms.check()?;
        let mechanism = if self.motion {
            loaded.at_first_instant()?
        } else {
            loaded.at_design()?
        };
        let mechanism = &*mechanism;
        let cases = loaded.load_cases(mechanism)?;
        let structure = Structure::of(loaded.listing());
        if cases.is_empty() {
            let mut sprung = |place: &dyn Place| structure.sprung(mechanism, &place.state());
            let sprung = mechanism.at_start(interrupted, &mut sprung).flatten();
            return Err(source.refuse(&(0..0), no_case(&mechanism.names, sprung)));
        }
        let run = Run {
            source: source.name(),
            mechanism,
            listing: loaded.listing(),
            structure: &structure,
            cases: &cases,
            drawings: self
                .drawings
                .as_deref()
                .map(|folder| (folder, name_of(&self.file).into_owned())),
        };
        if self.motion {
            run.in_motion(&forms, interrupted)
        } else {
            run.on_grid((&self.drives, self.absolute), &forms, interrupted)
        }
    }

    fn forms(&self) -> Forms {
        let ending = if self.motion {
            "_loads_motion.csv"
        } else {
            "_loads.csv"
        };
        let beside = || in_out(&self.file, ending);
        let is_grid = (self.motion || !self.drives.is_empty()) && self.json.is_none();
        let csv = self.csv.clone().or_else(|| is_grid.then(beside));
        Forms {
            csv: csv.map(Target::from),
            json: self.json.clone().map(Target::from),
            parquet: None,
        }
    }
}

const NOTES: &str = "\
Load cases are tables of the motion file, a line for each load:

  [loads.braking]
  contact = [-3000.0, 0.0, 4000.0]     # N, in the file's axes, where the tyre touches the ground
  wheel_centre = { force = [0.0, 500.0, 0.0], moment = [0.0, -90.0, 0.0] }   # N, and N m, at a point of a body
  bump_stop = 1200.0                   # N in a measured length, pushing its ends apart
  bump = \"damper\"                      # the spring along the measure damper carries the wheel, not the drive bump; a spring
                                       # of [springs] may be named in place of its measure

A load acts at a point of the listing by its name, at `contact` (left_contact of a wheel named left; the file states
wheel_radius under [vehicle]), or in a measure: a number, positive where it makes the measure larger, N m of an angle.
What acts at the contact point goes into the carrier, as with brakes at the wheel or a locked hub. A wheel that rolls
freely, or that a shaft drives or brakes, takes a longitudinal force at its centre: state that there.

Parts that move may have masses, in kg; a body's centre of mass is stated at the design position, its inertia about it in
kg m^2, in the file's axes: xx, yy, zz, and where they are not zero xy, yz, zx of the tensor:

  [masses]
  upright = { mass = 25.0, centre = \"wheel_centre\", inertia = [0.8, 1.2, 0.8] }   # a body; or centre = [x, y, z]
  tie_rod = 0.9                        # a link is a uniform rod
  damper_low = 1.5                     # what is at a point
  rack = 4.0                           # a chassis point that a drive moves: the drive bears its inertia

Their weight then acts in each case, downwards with 9.80665 m/s^2; a case may say gravity = [0.0, 0.0, 0.0], and
acceleration = [-8.0, 0.0, 0.0] of the chassis, m/s^2. With --motion their inertia acts too, from the velocities and
accelerations of the file's motion. Friction is left out. Tables of motion, sweep and sheet have effective_mass then: what
the masses are at the wheel in travel.

The drives hold the mechanism where it is: springs of [springs] do not act by themselves. What a drive bears is the work of the
loads per unit of the drive: what holds the drive must bear it; a note says where springs could, if
the case leaves them all out. With bump = \"damper\" the drive bears nothing, `bump (its load is in damper)`, and the force in the measure damper that takes
its load is printed: negative where a spring pulls; where the case states a force in the same measure, the sum of both.

Links: tension is positive. Joints: the force that a body, or what else a statement is, exerts at each of its points, on
the chassis or on the parts that it joins there, in the file's axes; also that of a link with a mass, whose tension is that
at its middle, and of one whose angle is driven or held. `damper at damper_upper` is what a spring or a stated force in the
measure damper exerts at an end of it, all that acts in the measure together. The forces of each body balance, but for loads,
weight and moments that act on it. A moment about an angle acts on what carries the angle's lines, which passes it on: `bar on arm`
is that of a torsion bar, N m, all that acts in the measure bar together; `cross on shaft` that of a universal joint, or of what else
drives or holds an angle. What the two bushes of a hinge bear along its axis rigid parts leave open: each is given half of it. Where
two bodies share two points, likewise only the sum along their line is determined. Links, joints and moments that bear nothing at any
place are named in one line, `no load in:`; tables of --csv have their columns too. Chassis points: the force that all links, joints,
measures and drives of lengths at a chassis point exert on it together, as its bracket bears it, without the weight of what is at the
point itself. A chassis point that a drive moves, a rack's end say, is one of them, marked `(driven)`: along its way the drive bears the force.

Over a grid of drives, or a motion, the least and the greatest are printed with the place of each: the time of a motion, and the
drives that move, with the values that they have in the file. A row for each place is written: the time of a motion, the drives,
then of each case what drives and measures bear, links and joints: braking_bump_N, braking_damper_N, braking_tie_rod_N,
braking_upright_lower_ball_x_N, braking_damper_damper_upper_x_N, moments about angles: braking_bar_arm_x_Nm; and what is on
the chassis: braking_on_chassis_lower_front_x_N.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 some places have no configuration, or
some cases no answer, 130 interrupted.

Example:
  suspension loads examples/double_wishbone_rocker.toml --drive bump=-0.05:0.05:21";

/// What to write in a file without a load case, with a drive of travel and a spring of the file that bears its load.
fn no_case(names: &Names, sprung: Option<(usize, usize)>) -> String {
    let borne = sprung.map(|(drive, spring)| {
        let drive = &names.drives[drive].name;
        let spring = &names.vehicle.springs[spring].name;
        format!(", and {drive} = \"{spring}\" for the spring to bear what the drive would")
    });
    let place = names.wheels.first().map(contact_of);
    let place = place.or_else(|| names.points.get(names.chassis).cloned());
    format!(
        "no load case; write [loads.braking] with a line for each load, as {} = [-3000.0, 0.0, 4000.0]{}",
        place.unwrap_or_default(),
        borne.unwrap_or_default()
    )
}
