//! `suspension list`: the catalogue of layouts, and the listing of a layout or of a motion file.

use std::fmt::Write;
use std::path::Path;

use clap::Args;
use suspension_core::linkages::LISTINGS;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_runtime::{Listing, catalogue};

use crate::failure::Failure;
use crate::file::Source;
use crate::listing_description::first_sentence;
use crate::mechanism::Axes;
use crate::output::files::print;
use crate::output::notes::with_notes_printed;
use crate::prepare::load;

/// The arguments of `suspension list`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// Print the statements of this layout, or of this motion file (TOML) with its design positions, to copy and change.
    #[arg(value_name = "LAYOUT|FILE")]
    wanted: Option<String>,
}

impl Arguments {
    /// Lists the catalogue, or prints a listing.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the catalogue has no such layout, and the failures of a motion file and of writing.
    pub fn run(self) -> Result<(), Failure> {
        let Some(wanted) = self.wanted else {
            let entries = LISTINGS.iter().map(|(name, text)| entry(name, text));
            return print(&entries.collect::<Result<Vec<_>, _>>()?.join("\n"));
        };
        if let Some(text) = catalogue::listing(&wanted) {
            return print(text);
        }
        let path = Path::new(&wanted);
        if path.extension().is_some() || path.exists() {
            return print(&flat(path)?);
        }
        Err(Failure::Input(catalogue::unknown(
            &wanted,
            "; a motion file is FILE.toml",
        )))
    }
}

/// Returns the listing of a motion file, with a heading that says unit and axes.
fn flat(path: &Path) -> Result<String, Failure> {
    let source = Source::read(path)?;
    let loaded = load(&source)?;
    let mechanism = with_notes_printed(loaded.at_design()?);
    let listing = loaded.flat_listing(&*mechanism)?;
    let (name, unit, axes) = (source.name(), loaded.unit().length, loaded.axes());
    let foreign = match axes {
        Axes::Iso => "",
        _ => {
            "//! The library reads camber, toe and other wheel quantities in the axes of ISO 8855.\n"
        }
    };
    Ok(format!(
        "//! The statements of {name} with its design positions, by suspension list.\n\
         //! Lengths are in {}, axes are {}.\n{foreign}\n{listing}",
        unit.in_words(),
        axes.in_words(),
    ))
}

/// Returns the entry of a layout in the list.
fn entry(name: &str, text: &str) -> Result<String, Failure> {
    let listing = Listing::parse_file(text, name);
    let listing = listing.map_err(|mistakes| Failure::Input(mistakes.to_string()))?;
    let mut entry = format!("{name}\n  {}\n", first_sentence(text));
    let drives = parts(&listing, Kind::Drive, Part::Drive);
    let measures = parts(&listing, Kind::Measure, Part::Measure);
    for (what, names) in [("drives", drives), ("measures", measures)] {
        if !names.is_empty() {
            // Writing into a string cannot fail.
            let _ = writeln!(entry, "  {what:8}  {names}");
        }
    }
    Ok(entry)
}

/// Returns the names of all parts of a kind.
fn parts(listing: &Listing, kind: Kind, part: fn(usize) -> Part) -> String {
    let names = (0..listing.count(kind)).map(|index| listing.name(part(index)));
    names.collect::<Vec<_>>().join(", ")
}

const NOTES: &str = "\
Each layout comes with hardpoints, in metres. A motion file names the layout, linkage = \"macpherson\", and states the points
that differ, or all of them if it is in mm or inches. For other links, copy the statements into a file, change them, and
name that file: listing = \"my.linkage\".

Of a motion file it prints one listing that needs no other file: includes and mirrors are written out, and each point has
its design position, in the unit of the file. The macro linkage! takes this text in Rust, susp_listing_parse in C.

Exit codes: 0 done, 1 the list cannot be written, 2 no layout has the name, or wrong input, 3 the mechanism of the file does
not assemble.

Examples:
  suspension list macpherson > my.linkage
  suspension list front.toml > front.linkage";
