//! `suspension compare`: two suspensions beside each other.

mod differences;
mod page;
mod report;
mod side;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::characteristics::Span;
use crate::failure::Failure;
use crate::file::Source;
use crate::load::{Loaded, load};
use crate::mechanism::Axes;
use crate::output::files::{announce, print, refuse_input, write_file};
use crate::output::target::Target;
use differences::Comparison;
use side::Side;

/// What `suspension compare` is given.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// A motion file (TOML), see suspension motion --help.
    a: PathBuf,
    /// Another; where its unit is another, its numbers are converted to that of the first.
    b: PathBuf,
    /// The travel, from the design positions, in the unit of A; without it 60 mm down and up.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    travel: Option<Span>,
    /// The same of the drive that steers; without it 30 mm to either side.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    steer: Option<Span>,
    /// Draw the curves of both, a chart each, on a page of HTML.
    #[arg(long, value_name = "PATH")]
    html: Option<PathBuf>,
    /// Write the differences as comma-separated values to PATH, or to standard output for `-`.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
}

impl Arguments {
    /// Compares, prints and writes.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. Where a mechanism locks within the travel, its curves end there, and what there is is compared.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let csv = self.csv.clone().map(Target::from);
        for input in [&self.a, &self.b] {
            if let Some(html) = &self.html {
                refuse_input(html, input, "--html")?;
            }
            if let Some(Target::File(csv)) = &csv {
                refuse_input(csv, input, "--csv")?;
            }
        }
        let [a, b] = [Source::read(&self.a)?, Source::read(&self.b)?];
        let (first, second) = (load(&a)?, load(&b)?);
        check_axes([&a, &b], [first.axes(), second.axes()])?;
        let spans = [self.travel, self.steer];
        let side = |source: &Source, loaded: &Loaded<'_>| {
            let mechanism = loaded.at_design()?;
            Side::of(&*mechanism, source, spans, first.unit(), interrupted)
        };
        let (a, b) = (side(&a, &first)?, side(&b, &second)?);
        let comparison = Comparison::of([&a, &b]);
        if csv != Some(Target::Stdout) {
            print(&report::text([&a, &b], &comparison))?;
        }
        let mut written = Vec::new();
        if let Some(target) = &csv {
            report::table(&comparison, target)?;
            if let Target::File(path) = target {
                written.push(path.clone());
            }
        }
        if let Some(path) = &self.html {
            write_file(path, &page::html([&a, &b], &comparison))?;
            written.push(path.clone());
        }
        announce(&written);
        let Side { missing, .. } = a;
        missing
            .into_iter()
            .chain(b.missing)
            .next()
            .map_or(Ok(()), Err)
    }
}

/// A coordinate, or a derivative per drive, has another sign in other axes.
fn check_axes([a, b]: [&Source; 2], axes: [Axes; 2]) -> Result<(), Failure> {
    let [of_a, of_b] = axes;
    if of_a == of_b {
        return Ok(());
    }
    Err(Failure::Input(format!(
        "{} has axes = \"{}\" and {} has axes = \"{}\"; state both in the same axes",
        a.name(),
        of_a.name(),
        b.name(),
        of_b.name()
    )))
}

const NOTES: &str = "\
Of both suspensions at their design positions, those of the files' points: all quantities that both have, their
derivatives with respect to travel and steering, as bump camber, bump steer and motion ratios, and of each curve over
travel and steering where the two differ most. A difference is B - A. The layouts may be different; quantities have
the same name in all. Where only one of the files has named wheels, each of them is compared with the wheel of the other. The files' [vehicle] tables say what the listings do not, as for suspension sheet.

The table of --csv has a row a number: of (design, per travel, per steer, over travel, over steer; of a second wheel per travel 2), quantity, unit, at
(the drive's change where the curves differ most, for people), a, b, difference; angles in degrees.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 a mechanism locks within the travel (what there is is
compared), 130 interrupted.

Example:
  suspension compare examples/double_wishbone.toml examples/macpherson.toml --html out/compared.html";
