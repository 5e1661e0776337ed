//! The motion file that an import writes.

mod axle;
mod checked_text;
mod draft;
mod vehicle;

use std::path::{Path, PathBuf};

use suspension_runtime::Listing;

use super::imported_corner::ImportedCorner;
use crate::failure::Failure;
use crate::output::files::write_file;
use axle::Axle;
use checked_text::checked_text;
use draft::Draft;

/// Writes the motion file of a corner; returns its path.
pub(super) fn write_corner(
    corner: &ImportedCorner<'_>,
    out: &Path,
) -> Result<Vec<PathBuf>, Failure> {
    let choice = &corner.choice;
    let listing = Listing::parse_file(&choice.text, choice.linkage());
    let listing = listing.map_err(|mistakes| Failure::Input(mistakes.to_string()))?;
    let text = checked_text(&Draft::for_corner(corner, &listing), out)?;
    write_file(out, &text)?;
    Ok(vec![out.to_owned()])
}

/// Writes the motion file of an axle, and the listing that it includes; returns their paths. The left corner is the first.
pub(super) fn write_axle(
    corners: [&ImportedCorner<'_>; 2],
    out: &Path,
) -> Result<Vec<PathBuf>, Failure> {
    let axle = Axle::new(&corners[0].choice, out);
    axle.check_corner(out)?;
    axle.write(out, |listing| {
        checked_text(&Draft::for_axle(corners, &axle, listing), out)
    })
}
