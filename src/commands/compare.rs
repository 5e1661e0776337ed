//! `suspension compare`: two suspensions side by side, or one beside measured numbers.

mod comparison;
mod curve_pair;
mod differences;
mod measured;
mod notes;
mod over_wheel_travel;
mod page;
mod report;
mod short_name;
mod suspension;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::characteristics::{Span, no_steering};
use crate::failure::Failure;
use crate::file::Source;
use crate::grid::counted_from;
use crate::output::destinations::Destinations;
use crate::output::notes::with_notes_printed;
use crate::prepare::{Loaded, load};
use report::Report;
use suspension::Suspension;

/// The arguments of `suspension compare`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// A motion file (TOML), see suspension motion --help.
    a: PathBuf,
    /// Another motion file; numbers in another unit or other axes are converted to those of A. Or a table of measured numbers,
    /// whose name ends in .csv, .tsv or .txt, see below.
    b: PathBuf,
    /// How far the drives that move the wheels up and down change from the design positions, in the unit of A; a positive
    /// change raises the wheel, also where the drive itself becomes less. If the drive is a height, this is the wheel
    /// travel. Without it 60 mm down and up; 0.2 rad if the drive is an angle; less where a mechanism locks before.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    travel: Option<Span>,
    /// The same for the drive that steers. Without it 30 mm to either side; 0.2 rad if the drive is an angle.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    steer: Option<Span>,
    /// Take the values of drives in a table as the drives' own, as sweep prints them, not as changes.
    #[arg(long)]
    absolute: bool,
    /// Draw the curves of both files on a page of HTML, one chart for each quantity, at PATH or on standard output for `-`.
    #[arg(long, value_name = "PATH")]
    html: Option<PathBuf>,
    /// Write the differences as comma-separated values to PATH, or to standard output for `-`.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
    /// Write the differences as JSON to PATH, or to standard output for `-`: a header with the names of A and B, and the rows of
    /// --csv under the same names.
    #[arg(long, value_name = "PATH")]
    json: Option<PathBuf>,
}

