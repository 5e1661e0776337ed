//! `suspension list`: the catalogue of layouts.

use std::fmt::Write;

use clap::Args;
use suspension_core::linkages::LISTINGS;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_runtime::{Listing, catalogue};

use crate::failure::Failure;
use crate::layouts::first_sentence;
use crate::output::files::print;

/// The arguments of `suspension list`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// Print the statements of this layout, to copy and change.
    name: Option<String>,
}

impl Arguments {
    /// Lists the catalogue, or prints a listing of it.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if the catalogue has no such layout, and the failures of writing.
    pub fn run(self) -> Result<(), Failure> {
        let Some(name) = self.name else {
            let entries = LISTINGS.iter().map(|(name, text)| entry(name, text));
            return print(&entries.collect::<Result<Vec<_>, _>>()?.join("\n"));
        };
        match catalogue::listing(&name) {
            Some(text) => print(text),
            None => Err(Failure::Input(catalogue::unknown(&name, ""))),
        }
    }
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
that differ. For other links, copy the statements into a file, change them, and name that file: listing = \"my.linkage\".

Exit codes: 0 done, 1 the list cannot be written, 2 no layout has the name.

Example:
  suspension list macpherson > my.linkage";
