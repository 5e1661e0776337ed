//! `suspension sheet`: the kinematics of a suspension on one page.

mod by_quantity;
mod curves;
mod derivatives;
mod far_apart;
mod over_centre;
mod page;

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use clap::Args;
use suspension_runtime::Listing;

use crate::characteristics::{
    ModeStates, Rise, Rises, Span, all_curves, check_spans, mode_states, no_steering, parameters,
    shorter_roll,
};
use crate::failure::Failure;
use crate::file::Source;
use crate::kinematics::Kinematics;
use crate::mechanism::State;
use crate::output::default_path::target;
use crate::output::drawing::{Drawing, Seen, drawing_of};
use crate::output::files::announce;
use crate::output::notes::{print_notes, print_notes_on, print_unmet_range, with_notes_printed};
use crate::output::pulling;
use crate::prepare::{Loaded, load};
use page::Page;

/// The arguments of `suspension sheet`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// How far the drive that moves the wheel up and down changes from the design position, in the file's unit, upwards: a
    /// positive change raises the wheel, also where the drive itself becomes less, as the length of a damper. If the
    /// drive is a height, this is the wheel travel. Without it 60 mm down and up; 0.2 rad if the drive is an angle; less
    /// where the mechanism locks before. Roll, one wheel up and the other down, goes as far as both FROM and TO allow.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    travel: Option<Span>,
    /// The same for the drive that steers. Without it 30 mm to either side; 0.2 rad if the drive is an angle; less where
    /// the mechanism locks before.
    #[arg(long, value_name = "FROM:TO", allow_hyphen_values = true)]
    steer: Option<Span>,
    /// Write the page to PATH, or to standard output for `-`. Without it the page goes to out/NAME_sheet.html, where NAME
    /// is the motion file's name.
    #[arg(short, long, value_name = "PATH")]
    out: Option<PathBuf>,
}

impl Arguments {
    /// Writes the page.
    ///
    /// # Errors
    ///
    /// See [`Failure`]. If the mechanism locks, the curves end there, and the page is still written.
    pub fn run(self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let out = target(self.out.as_deref(), &self.file, "_sheet.html");
        let source = Source::read(&self.file)?;
        let loaded = load(&source)?;
        out.refuse_input("--out")?;
        let mechanism = with_notes_printed(loaded.at_design()?);
        let motion_ends = loaded.own_motion_ends(interrupted)?;
        print_notes(&motion_ends);
        let (page, missing) = self.page(
            &*mechanism,
            &loaded,
            (source.name(), motion_ends),
            interrupted,
        )?;
        out.write(&page)?;
        announce(out.path());
        missing.map_or(Ok(()), Err)
    }

    /// Returns the page, and the failures of what could not be solved.
    fn page(
        &self,
        mechanism: &dyn Kinematics,
        loaded: &Loaded<'_>,
        (name, motion_ends): (&str, Option<String>),
        interrupted: &AtomicBool,
    ) -> Result<(String, Option<Failure>), Failure> {
        let unit = mechanism.unit;
        if self.steer.is_some() && mechanism.names.vehicle.steer.is_empty() {
            return Err(no_steering(name));
        }
        let spans = [self.travel, self.steer];
        print_notes(check_spans(mechanism, name, spans, unit)?);
        let modes = mode_states(mechanism, spans, unit, interrupted);
        let missing = modes.iter().filter_map(|mode| mode.visited.failure(name));
        let parameters = parameters(mechanism, unit);
        let rises = Rise::of_drives(mechanism, &parameters, unit);
        let curves = all_curves(mechanism, &modes, &rises);
        let notes: Vec<String> = shorter_roll(mechanism, self.travel)
            .into_iter()
            .chain(over_centre::notes(&mechanism.names, &curves, unit))
            .chain(pulling::notes(&parameters))
            .collect();
        print_notes_on(name, &notes);
        let page = Page {
            file: name,
            mechanism,
            points: mechanism.points(),
            drawings: drawings(mechanism, loaded.listing(), &modes),
            drives: mechanism
                .names
                .drives_in_words(&mechanism.design, unit, None),
            motion_ends,
            notes,
            missing: missing.map(|failure| failure.to_string()).collect(),
            curves,
            measures: described_measures(loaded.listing()),
            rises: Rises::compute(mechanism, &parameters),
            parameters,
        };
        Ok((page.html(), print_unmet_range(&modes, name)))
    }
}

/// Returns the names of measures, those that the listing describes in the same words together, each with these words.
fn described_measures(listing: &Listing) -> Vec<[String; 2]> {
    let mut described: Vec<[String; 2]> = Vec::new();
    for (name, text) in listing
        .described_measures()
        .filter(|(_, text)| !text.is_empty())
    {
        match described.iter_mut().find(|[_, other]| *other == text) {
            Some([names, _]) => *names += &format!(", {name}"),
            None => described.push([name.to_owned(), text]),
        }
    }
    described
}

/// Width and height of a drawing in pixels.
const DRAWING: (u32, u32) = (620, 480);

/// Draws the mechanism from all sides, with faint lines at the ends of travel.
fn drawings(mechanism: &dyn Kinematics, listing: &Listing, modes: &[ModeStates]) -> Vec<String> {
    let travel = modes.iter().take(1);
    let reached = travel.flat_map(|mode| mode.visited.places.iter().flatten());
    let states: Vec<&State> = reached.map(|(state, _)| state).collect();
    let ends = [states.first(), states.last()].into_iter().flatten();
    let points = |state: &&State| {
        let points = 0..state.points.value.len();
        points.map(|point| state.position(point)).collect()
    };
    let drawing = Drawing {
        others: ends.map(points).collect(),
        ..drawing_of(mechanism, listing, None)
    };
    let seen = Seen::ALL.into_iter();
    seen.filter_map(|seen| drawing.svg(seen, DRAWING)).collect()
}

const NOTES: &str = "\
One HTML page, complete in itself, which any browser shows and prints. It has drawings at the design position (that of the
file's points) and faintly at both ends of the travel; all quantities at the design position with their definitions; their
derivatives with respect to the drives of travel and steering, among them bump camber, bump steer and motion ratios; curves
over travel, or over heave and roll of an axle, and over steering; and all points. Where a drive of travel is not a height
but, for example, a damper's length or an angle, the page also has derivatives `per wheel travel`, per rise of the wheel
centre with the other wheels held at their heights, and curves over wheel travel; where it is a height that counts
downwards, as z of SAE axes, it has these derivatives too, as those per drive have the opposite sign. The curve of an
instant centre, a swing arm or a roll centre that passes through infinity within the travel, or comes near it, is cut there
or left out, and so is one that is constant throughout and the Ackermann percentage at small steer angles. The page says
which; suspension sweep writes all values. Where the coordinates of several wheels are far apart, as those of y on both
sides, a chart shows their change from the design position. The [vehicle] table of the file (suspension motion --help) names
the drives of travel and steering; it gives the wheel radius, which all quantities at the ground need, and the car's data
for anti-dive.

A browser turns the page into a PDF of a few A4 pages: chromium --headless --print-to-pdf=sheet.pdf out/NAME_sheet.html
or into a picture: chromium --headless --screenshot=sheet.png --window-size=1250,10000 out/NAME_sheet.html (twice as high
for an axle).

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, 3 the mechanism locks within --travel or --steer (the
page is written), 130 interrupted.

Example:
  suspension sheet examples/double_wishbone_pushrod.toml --travel -0.08:0.08";