impl Arguments {
    /// Compares, prints and writes.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. If a mechanism locks within the travel, its curves end there, and the command compares what remains.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let is_table = measured::is_table(&self.b);
        let read = if is_table {
            Source::read_table
        } else {
            Source::read
        };
        let [a, b] = [Source::read(&self.a)?, read(&self.b)?];
        if measured::is_table(&self.a) && !is_table {
            let [table, model] = [a.name(), b.name()];
            let message = format!("the table comes second: suspension compare {model} {table}");
            return Err(Failure::input(table, message));
        }
        let first = load(&a)?;
        let refuse = |message: &str| Err(Failure::input(b.name(), message));
        let second = match is_table {
            true if self.travel.is_some() || self.steer.is_some() => {
                return refuse("the table states the places; leave --travel and --steer out");
            }
            true => None,
            false if self.absolute => {
                return refuse(
                    "--absolute is for the drives of a table of measured numbers; leave it out",
                );
            }
            false => Some(load(&b)?),
        };
        // Files that were read are known, and nothing is solved yet.
        let to = Destinations::new([&self.csv, &self.json, &self.html])?;
        let (report, failure) = match &second {
            Some(second) => self.compared([(&a, &first), (&b, second)], interrupted)?,
            None => {
                let from = counted_from(self.absolute);
                let report = measured::compare((&a, &first), &b, from, interrupted)?;
                (report, None)
            }
        };
        to.write(
            || report.text(),
            |tables| report.write(tables),
            || page::html(&report),
        )?;
        failure.map_or(Ok(()), Err)
    }

    /// Compares two suspensions; the failure is that of a mechanism which locks within the travel.
    fn compared(
        &self,
        files: [(&Source, &Loaded<'_>); 2],
        interrupted: &AtomicBool,
    ) -> Result<(Report, Option<Failure>), Failure> {
        let [(a, first), _] = files;
        let spans = [self.travel, self.steer];
        let side = |(source, loaded): (&Source, &Loaded<'_>)| {
            let mechanism = with_notes_printed(loaded.at_design_in(first.axes())?);
            let converted = converted([loaded, first]);
            Suspension::compute(
                &*mechanism,
                (source, converted),
                spans,
                first.unit(),
                interrupted,
            )
        };
        let [one, other] = [side(files[0])?, side(files[1])?];
        let sides = [&one, &other];
        if self.steer.is_some() && !sides.iter().any(|side| side.steers()) {
            return Err(no_steering(a.name()));
        }
        let report = comparison::compare(sides);
        Ok((report, one.failure.or(other.failure)))
    }
}

/// Says from which unit or axes to which the numbers of a file are converted; `None` if they are not.
fn converted([own, first]: [&Loaded<'_>; 2]) -> Option<String> {
    let [from, to] = [own, first].map(|loaded| loaded.unit().symbol());
    let unit = (from != to).then(|| format!("from {from} to {to}"));
    let [from, to] = [own, first].map(|loaded| loaded.axes().name());
    let axes = (from != to).then(|| format!("from axes {from} to {to}"));
    let both: Vec<String> = unit.into_iter().chain(axes).collect();
    (!both.is_empty()).then(|| both.join(" and "))
}

const NOTES: &str = "\
Compares all quantities that both suspensions have: their values at the design positions (those of the files' points), their
derivatives with respect to travel and steering, such as bump camber, bump steer and motion ratios, and the places where
their curves over travel and steering differ most. A difference is B - A. The layouts may be different: quantities have the
same names in all layouts, and the report names those that only one of the files has above its tables. Positions and drives
are in the axes and the unit of A; quantities with signs of their own, such as camber and toe, are the same in all axes. The
[vehicle] tables of the files state what the listings do not, as for suspension sheet. Wheels with the same numbers share a
row of the report and of the page; --csv and --json have a row for each.

Instant centres, swing arms and roll centres that are near infinity within the travel are not compared over it.
Derivatives are per unit of the drive, whose values may count downwards, as in SAE axes: `per travel of the wheel` where
the drive is the height of the wheel, upwards, otherwise `per change of` the drive. The curves over travel always go upwards.
Wheels and drives of the same name are compared with each other; where only one of the files names its wheels, each of
them is compared with the wheel of the other file.

Equal changes of the two drives may not move the same wheels equally far, for example those of a height and a damper's
length, or of a height and heave. Then derivatives are `per wheel travel`: per rise of one wheel centre, the other wheel
centres held. Curves, including those of motion ratios, are `over wheel travel`: for each file, the cubic through the four
nearest of the 61 places of its drive. Roll is compared over the travel of the wheel that rises; the fall of the other wheel
is one of the quantities compared.

The table of --csv has a row for each number, with the columns `of`, quantity, unit, at, a, b, difference, rms and along; angles
are in degrees. The column `of` has design, per travel or per wheel travel, per steer, over travel or over wheel travel, over roll
or over roll by wheel travel, over steer; for a second wheel per travel 2. The column `at`, meant for people, has the change
of the drive, or the wheel travel, where the curves differ most; it is empty where they differ by rounding alone, or by the
same amount everywhere. The report has `everywhere` there. The values are then those at the design position, or nearest
to it where it is not within the range. The column rms has the root of the mean square of the difference over the places of
a curve, and along what `at` counts.

If B is a table, of a rig say, the model is moved to its places. The first line of several fields has headings, the second
perhaps units for those without; titles above the headings and lines that begin with # are left out. Commas, semicolons or
tabs separate fields, and decimal commas are read where commas do not separate. A heading is a name that sweep has in its
tables (left_camber_rad), or a name with a unit in brackets: left camber [deg], camber angle (deg), damper [mm]. Other columns
are left out, with a note. The places are in columns of drives (bump [mm]), of drives that move together, as for sweep
(\"left_bump,-right_bump [mm]\" for roll), and, where no such column moves the same, of wheel travel (left wheel travel [mm])
and of steering wheel angle [deg]. Several may change at once: in each line the model is moved to where all of them hold.
Drives without a column stay at the design position. Places count from the design position, but with --absolute drives have
their own values. All numbers are in the units of the headings.

If several columns change, `at` and the charts count along the first of those that change about as far as the one that changes
most: left wheel travel in parallel travel and in roll, whatever the noise of the rack. Where this column does not tell the
places apart, as on a grid of bump and steering, they count the lines of the file.

Rigs often set toe and camber to zero at the start. Hence the differences are stated as measured and without the offset, which
is the difference at the measured place nearest to the design position, smoothed over the places within 5 % of the range; `of`
in --csv has as measured, offset and without offset. The page has the measured points of both over the curves of the model.

  bump [mm];toe [deg];camber [deg]
  -40,0;0,41;0,21
  0,0;0,02;0,00

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, such as a measured place out of reach, 3 a mechanism locks
within --travel or --steer (the part before the lock is compared), 130 interrupted.

Examples:
  suspension compare examples/double_wishbone_pushrod.toml examples/macpherson.toml --html out/compared.html
  suspension compare examples/double_wishbone_pushrod.toml examples/double_wishbone_measured.csv --html out/measured.html";
