//! `suspension vary`: what a hardpoint or a length changes, over a range of its values.

mod page;
mod report;
mod study;
mod values;
mod varied;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::characteristics::{DesignNumber, Span, no_steering, refuse_unknown_numbers};
use crate::failure::Failure;
use crate::file::Source;
use crate::output::destinations::Destinations;
use crate::output::notes::{print_notes_on, with_notes_printed};
use crate::prepare::{describe_one_sided, load};
use crate::quantities::is_first_in_curves;
use report::Report;
use study::{Spans, Study};
use values::Values;
use varied::Varied;

/// The arguments of `suspension vary`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// A coordinate of a point, the length of a link or a move of [tune], and COUNT changes of it from the design, evenly
    /// spaced from FROM to TO (both included), or one: rack.z=-0.006:0.006:5, tie_rod=0.001. They are in the unit and the axes of
    /// the file. Names joined by commas move together, with a minus the opposite way: left_tie_ball.y,-right_tie_ball.y.
    #[arg(value_name = "NAME=FROM:TO:COUNT", allow_hyphen_values = true)]
    values: Values,
    /// Print and draw the quantities whose names begin with NAME, such as camber or toe; give the option several times for
    /// several. Without it camber, toe, roll centres, measures, anti-dive and the like, caster and kingpin are printed where they
    /// are not zero throughout, and all quantities are written and drawn.
    #[arg(long = "of", value_name = "NAME")]
    of: Vec<String>,
    /// How far the drives that move the wheels up and down change from the design position on the page of --html, in the
    /// file's unit; a positive change raises the wheel, also where the drive itself becomes less. Without it 60 mm down and
    /// up; 0.2 rad if the drive is an angle; less where the mechanism locks before.
    #[arg(
        long,
        value_name = "FROM:TO",
        allow_hyphen_values = true,
        requires = "html"
    )]
    travel: Option<Span>,
    /// The same for the drive that steers. Without it 30 mm to either side; 0.2 rad if the drive is an angle.
    #[arg(
        long,
        value_name = "FROM:TO",
        allow_hyphen_values = true,
        requires = "html"
    )]
    steer: Option<Span>,
    /// Draw curves over travel and steering on a page of HTML, one chart for each quantity with a curve for each value, at PATH
    /// or on standard output for `-`.
    #[arg(long, value_name = "PATH")]
    html: Option<PathBuf>,
    /// Write the numbers as comma-separated values to PATH, or to standard output for `-`: a row for each number at each value.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
    /// Write the numbers as JSON to PATH, or to standard output for `-`: a header with the file and what is varied, and the
    /// rows of --csv under the same names.
    #[arg(long, value_name = "PATH")]
    json: Option<PathBuf>,
}

impl Arguments {
    /// Computes the suspensions, prints and writes.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. Values with which there is no suspension are left out, and those after an interrupt.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let file = source.name();
        let loaded = load(&source)?;
        let to = Destinations::new([&self.csv, &self.json, &self.html])?;
        let mechanism = &*with_notes_printed(loaded.at_design()?);
        if self.steer.is_some() && mechanism.names.vehicle.steer.is_empty() {
            return Err(no_steering(file));
        }
        let varied = Varied {
            file,
            mechanism,
            change: loaded.change_together(mechanism, self.values.name())?,
        };
        let values = self.values.with_design();
        self.tell_doubts(&varied, &values);
        let spans: Option<Spans> = to.html.as_ref().map(|_| [self.travel, self.steer]);
        let study = Study::compute(&varied, &values, spans, interrupted)?;
        let [printed, written] = self.chosen(&varied, &study)?;
        if to.html.is_none() && study.changes_nothing() {
            return Err(Failure::Input(varied.describe_no_effect()));
        }
        let report = |numbers| Report {
            varied: &varied,
            study: &study,
            numbers,
        };
        to.write(
            || report(&printed).text(!self.of.is_empty()),
            |tables| report(&written).write(tables),
            || page::html(&report(&written), self.of.is_empty()),
        )?;
        study.failure(&varied).map_or(Ok(()), Err)
    }

    /// Notes what is probably a mistake in what is varied.
    fn tell_doubts(&self, varied: &Varied<'_>, values: &[f64]) {
        let notes = [
            describe_one_sided(varied.mechanism, &varied.change),
            self.values.doubt(varied.mechanism),
            varied.describe_elsewhere(values),
        ];
        print_notes_on(varied.file, notes.into_iter().flatten());
    }

    /// Returns the numbers to print, and those to write and draw.
    fn chosen(
        &self,
        varied: &Varied<'_>,
        study: &Study,
    ) -> Result<[Vec<DesignNumber>; 2], Failure> {
        let all = DesignNumber::all(varied.mechanism, &study.columns);
        let all: Vec<DesignNumber> = all.collect();
        let known = all.iter().filter(|number| study.has_value(number));
        let known: Vec<DesignNumber> = known.cloned().collect();
        let words = ["", "Without --of the usual quantities are printed"];
        refuse_unknown_numbers(&self.of, [&known, &all], varied.mechanism, words)
            .map_err(|message| Failure::input(varied.file, message))?;
        let is_named = |number: &DesignNumber| number.is_one_of(&self.of);
        let is_usual =
            |number: &DesignNumber| is_first_in_curves(study.columns[number.column].quantity);
        let [mut printed, mut written] = [known.clone(), known];
        if self.of.is_empty() {
            printed.retain(|number| is_usual(number) && study.is_not_zero(number));
        } else {
            printed.retain(is_named);
            written.retain(is_named);
        }
        Ok([printed, written])
    }
}

const NOTES: &str = "\
For each value the hardpoint is moved, and the suspension is built from its points and read at its own design position, like a
changed drawing; a link's length is changed with the chassis points and the drives held, as a turnbuckle does. Points move as
for suspension sensitivities: a marker that the file states as an offset from a point moves with it, and a point on a line
between two chassis points, like a rack in its housing, takes the line and the other points on it along when it moves across
the line: in examples/steered_axle.toml rack_left.z is the height of the whole rack, and rack_left.z,rack_right.z is the same. Of
other points of an axle, and of the rack of an axle that import wrote, left_tie_ball.z moves one side alone; left_rack.z,right_rack.z
moves both as in a mirror, across the vehicle with a minus: left_rack.y,-right_rack.y. There rack_housing, past which the rack moves,
changes nothing.

The table has a row for each quantity at the design position and for its derivative with respect to each drive (toe per bump is
bump steer), and a column for each value. The design itself is always among them. Without --of a line below the table names what
is alike for all values. Angles are in degrees. The table of --csv has all quantities without --of, with the columns value, of,
quantity, unit and number; `of` has design, per bump and the like.

The page of --html has a chart for each quantity that the values change visibly, over the drives of travel and steering and,
where a drive of travel is not the height of its wheel, over wheel travel; its curves are blue for the least value, red for
the greatest and black for the design, and dashed below the design. Of more than 100 values it has the curves of some, evenly
chosen, and says so.

A note names points that are assembled elsewhere, as the points do not satisfy the listing with the values. Values with which
no suspension can be assembled are left out, and the last message says why. After an interrupt the values that are done are
written.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 no suspension can be assembled with some of the values,
or one locks within --travel or --steer (the others, and the curves up to there, are written), 130 interrupted.

Examples:
  suspension vary examples/double_wishbone_pushrod.toml rack.z=-0.006:0.006:5 --of toe --of roll_centre --html out/varied.html
  suspension vary examples/double_wishbone_pushrod.toml tie_rod=-0.002:0.002:5 --csv -";
