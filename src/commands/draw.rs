//! `suspension draw`: a picture of the mechanism at its first instant, or at its design position if that instant is out of reach.

use std::path::PathBuf;

use clap::Args;

use crate::failure::Failure;
use crate::file::Source;
use crate::option_numbers::positive;
use crate::output::default_path::target;
use crate::output::drawing::drawing_of;
use crate::output::files::announce;
use crate::output::notes::with_notes_printed;
use crate::prepare::load;

/// The arguments of `suspension draw`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML), see suspension motion --help.
    file: PathBuf,
    /// Write the SVG to PATH, or to standard output for `-`. Without it the SVG goes to out/NAME.svg, where NAME is the
    /// motion file's name.
    #[arg(short, long, value_name = "PATH")]
    out: Option<PathBuf>,
    /// The wheel radius, in the unit of the file. Without it the file's wheel_radius is used, or else 0.3 m.
    #[arg(
        long,
        value_name = "LENGTH",
        allow_negative_numbers = true,
        value_parser = positive("LENGTH is a positive number in the unit of the file, as 0.3")
    )]
    wheel_radius: Option<f64>,
}

impl Arguments {
    /// Draws the mechanism into an SVG file.
    ///
    /// # Errors
    ///
    /// See [`Failure`].
    pub fn run(self) -> Result<(), Failure> {
        let out = target(self.out.as_deref(), &self.file, ".svg");
        let source = Source::read(&self.file)?;
        let loaded = load(&source)?;
        out.refuse_input("--out")?;
        let mechanism = with_notes_printed(loaded.within_reach()?);
        let drawing = drawing_of(&*mechanism, loaded.listing(), self.wheel_radius);
        out.write(&drawing.whole(source.name())?)?;
        announce(out.path());
        Ok(())
    }
}

const NOTES: &str = "\
The legend names what is drawn. A rack is the line between the outermost points that the drive of steering alone moves, all
equally and straight; a corner has only one of them, from which a short part of the rack is drawn. A bar is drawn where the
listing measures an angle about it, with the arms that begin at its ends, as
`measure bar_twist: angle(right_outer -> right_drop, left_outer -> left_drop about right_outer -> left_outer);`.

Exit codes: 0 done, 1 the drawing cannot be written, 2 wrong input, 3 the mechanism does not assemble.

Example:
  suspension draw examples/macpherson.toml";
