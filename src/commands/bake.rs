//! `suspension bake`: a motion along drives, or along a measure, as a source file.

pub mod baking;
mod wheel;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::builder::TypedValueParser;
use clap::{Args, ValueEnum};

use crate::bake::source::Language;
use crate::bake::{Continuity, RequestedPoints};
use crate::failure::Failure;
use crate::file::{Source, tell};
use crate::kinematics::Kinematics;
use crate::option_numbers::{derivatives, number};
use crate::output::default_path::in_out;
use crate::output::notes::{print_notes_on, with_notes_printed};
use crate::output::progress::Busy;
use crate::output::target::Target;
use crate::prepare::load;
use baking::{Baking, RequestedDrive, RequestedMeasure, Variables};

/// The arguments of `suspension bake`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// The drive, if the linkage has several; give it twice for a surface over two drives. The other drives are held as at
    /// the file's first instant. The range may follow the name, in place of --from and --to.
    #[arg(long = "drive", value_name = "NAME[=FROM:TO]")]
    drives: Vec<RequestedDrive>,
    /// A measure of the listing, such as a damper's length, in place of the drive that --drive names, over a range of its
    /// own values in the file's units: the outputs are functions of the measure.
    #[arg(long, value_name = "MEASURE=FROM:TO", conflicts_with_all = ["from", "to"])]
    along: Option<RequestedMeasure>,
    /// The drive's first value in the file's units: its own, as in [drives], not a change from the design. Without it the
    /// least value in the file's motion.
    #[arg(long, value_name = "X", allow_negative_numbers = true, value_parser = own_value('X'))]
    from: Option<f64>,
    /// The drive's last value, also its own. Without it the greatest value in the file's motion.
    #[arg(long, value_name = "Y", allow_negative_numbers = true, value_parser = own_value('Y'))]
    to: Option<f64>,
    /// The largest error of a point, in metres whatever the file's unit.
    #[arg(
        long,
        value_name = "M",
        default_value = "1e-6",
        allow_negative_numbers = true,
        value_parser = number("M is a number of metres, as 1e-6")
    )]
    tolerance: f64,
    /// How many derivatives are continuous where segments join. Choose as many as your program reads.
    #[arg(long, value_name = "0|1|2", default_value_t = 1, allow_negative_numbers = true, value_parser = derivatives())]
    continuity: u8,
    /// What to bake.
    #[arg(long, value_enum, default_value_t = Points::Wheel)]
    points: Points,
    /// The wheel, if the listing names several. Without it the one that the drive moves up and down, or else the first that it
    /// moves.
    #[arg(long, value_name = "NAME")]
    wheel: Option<String>,
    /// The language of the file.
    #[arg(long = "as", value_enum, default_value_t = Form::Rust)]
    language: Form,
    /// Write to PATH, or to standard output for `-`. Without it the file is out/NAME_WHAT_by_DRIVE.rs, or _by_MEASURE.rs,
    /// .h or .toml, where NAME is the motion file's name, followed by that of the wheel if --wheel is given.
    #[arg(short, long, alias = "output", value_name = "PATH")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Points {
    /// Every free point and marker: three outputs each.
    All,
    /// The wheel, of several the one of --wheel: centre and spin axis, six outputs.
    Wheel,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Form {
    /// A `static` of `suspension_core::baked`: `Curve`, or `Surface` over two drives.
    Rust,
    /// A header in C99 with a function that evaluates the polynomials.
    C,
    /// The numbers alone.
    Toml,
}

