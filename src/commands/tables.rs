//! `suspension tables`: the kinematics of a wheel as the tables of vehicle models.

mod carmaker;
mod carsim;
mod wheel_motion;

use std::path::PathBuf;
use std::slice;
use std::sync::atomic::AtomicBool;

use clap::{Args, ValueEnum};

use crate::characteristics::{Effect, Span, check_spans, mode_states};
use crate::failure::Failure;
use crate::file::Source;
use crate::kinematics::Kinematics;
use crate::mechanism::{Pair, report_of_singular};
use crate::output::default_path::target;
use crate::output::files::announce;
use crate::output::notes::{print_notes, print_unmet_range, with_notes_printed};
use crate::prepare::load;
use wheel_motion::WheelMotion;

/// The arguments of `suspension tables`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// The program for which to write tables.
    #[arg(long = "as", value_name = "PROGRAM", ignore_case = true)]
    program: Program,
    /// The wheel, if the listing names several. Without it the first.
    #[arg(long, value_name = "NAME")]
    wheel: Option<String>,
    /// For CarSim: how far the drive that moves the wheel up and down changes from the design position, in the file's unit;
    /// a positive change raises the wheel, also where the drive itself becomes less, as the length of a damper. If the
    /// drive is a height, this is the wheel travel. Without it 60 mm down and up; 0.2 rad if the drive is an angle; less
    /// where the mechanism locks before.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    travel: Option<Span>,
    /// Write to PATH, or to standard output for `-`. Without it the file is out/NAME_carsim.par or out/NAME_carmaker.txt,
    /// where NAME is the motion file's name, followed by that of the wheel if --wheel is given.
    #[arg(short, long, value_name = "PATH")]
    out: Option<PathBuf>,
}

/// A program for vehicle models.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Program {
    /// Tables over jounce: camber, toe, dive, longitudinal and lateral movement, in mm and deg.
    Carsim,
    /// `Kind = Linear2D`: values at the design position and derivatives with respect to compression and steering, in m and rad.
    Carmaker,
}

impl Arguments {
    /// Writes the tables.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. If the mechanism locks, the tables end there and are still written.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let ending = match self.program {
            Program::Carsim => "_carsim.par",
            Program::Carmaker => "_carmaker.txt",
        };
        let of_wheel = self.wheel.iter().map(|wheel| format!("_{wheel}"));
        let ending = of_wheel.collect::<String>() + ending;
        if self.travel.is_some() && self.program == Program::Carmaker {
            let message = "--travel is for CarSim only; CarMaker's tables are derivatives at the design position";
            return Err(Failure::Input(message.to_owned()));
        }
        let target = target(self.out.as_deref(), &self.file, &ending);
        let source = Source::read(&self.file)?;
        let loaded = load(&source)?;
        target.refuse_input("--out")?;
        let mechanism = with_notes_printed(loaded.at_design()?);
        let (text, missing) = self.tables(&*mechanism, source.name(), interrupted)?;
        target.write(&text)?;
        announce(target.path());
        missing.map_or(Ok(()), Err)
    }

    /// Returns the text, and the failures of what could not be solved.
    fn tables(
        &self,
        mechanism: &dyn Kinematics,
        file: &str,
        interrupted: &AtomicBool,
    ) -> Result<(String, Option<Failure>), Failure> {
        let number = self.number(mechanism, file)?;
        let spans = [self.travel, None];
        let notes = check_spans(mechanism, file, spans, mechanism.unit)?;
        let modes = mode_states(mechanism, spans, mechanism.unit, interrupted);
        let drive = mechanism.names.wheels[number].travel;
        let mut of_wheel = modes
            .into_iter()
            .filter(|mode| mode.movement.effect == Effect::Travel);
        let moves = |drives: &[(usize, f64)]| drives.iter().any(|(other, _)| Some(*other) == drive);
        let Some(travel) = of_wheel.find(|mode| moves(&mode.drives)) else {
            return Err(Failure::Input(format!(
                "{file}: no drive moves this wheel up and down; name it in [vehicle]: travel = {{ ... }}"
            )));
        };
        let locked = || {
            Failure::Solver(format!(
                "{file}: the design position is singular; {}",
                report_of_singular(file)
            ))
        };
        let of = |number: usize| WheelMotion::compute(mechanism, number, &travel);
        let wheel = of(number).ok_or_else(locked)?;
        let text = match self.program {
            Program::Carsim => carsim::text(file, mechanism, &wheel),
            Program::Carmaker => {
                let pairs = Pair::all(&mechanism.names.wheels).into_iter();
                let mut opposite = pairs.filter_map(|pair| pair.other(number));
                let opposite = opposite.next().and_then(of);
                carmaker::text(file, mechanism, &wheel, opposite.as_ref())
            }
        };
        // Derivatives at the design position are complete wherever travel ends.
        let missing = match self.program {
            Program::Carsim => {
                print_notes(notes);
                print_unmet_range(slice::from_ref(&travel), file)
            }
            Program::Carmaker => None,
        };
        Ok((text, missing))
    }

    fn number(&self, mechanism: &dyn Kinematics, file: &str) -> Result<usize, Failure> {
        if mechanism.names.wheels.is_empty() {
            let message = "the listing states no wheel; write `wheel: inner -> centre;`";
            return Err(Failure::input(file, message));
        }
        let wanted = self.wheel.as_deref();
        let chosen = wanted.map_or(Ok(0), |wanted| mechanism.names.chosen_wheel(wanted));
        chosen.map_err(|message| Failure::input(file, message))
    }
}

