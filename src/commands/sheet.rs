//! `suspension sheet`: the kinematics of a suspension on one page.

mod charts;
mod page;
mod parameters;

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::atomic::AtomicBool;

use clap::Args;
use suspension_core::DriveKind;
use suspension_runtime::Listing;

use crate::failure::Failure;
use crate::file::Source;
use crate::load::load;
use crate::mechanism::{From, Grid, Mechanism, Order, State, Suspension, Visited, Work};
use crate::output::drawing::drawing_of;
use crate::output::files::{announce, refuse_input, write_file};
use page::Page;

/// What `suspension sheet` is given.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// The travel, from the design position, in the file's unit; without it 60 mm down and up.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    travel: Option<Span>,
    /// The same of the drive that steers; without it 30 mm to either side.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    steer: Option<Span>,
    /// Write the page to PATH; without it to out/NAME_sheet.html, NAME being that of the motion file.
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
}

/// From where to where, as `-0.06:0.06`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Span([f64; 2]);

impl FromStr for Span {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse().ok().filter(|x: &f64| x.is_finite());
        let ends = text.split_once(':');
        let ends = ends.and_then(|(from, to)| Some([number(from)?, number(to)?]));
        match ends {
            Some([from, to]) if from < to => Ok(Self([from, to])),
            _ => Err("write FROM:TO, as -0.06:0.06".to_owned()),
        }
    }
}

/// Places of each curve.
const PLACES: usize = 61;

impl Arguments {
    /// Writes the page.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. Where the mechanism locks, the curves end there, and the page is written.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let stem = self.file.file_stem().unwrap_or_default().to_string_lossy();
        let beside = || Path::new("out").join(format!("{stem}_sheet.html"));
        let out = self.out.clone().unwrap_or_else(beside);
        refuse_input(&out, &self.file, "--out")?;
        let source = Source::read(&self.file)?;
        let loaded = load(&source)?;
        let (page, missing) = loaded.run_at_design(Sheet {
            source: &source,
            listing: loaded.listing(),
            arguments: &self,
            interrupted,
        })?;
        write_file(&out, &page)?;
        announce(&[out]);
        missing.map_or(Ok(()), Err)
    }
}

struct Sheet<'a> {
    source: &'a Source,
    listing: &'a Listing,
    arguments: &'a Arguments,
    interrupted: &'a AtomicBool,
}

/// The states along one drive.
struct Along {
    drive: usize,
    /// The drive's changes from the design position.
    changes: Vec<f64>,
    /// Each state, and the same with derivatives with respect to the drive.
    visited: Visited<(State, Option<State>)>,
}

impl Work for Sheet<'_> {
    /// The page, and what could not be solved.
    type Answer = (String, Option<Failure>);

    fn on<L: Suspension<N>, const N: usize>(
        self,
        mechanism: &Mechanism<L, N>,
    ) -> Result<Self::Answer, Failure> {
        let Mechanism { names, .. } = mechanism;
        let Some(travel) = names.vehicle.travel else {
            let known = names.of_drives().join(", ");
            return Err(Failure::Input(format!(
                "{}: which drive moves the wheel up and down? Write [vehicle] with travel = \"NAME\"; the drives are {known}",
                self.source.name()
            )));
        };
        let Arguments {
            travel: span,
            steer,
            ..
        } = self.arguments;
        let along_travel = self.along(mechanism, travel, *span, 0.06);
        let along_steer = names.vehicle.steer;
        let along_steer = along_steer.map(|drive| self.along(mechanism, drive, *steer, 0.03));
        let ways: Vec<&Along> = [&along_travel].into_iter().chain(&along_steer).collect();
        let failures = ways.iter();
        let failures = failures.filter_map(|along| along.visited.failure(self.source.name()));
        let failures: Vec<Failure> = failures.collect();
        let page = Page {
            file: self.source.name(),
            mechanism,
            drawing: drawing_of(mechanism, self.listing, None).svg(),
            drives: drives_in_words(mechanism),
            missing: failures.iter().map(Failure::to_string).collect(),
            parameters: parameters::parameters(mechanism, self.interrupted),
            charts: ways
                .iter()
                .map(|along| charts::charts(mechanism, along))
                .collect(),
        };
        Ok((page.html(), failures.into_iter().next()))
    }
}

impl Sheet<'_> {
    /// Along a drive; without a span so many metres, or a fifth of a radian, either way.
    fn along<L: Suspension<N>, const N: usize>(
        &self,
        mechanism: &Mechanism<L, N>,
        drive: usize,
        span: Option<Span>,
        metres: f64,
    ) -> Along {
        let usual = match mechanism.names.drives[drive].kind {
            DriveKind::Coordinate => metres * mechanism.unit.metre(),
            DriveKind::Angle => 0.2,
        };
        let Span([from, to]) = span.unwrap_or(Span([-usual, usual]));
        let part = |place: usize| place as f64 / (PLACES - 1) as f64;
        let changes: Vec<f64> = (0..PLACES)
            .map(|place| from * (1.0 - part(place)) + to * part(place))
            .collect();
        let axes = vec![(drive, changes.clone())];
        let grid = Grid::new(mechanism, axes, From::Start);
        // So few places are never too many.
        let grid = grid.unwrap_or_default();
        let mut read =
            |state: &State, per: &dyn Fn(usize) -> Option<State>| (state.clone(), per(drive));
        Along {
            drive,
            changes,
            visited: mechanism.visit(&grid, Order::First, self.interrupted, &mut read),
        }
    }
}

/// The drives where the mechanism starts.
fn drives_in_words<L: Suspension<N>, const N: usize>(mechanism: &Mechanism<L, N>) -> String {
    let [first, _] = mechanism.instants.ends();
    let drives = mechanism.drives.inputs::<L::Drives>(first).drives.value;
    let given = mechanism.given(&drives);
    mechanism
        .names
        .drives_in_words(&given, mechanism.unit, None)
}

const NOTES: &str = "\
One HTML page without anything from elsewhere, which any browser shows and prints: a drawing at the design
position, that of the file's points, all quantities there with their derivatives with respect to travel and steering, curves over travel and steering, and the
definitions. The file's [vehicle] table says what the listing does not:

  [vehicle]
  wheel_radius = 0.3      # in the unit; without it there is nothing that needs the ground
  travel = \"bump\"         # the drive that moves the wheel up and down; without a word the one named
  steer = \"steer\"         # bump, and the one that steers it: the one named steer

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 the mechanism locks within the travel (the page is
written), 130 interrupted.

Example:
  suspension sheet examples/double_wishbone.toml --travel -0.08:0.08";
