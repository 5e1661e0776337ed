//! `suspension import`: from an engineer's hardpoints to a motion file.

mod choice;
mod corner;
mod draft;
mod format;
mod hardpoints;
mod names;
mod orientation;
mod remarks;
mod row;
mod shark;
mod stand_in;
mod subsystem;
mod table;

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::failure::Failure;
use crate::file::Source;
use crate::load::load;
use crate::mechanism::{self, Axes, Length};
use crate::output::files::{announce, print, refuse_input, write_file};
use choice::choose;
use corner::Corner;
use draft::{Draft, Imported};
use hardpoints::{Hardpoints, Side};
use names::Names;
use orientation::orientation;

/// What `suspension import` is given.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The file of hardpoints.
    #[arg(required_unless_present = "names")]
    file: Option<PathBuf>,
    /// Print the names by which points are known, of each layout of the catalogue.
    #[arg(long)]
    names: bool,
    /// The layout; without it the one of the catalogue that takes most of the points, and lacks none.
    #[arg(long, value_name = "NAME")]
    linkage: Option<String>,
    /// The unit of lengths: m, mm or in; without it what the file says, or else what its size says.
    #[arg(long, value_name = "UNIT", value_parser = unit)]
    unit: Option<Length>,
    /// The axes; without it those that the points have.
    #[arg(long, value_parser = axes())]
    axes: Option<Axes>,
    /// The corner that is wanted, mirrored where the file has the other alone.
    #[arg(long)]
    side: Option<Side>,
    /// Write the motion file to PATH; without it beside FILE, with the ending .toml, where there is none yet.
    #[arg(short, long, value_name = "PATH")]
    out: Option<PathBuf>,
}

fn unit(word: &str) -> Result<Length, String> {
    row::unit(word).ok_or_else(|| "write m, mm or in".to_owned())
}

fn axes() -> impl TypedValueParser<Value = Axes> {
    let options = Axes::ALL.map(|axes| PossibleValue::new(axes.option()).help(axes.in_words()));
    PossibleValuesParser::new(options).map(|word| {
        let named = Axes::ALL.into_iter().find(|axes| axes.option() == word);
        named.unwrap_or_default()
    })
}

impl Arguments {
    /// Writes the motion file.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] where the file is wrong or not enough, or the suspension cannot be built of it.
    pub fn run(self) -> Result<(), Failure> {
        let names = Names::read()?;
        let Some(file) = self.file.as_ref().filter(|_| !self.names) else {
            let known = choice::known_names(&names);
            return print(&known.map_err(|mistakes| Failure::Input(mistakes.to_string()))?);
        };
        let source = Source::read(file)?;
        let stated = format::read(&source, &names)?;
        let out = self.out.clone();
        let out = out.unwrap_or_else(|| file.with_extension("toml"));
        refuse_input(&out, file, "--out")?;
        if self.out.is_none() && out.exists() {
            let out = out.display();
            let message = format!("{out}: exists already; --out {out} replaces it");
            return Err(Failure::Input(message));
        }
        let text = self.import(&stated, &out.display().to_string(), &names)?;
        write_file(&out, &text)?;
        announce(&[out]);
        Ok(())
    }

    /// The text of the motion file that is to be called `out`.
    fn import(&self, stated: &Hardpoints<'_>, out: &str, names: &Names) -> Result<String, Failure> {
        let source = stated.source;
        let refuse = |message: String| Failure::Input(format!("{}: {message}", source.name()));
        let points = stated.of_side(self.side)?;
        let choice = choose(stated, &points, names, self.linkage.as_deref()).map_err(refuse)?;
        let found = orientation(&choice, &names.order, self.axes, stated.usual);
        let found = found.map_err(refuse)?;
        let corner = Corner::of(&choice, found.axes, self.side).map_err(refuse)?;
        let draft = Draft::of(&Imported {
            stated,
            names,
            points: &points,
            choice: &choice,
            orientation: &found,
            corner: &corner,
            unit: self.unit,
        });
        for remark in &draft.remarks {
            eprintln!("note: {}: {remark}", source.name());
        }
        // The drives' values at the design position are those of the mechanism.
        let unmoved = Source::new(out, draft.text(&vec![0.0; draft.drives()]));
        let loaded = load(&unmoved)?;
        let mechanism = loaded.at_design()?;
        note_spin_axis(&mechanism.names);
        Ok(draft.text(&mechanism.design))
    }
}

/// Says which line stands in for the spin axis where that is of two points of the hardpoint file.
fn note_spin_axis(names: &mechanism::Names) {
    if let Some([inner, centre]) = names.wheels.first().map(|wheel| wheel.points.axis)
        && inner < names.chassis + names.free
    {
        let [inner, centre] = [inner, centre].map(|point| &names.points[point]);
        eprintln!(
            "note: camber and toe are those of the line from {inner} to {centre} in this layout"
        );
    }
}

const NOTES: &str = "\
Reads, by what is in the file:

  tables of points      a name and x, y, z a line, between commas, semicolons, tabs or blanks; headings and
                        remarks may stand anywhere, as may reports of Lotus Suspension Analysis
  Adams/Car             subsystem files (.sub); names may have hpl_, hpr_ or hps_ before them
  Lotus                 model files (.shk) of one suspension

A table may also have, a line each, toe_angle and camber_angle in degrees (positive: toe-in, top outboard) and
tire_radius. Beside each point the motion file has the line that the point came from. The program prints its assumptions on
standard error and writes them at the top of the motion file. A point that hardpoint files do not have, as a second point
of the spin axis, is placed by the others, and the motion file says how.

Axes, all right-handed: iso x forward, y left, z up; adams x rearward, y right, z up (of Lotus too); sae x forward,
y right, z down. The motion file is in iso and in the unit of the file.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, or a suspension cannot be built of it.

Example:
  suspension import front.sub
  suspension sheet front.toml";