const NOTES: &str = "\
The tables are of one wheel in travel, while the other wheels of its axle move with it. Compression, or jounce, is the rise
of the wheel centre from the design position. Angles of the carrier are rotations about the axes of ISO 8855: x forward,
y left, z up.

CarSim: CAMBER_TABLE, TOE_TABLE, SUSP_DIVE_TABLE, SUSP_X_TABLE and SUSP_LAT_TABLE are changes from the design position over
jounce, in mm and deg; A_CAMBER and A_TOE are the static angles. Camber and toe are those of the spin axis; dive is
atan2(R02, R22) of the carrier's rotation R since the design position, rows and columns counted from 0. Camber is positive
where the top leans outboard, toe where the front points inboard, dive where the top moves forward, X forward, LAT inboard.
The form is that of the library files of CarSim 2021; check the signs of toe and dive against your version.

CarMaker: a suspension of Kind = Linear2D. Each row has a value at the design position, from which movements and lengths
count (they are 0 there; angles are the static ones), and its derivatives with respect to compression and to the drive that
steers, in m and rad: per m of a rack, but per rad of the angle of a steering arm, as the file's second line says. The drive
is positive where it turns the wheel to the left. tx, ty, tz are the movement of the wheel centre; rx, ry, rz
are rotations about z, then x, then y, with the signs of rotations: rz is toe, and rx is camber as seen along the wheel.
They are the angles of Rz(rz) Rx(rx) Ry(ry), which turns the y axis into the spin axis: at the design position rx and rz are
static camber and toe, and ry is 0. Measured lengths with spring, damper or bar (also stabi or arb) in their names are
lSpring, lDamp and lStabi. If no measure has spring in its name, lSpring is the length of a spring of [springs] that is not
a bar. A bar along an angle has no lStabi, and a line says so. Measures of an axle that do not have the name of the wheel in
theirs, such as that of a spring between both rockers, have no row. ValidSide is left+right, with the right wheel as mirror
image of the left one, if the listing has one wheel or its wheels are mirror images; else it is the wheel's side. Rows begin
with SuspR if [vehicle] has axle = \"rear\" or the wheel's name begins with rear, for example rear_left; else with SuspF.

Neither form has compliance: bushings and forces are outside the model. A rigid axle would need both wheels as inputs, which
neither form has: its tables are of heave, in which both wheel centres rise alike. If its drives are not heights, this holds
exactly only at the design position.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 the mechanism locks within --travel (the part before
the lock is written), 130 interrupted.

Example:
  suspension tables examples/double_wishbone_pushrod.toml --as carsim --travel -0.08:0.08";
