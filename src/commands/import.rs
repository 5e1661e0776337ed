//! `suspension import`: from an engineer's hardpoints to a motion file.

mod contact;
mod corner_points;
mod corner_words;
#[cfg(test)]
mod damaged_tables;
mod format;
mod hardpoint_corners;
mod hardpoints;
mod help;
mod imported_corner;
mod known_names;
mod layout;
mod layout_choice;
mod length_units;
mod listed;
mod motion_file;
mod names;
mod orientation;
mod other_side;
mod rack;
mod remarks;
mod spelling;
mod stand_in;
mod upper_wishbone;

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::failure::Failure;
use crate::file::Source;
use crate::mechanism::{Axes, Length};
use crate::output::files::{announce, print, refuse_existing, refuse_input};
use crate::output::target::Target;
use crate::vehicle_corner::{End, Side};
use corner_points::CornerPoints;
use hardpoints::Hardpoints;
use help::NOTES;
use imported_corner::ImportedCorner;
use layout_choice::choose;
use motion_file::{write_axle, write_corner};
use names::Names;
use orientation::orientation;
use other_side::OtherSide;

/// The arguments of `suspension import`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The file of hardpoints.
    #[arg(required_unless_present = "names")]
    file: Option<PathBuf>,
    /// Print the points of each layout of the catalogue, and the names and words that import knows for them.
    #[arg(long)]
    names: bool,
    /// The layout. Without it the layout of the catalogue that uses most of the points and lacks none.
    #[arg(long, value_name = "NAME")]
    linkage: Option<String>,
    /// The unit of lengths: m, mm or in. Without it the unit that the file states, or else the one that its size suggests.
    #[arg(long, value_name = "UNIT", value_parser = unit)]
    unit: Option<Length>,
    /// The axes. Without it the axes that the points suggest.
    #[arg(long, ignore_case = true, value_parser = axes())]
    axes: Option<Axes>,
    /// The corner to import, mirrored if the file has only the other one.
    #[arg(long)]
    side: Option<Side>,
    /// Make an axle of both corners, on one rack if they are steered. If the file has only one corner, its mirror image is
    /// the other.
    #[arg(long, conflicts_with = "side")]
    axle: bool,
    /// The axle to import. Headings such as `Rear suspension`, codes such as RL, or names say which points are of which axle;
    /// others are of both.
    #[arg(long)]
    end: Option<End>,
    /// Write the motion file to PATH, replacing a file of that name. For an axle, NAME_corner.linkage goes beside it; a
    /// different file of that name is never replaced. Without it the motion file is FILE with the ending .toml, or with
    /// _front.toml or _rear.toml for --end; it must not exist yet.
    #[arg(short, long, value_name = "PATH")]
    out: Option<PathBuf>,
}

fn unit(word: &str) -> Result<Length, String> {
    length_units::unit(word).ok_or_else(|| "write m, mm or in".to_owned())
}

fn axes() -> impl TypedValueParser<Value = Axes> {
    let options = Axes::ALL.map(|axes| PossibleValue::new(axes.option()).help(axes.in_words()));
    PossibleValuesParser::new(options).map(|word| {
        let mut all = Axes::ALL.into_iter();
        let named = all.find(|axes| axes.option().eq_ignore_ascii_case(&word));
        named.unwrap_or_default()
    })
}

impl Arguments {
    /// Writes the motion file.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the file is wrong or incomplete, or the suspension cannot be built from it.
    pub fn run(self) -> Result<(), Failure> {
        let names = Names::read()?;
        let Some(file) = self.file.as_ref().filter(|_| !self.names) else {
            return print(&known_names::known_names(&names));
        };
        let source = with_line_ends(Source::read(file)?);
        let stated = self.of_axle(format::read(&source, &names)?, &names)?;
        let out = self.out.clone();
        let out = out.unwrap_or_else(|| self.usual_place(file));
        self.check_place(&out)?;
        let mut one = self.corner(&stated, &names, self.first_side())?;
        let other = one.other_side();
        let is_unlike = matches!(other, OtherSide::Unlike(_)) && self.side.is_none();
        if self.side.is_none() {
            one.notes.extend(other.side_note(self.axle));
        }
        let written = match self.axle || is_unlike {
            true => write_axle([&one, &self.right_corner(&one)?], &out)?,
            false => write_corner(&one, &out)?,
        };
        announce(&written);
        Ok(())
    }

    /// Returns where the motion file goes if `--out` does not say: beside the file.
    fn usual_place(&self, file: &Path) -> PathBuf {
        let mut name = file.file_stem().unwrap_or_default().to_os_string();
        if let Some(end) = self.end {
            name.push(format!("_{}", end.name()));
        }
        name.push(".toml");
        file.with_file_name(name)
    }

    /// Refuses standard output, to overwrite the file that is read, and any other file unless `--out` names it.
    fn check_place(&self, out: &Path) -> Result<(), Failure> {
        if Target::from(out.to_owned()) == Target::Stdout {
            let message = "--out: import does not write to standard output, since an axle is two files; state the path of a file";
            return Err(Failure::Input(message.to_owned()));
        }
        refuse_input(out, "--out")?;
        match self.out {
            None => refuse_existing(out, out),
            Some(_) => Ok(()),
        }
    }

    /// Returns the side of the corner that is imported, or that is first: the left one of an axle.
    fn first_side(&self) -> Option<Side> {
        self.axle.then_some(Side::Left).or(self.side)
    }

    /// Reads the points of a corner from the file.
    fn corner<'a>(
        &self,
        stated: &'a Hardpoints<'a>,
        names: &'a Names,
        side: Option<Side>,
    ) -> Result<ImportedCorner<'a>, Failure> {
        let refuse = |message: String| Failure::input(stated.source.name(), message);
        let points = stated.of_side(side)?;
        let choice = choose(stated, &points, names, self.linkage.as_deref()).map_err(refuse)?;
        if self.axle && choice.point("wheel_centre").is_none() {
            let linkage = choice.linkage();
            return Err(refuse(format!(
                "--axle is for corners; {linkage} has both sides"
            )));
        }
        let found = orientation(&choice, &names.arrangement, self.axes, stated.usual);
        let orientation = found.map_err(refuse)?;
        let corner = CornerPoints::new(&choice, orientation.axes, side).map_err(refuse)?;
        let imported = ImportedCorner {
            stated,
            names,
            points,
            choice,
            orientation,
            corner,
            unit: self.unit,
            notes: Vec::new(),
        };
        imported.check_unit().map_err(refuse)?;
        if self.side.is_none() {
            imported.check_side().map_err(refuse)?;
        }
        Ok(imported)
    }

    /// Returns the right corner, in the layout, axes and unit of the left one.
    fn right_corner<'a>(&self, left: &ImportedCorner<'a>) -> Result<ImportedCorner<'a>, Failure> {
        let as_left = Self {
            linkage: Some(left.choice.linkage().to_owned()),
            axes: Some(left.orientation.axes),
            unit: Some(left.unit().0),
            ..self.clone()
        };
        as_left.corner(left.stated, left.names, Some(Side::Right))
    }
}

/// Returns the file with line feeds at the ends of lines if it has only carriage returns, as spreadsheets on a Mac write it.
fn with_line_ends(source: Source) -> Source {
    if source.text().contains('\n') {
        return source;
    }
    Source::new(source.name(), source.text().replace('\r', "\n"))
}
