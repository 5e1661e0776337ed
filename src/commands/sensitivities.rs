//! `suspension sensitivities`: what moving each hardpoint does to the quantities of a design.

mod report;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;
use suspension_runtime::Listing;

use crate::failure::Failure;
use crate::file::Source;
use crate::load::load;
use crate::mechanism::Names;
use crate::output::csv_file::CsvFile;
use crate::output::files::{announce, print, refuse_input};
use crate::output::heading::Heading;
use crate::output::progress::Progress;
use crate::output::target::Target;
use crate::sensitivities::{Sensitivities, changes, sensitivities};
use report::Report;

/// What `suspension sensitivities` is given.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// Print the quantities whose names begin so, as camber or toe; given several times, all of these. Without it all.
    #[arg(long = "of", value_name = "NAME")]
    of: Vec<String>,
    /// How many hardpoint coordinates and lengths are printed of each, those with the largest effect first.
    #[arg(long, value_name = "COUNT", default_value_t = 5)]
    largest: usize,
    /// Write all as comma-separated values to PATH, or to standard output for `-`, a row for each coordinate and length.
    #[arg(long, value_name = "PATH")]
    csv: Option<PathBuf>,
}

impl Arguments {
    /// Finds the sensitivities, and prints or writes them.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(&self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let csv = self.csv.clone().map(Target::from);
        if let Some(Target::File(path)) = &csv {
            refuse_input(path, &self.file, "--csv")?;
        }
        let loaded = load(&source)?;
        let mechanism = &*loaded.at_design()?;
        let links = links(loaded.listing(), &mechanism.names);
        let changes = changes(mechanism, &links);
        let mut progress = Progress::new(changes.len(), "changes");
        let found = sensitivities(mechanism, &changes, interrupted, || progress.step());
        let Some(found) = found else {
            let message = format!("{}: interrupted; nothing was written", source.name());
            return Err(Failure::Interrupted(message));
        };
        let report = Report {
            file: source.name(),
            mechanism,
            found: &found,
        };
        if csv != Some(Target::Stdout) {
            print(
                &report
                    .text(&self.of, self.largest)
                    .map_err(Failure::Input)?,
            )?;
        }
        if let Some(target) = &csv {
            write(&report, &found, target)?;
        }
        Ok(())
    }
}

/// The lengths of links, by number.
fn links(listing: &Listing, names: &Names) -> Vec<usize> {
    let statements = listing.statements().into_iter();
    let links = statements.filter(|statement| statement.kind == "link");
    links
        .filter_map(|link| names.lengths.iter().position(|length| length == link.name))
        .collect()
}

fn write(report: &Report<'_>, found: &Sensitivities, target: &Target) -> Result<(), Failure> {
    let heading = |name| Heading {
        name,
        counts: false,
    };
    let columns = report.numbers().map(|number| number.csv_name);
    let headings = ["changed".to_owned()]
        .into_iter()
        .chain(columns)
        .map(heading);
    let mut table = CsvFile::create(target, &headings.collect::<Vec<_>>())?;
    for each in &found.each {
        let numbers = report
            .numbers()
            .map(|at| each.of[at.column][at.number] * at.in_file);
        let texts: Vec<String> = numbers.map(|number| format!("{number}")).collect();
        let changed = report.changed(each.change);
        table.record(
            [changed.as_str()]
                .into_iter()
                .chain(texts.iter().map(String::as_str)),
        )?;
    }
    table.finish()?;
    if let Target::File(path) = target {
        announce(std::slice::from_ref(path));
    }
    Ok(())
}

const NOTES: &str = "\
Of each quantity at the design position, and of its derivative with respect to each drive (bump steer is that of toe),
the hardpoint coordinates and link lengths that change it most, per mm (per inch in a file in inches).

A hardpoint is moved alone, the suspension is built of its points and read at its own design position, as a drawing is
changed. A link's length is changed with the chassis points and the drives held, as a turnbuckle does. Each
number is a difference of sixth order over thousandths of the suspension's size, good to about nine digits.

The CSV file has a row for each coordinate and length and a column for each number, per unit of length of the file, in that
unit and that of its angles: camber_rad, camber_rad_per_bump.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 the design does not assemble, 130 interrupted.

Example:
  suspension sensitivities examples/double_wishbone.toml --of toe --of camber";
