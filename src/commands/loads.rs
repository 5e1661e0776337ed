//! `suspension loads`: the forces in a mechanism under the load cases of its file.

mod case_results;
mod drawing;
mod notes;
mod parts;
mod place_columns;
mod report;
mod report_lines;
mod run;
mod table;
mod unloaded;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::failure::Failure;
use crate::file::Source;
use crate::grid::{Swept, counted_from};
use crate::loads::{Structure, contact_of};
use crate::mechanism::{Names, Place};
use crate::output::default_path::target;
use crate::output::destinations::table_targets;
use crate::output::notes::with_notes_printed;
use crate::output::rows::TableTargets;
use crate::output::svg_folder::SvgFolder;
use crate::prepare::load;
use run::Run;

/// The arguments of `suspension loads`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML) with the load cases, see below.
    file: PathBuf,
    /// A drive and COUNT values of it, or one value, as for `suspension sweep`: changes from the design position.
    /// Without it the loads act at the design position.
    #[arg(
        long = "drive",
        value_name = "NAME=FROM:TO:COUNT",
        allow_hyphen_values = true
    )]
    drives: Vec<Swept>,
    /// Take the values as the drives' own, as the file states them, not as changes.
    #[arg(long, requires = "drives")]
    absolute: bool,
    /// Load the mechanism at each instant of the file's motion, with the inertia of its masses.
    #[arg(long, conflicts_with_all = ["drives", "absolute"])]
    motion: bool,
    /// Write a row for each place as comma-separated values to PATH, or to standard output for `-`. Without --csv and --json
    /// a grid is written to out/NAME_loads.csv and a motion to out/NAME_loads_motion.csv, where NAME is the motion file's name.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
    /// Draw each case at the first place as PATH/NAME_CASE.svg, with the forces along links, springs and other lengths
    /// in which a load acts. NAME is the motion file's name.
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
    /// See [`Failure`]. The tables omit places that have no configuration.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let tables = self.tables();
        let loaded = load(&source)?;
        tables.check()?;
        let mechanism = if self.motion {
            loaded.at_first_instant()
        } else {
            loaded.at_design()
        };
        let mechanism = &*with_notes_printed(mechanism?);
        let cases = loaded.load_cases(mechanism)?;
        let structure = Structure::new(loaded.listing());
        if cases.is_empty() {
            let mut sprung = |place: &dyn Place| structure.sprung(mechanism, &place.state());
            let sprung = mechanism.at_start(&mut sprung).flatten();
            return Err(source.refuse(&(0..0), no_case(&mechanism.names, sprung)));
        }
        let drawings = self.drawings.as_deref();
        let run = Run {
            source: source.name(),
            mechanism,
            listing: loaded.listing(),
            structure: &structure,
            cases: &cases,
            drawings: drawings.map(|folder| SvgFolder::new(folder, &self.file)),
        };
        if self.motion {
            run.run_motion(&tables, interrupted)
        } else {
            let from = counted_from(self.absolute);
            run.run_grid((&self.drives, from), &tables, interrupted)
        }
    }

    fn tables(&self) -> TableTargets {
        let ending = if self.motion {
            "_loads_motion.csv"
        } else {
            "_loads.csv"
        };
        let is_grid = self.motion || !self.drives.is_empty();
        let mut tables = table_targets([&self.csv, &self.json, &None]);
        if is_grid && tables.is_empty() {
            tables.csv = Some(target(None, &self.file, ending));
        }
        tables
    }
}