impl Arguments {
    /// Bakes and writes the file.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(&self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let loaded = load(&source)?;
        let mechanism = &*with_notes_printed(loaded.at_first_instant()?);
        loaded.check_driven("suspension bake", mechanism)?;
        let baking = self.baking((source.name(), mechanism), interrupted)?;
        let file = {
            let _shown = Busy::new("baking");
            baking.execute()?
        };
        print_notes_on(source.name(), wheel::note_on_still(&baking));
        let language = match self.language {
            Form::Rust => Language::Rust,
            Form::C => Language::C,
            Form::Toml => Language::Toml,
        };
        let of_wheel = self.wheel.iter().map(|wheel| format!("_{wheel}"));
        let of_wheel: String = of_wheel.collect();
        let ending = format!("{of_wheel}_{}.{}", file.subject(), language.extension());
        let own = in_out(&self.file, &ending);
        let target = Target::from(self.out.clone().unwrap_or_else(|| own.clone()));
        target.refuse_input("--out")?;
        target.write(&file.text(language, target.path().unwrap_or(&own)))?;
        if let Some(path) = target.path() {
            let (path, ranges) = (path.display(), file.about.ranges_in_words());
            let count = file.baked.count_in_words();
            tell(format_args!("wrote {path}: {ranges}, {count}"));
        }
        Ok(())
    }

    fn variables(&self) -> Result<Variables, Failure> {
        if let Some(along) = &self.along {
            return self.measure_variables(along);
        }
        let ends = [self.from, self.to];
        let mut drives = self.drives.clone();
        if drives.is_empty() {
            drives.push(RequestedDrive::default());
        }
        if ends.iter().any(Option::is_some) {
            let [only] = drives.as_mut_slice() else {
                let message = "--from and --to give the range of one drive; for two drives write --drive NAME=FROM:TO for each";
                return Err(Failure::Input(message.to_owned()));
            };
            if only.range.iter().any(Option::is_some) {
                let message =
                    "--from and --to repeat the range after --drive; give only one of the two";
                return Err(Failure::Input(message.to_owned()));
            }
            only.range = ends;
        }
        Ok(Variables::Drives(drives))
    }

    /// Returns the measure with its range and the drive that it replaces.
    fn measure_variables(&self, along: &RequestedMeasure) -> Result<Variables, Failure> {
        let drive = match self.drives.as_slice() {
            [] => None,
            [RequestedDrive { drive, range }] if *range == [None; 2] => drive.clone(),
            _ => {
                let message = "--along takes the place of one drive; name this drive without a range: --drive NAME";
                return Err(Failure::Input(message.to_owned()));
            }
        };
        Ok(Variables::Measure(RequestedMeasure {
            drive,
            ..along.clone()
        }))
    }

    fn baking<'a>(
        &self,
        (file, mechanism): (&'a str, &'a dyn Kinematics),
        interrupted: &'a AtomicBool,
    ) -> Result<Baking<'a>, Failure> {
        let variables = self.variables()?;
        let wheel = wheel::chosen(mechanism, &variables, self.wheel.as_deref());
        let wheel = wheel.map_err(|message| Failure::input(file, message))?;
        Ok(Baking {
            file,
            mechanism,
            variables,
            tolerance: self.tolerance,
            continuity: match self.continuity {
                0 => Continuity::Position,
                1 => Continuity::Velocity,
                _ => Continuity::Acceleration,
            },
            points: match (self.points, &self.wheel) {
                (Points::Wheel, _) => RequestedPoints::Wheel(wheel),
                (Points::All, None) => RequestedPoints::AllPoints,
                (Points::All, Some(_)) => {
                    let message = "--points all bakes the points of all wheels; leave --wheel out";
                    return Err(Failure::Input(message.to_owned()));
                }
            },
            interrupted,
        })
    }
}

fn own_value(called: char) -> impl TypedValueParser<Value = f64> {
    number(format!(
        "{called} is a number, the drive's own value in the file's units, as 0.30"
    ))
}

const NOTES: &str = r#"The file has polynomials of degree five over segments of equal length, as few as meet the tolerance, and a header that
states what was baked, from which file, range, units, tolerance asked for and reached, segments and bytes. The outputs are
the coordinates of points; for the wheel they are its centre and its spin axis (unit length, outboard). The tolerance counts
the axis as a point one metre from the centre. The turn about the axis is the wheel's own and is not baked.

A baked drive that is an angle is in radians, whatever the file's unit of angles.

The tolerance is checked against the solver at 32 Chebyshev points in each segment, between the places where polynomial and
motion meet. The bound between these points assumes a smooth motion, as falling errors at the points indicate; it is not a proof.
The header of a curve also has the errors of the derivatives.

Outside its range a curve has no value: Rust returns an error that holds the nearest end, C returns 1. Near a turning point
of the drive, positions change like a square root, which no polynomial follows: bake refuses the range and names one that is
possible.

Along a measure, the outputs are functions of the measure and their derivatives are with respect to it. The measure leads in
place of the drive, even where the drive turns. If the measure itself turns back within the range, or does not reach it,
bake refuses the range and names one that is possible. If it has the same values on two branches, one on either side of where
it turns back, bake takes that of the file's first instant, and the file says so.

Over two drives, such as travel and steering, the result is a surface of patches, checked at points all over each patch; at
most one derivative is continuous across patches.

  Rust  a `static` of suspension_core::baked::Curve or Surface: no heap, no operating system
  C     a header (C99) with a function, no library
  TOML  the numbers

Names in the file derive from the file's own name and from what is baked, so that a program can have several:
out/my_wheel_by_theta.h and out/my.h have the function my_wheel_by_theta.

Exit codes: 0 done, 1 the file cannot be written, 2 wrong input, such as the name of no drive or an empty range, 3 part of
the range is out of the mechanism's reach, or the tolerance is not met (nothing is written), 130 interrupted.

Example:
  suspension bake examples/five_link.toml --from 0.75 --to 2.0 --tolerance 1e-5 --as c
  suspension bake examples/double_wishbone_pushrod.toml --along damper=0.33:0.37 --drive bump --as c
  suspension bake examples/double_wishbone_pushrod.toml --drive bump=0.24:0.36 --drive steer=0.32:0.36 --tolerance 1e-5"#;