const NOTES: &str = "\
Load cases are tables of the motion file, with one line for each load:

  [loads.braking]
  contact = [-3000.0, 0.0, 4000.0]     # N, in the file's axes, where the tyre touches the ground
  wheel_centre = { force = [0.0, 500.0, 0.0], moment = [0.0, -90.0, 0.0] }   # N and N m, at a point of a body
  bump_stop = 1200.0                   # N in a measured length: it pushes the ends apart
  bump = \"damper\"                      # the spring along the measure damper carries the wheel, not the drive bump;
                                       # a spring of [springs] may be named in place of its measure
  acting = [\"arb\"]                     # springs and bars of [springs] that act by their rates

A load acts at a named point of the listing, at `contact`, or in a measure. `contact` needs wheel_radius under [vehicle];
for a wheel named left it is left_contact. A load in a measure is a number, positive where it makes the measure larger;
for an angle it is in N m. A force at the contact point acts on the carrier, as with brakes at the wheel or a locked hub.
For a wheel that rolls freely, or that a shaft drives or brakes, state the longitudinal force at the wheel centre instead.

Parts that move may have masses, in kg. State the centre of mass of a body at the design position, and its inertia about
that centre in kg m^2, in the file's axes: xx, yy, zz of the tensor and, where they are not zero, xy, yz, zx:

  [masses]
  upright = { mass = 25.0, centre = \"wheel_centre\", inertia = [0.8, 1.2, 0.8] }   # a body; or centre = [x, y, z]
  tie_rod = 0.9                        # a link is a uniform rod
  damper_low = 1.5                     # a mass at a point
  rack = 4.0                           # a chassis point that a drive moves: the drive bears its inertia

The weight of these parts then acts in each case, downwards with 9.80665 m/s^2. A case may state gravity = [0.0, 0.0, 0.0]
instead, and an acceleration of the chassis in m/s^2: acceleration = [-8.0, 0.0, 0.0]. With --motion the inertia of the
parts acts too, from the velocities and accelerations of the file's motion. Friction is left out. With [masses] the tables
of motion, sweep and sheet have effective_mass: the equivalent mass at the wheel in travel.

The drives hold the mechanism in place. The load on a drive is the work of the loads per unit of the drive; what holds the
drive must bear it. With bump = \"damper\" the drive bears nothing, `bump (its load is in damper)`, and the report gives the
force in the measure damper that takes this load: negative where a spring pulls.

A spring or bar of [springs] acts by its rate only if the line `acting` names it, with the force or moment that sweep prints
for the same place: spring_force_N, arb_moment_Nm. The report gives this load in the measure, and the drives bear its
reaction. The line acting = [\"arb\"] and --drive left_bump,-right_bump=-0.03:0.03:7 give the forces in the drop links of a bar
in roll. If a case also states a force in a measure in which springs act, or which bears the load of a drive, the report gives
the sum.

A note names the springs that do not act although their measures change, and another those that act and bear nothing, as a
bar at the design position, which is the only place without --drive. Another names each drive of travel whose load a spring
could bear, unless springs act by their rates or the case states a force in the measure of a spring.

Links: tension is positive. Joints: the force that a body or another statement exerts at each of its points, on the chassis
or on the parts that it joins there, in the file's axes. The table of joints also lists a link that has a mass (its tension
is then the one at its middle, without what its turning adds there in a motion), or whose angle is driven or held.
`damper at damper_upper` is the force at one end of the measure damper: springs and stated forces in the measure together.
The forces of each body balance, except for the loads, weight and moments that act on it. A moment about an angle acts on the
part that carries the angle's lines, which passes it on: `bar on arm` is the moment of a torsion bar, in N m, with all that
acts in the measure bar; `cross on shaft` is the moment of a universal joint, or of another statement that drives or holds an
angle. With rigid parts, only the sum of the axial forces of the two bushes of a hinge, or of a body with two chassis points,
is determined: each bush is given half of it. The same holds for two points that two bodies share, such as the ends of a
kingpin, along their line; if three bodies share both, the shares are arbitrary.

Chassis points: the total force that links, joints, measures and driven lengths exert on a chassis point, as its bracket
bears it, without the weight of a mass at the point itself. Chassis points that a drive moves, such as the end of a rack,
are marked `(driven)`: along their path the drive bears the force. The reaction of a `couple`, as of what holds a drive, is on
no chassis point that the statement does not name. The line `no load in:` names the links, joints and moments that bear
nothing at any place; the tables have their columns all the same.

In drawings each force along a line is a tension: a damper that pushes its ends apart with 100 N has -100 N there.

Over a grid of drives, or a motion, the report gives the least and the greatest values with the place of each: the time of
a motion and the drives that move, with their values in the file. The table has a row for each place: the time of a motion
and the drives, then for each case the loads on drives and measures, links and joints: braking_bump_N, braking_damper_N,
braking_tie_rod_N, braking_upright_lower_ball_x_N, braking_damper_damper_upper_x_N; moments about angles:
braking_bar_arm_x_Nm; and the forces on the chassis: braking_on_chassis_lower_front_x_N.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 some places have no configuration or some cases have
no answer, 130 interrupted.

Example:
  suspension loads examples/double_wishbone_rocker.toml --drive bump=-0.05:0.05:21";

/// Returns the lines to add to a file without a load case, for a drive of travel and a spring of the file that bears its
/// load.
fn no_case(names: &Names, sprung: Option<(usize, usize)>) -> String {
    let borne = sprung.map(|(drive, spring)| {
        let drive = &names.drives[drive].name;
        let spring = &names.vehicle.springs[spring].name;
        format!(", and {drive} = \"{spring}\" for the spring to bear what the drive would")
    });
    let place = names.wheels.first().map(contact_of);
    let place = place.or_else(|| names.points.get(names.chassis).cloned());
    format!(
        "no load case; write [loads.braking] with a line for each load, as {} = [-3000.0, 0.0, 4000.0]{}; suspension loads --help explains load cases",
        place.unwrap_or_default(),
        borne.unwrap_or_default()
    )
}
