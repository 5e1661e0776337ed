//! Listings included by the listing of a motion file.

use std::cell::RefCell;
use std::ops::Range;
use std::path::Path;

use suspension_runtime::{CatalogueAndFiles, IncludeSource, Listing, Mistakes, Wanted};

use crate::failure::Failure;
use crate::file::{MotionFile, Source, inputs};
use crate::mechanism::{Axes, Length};
use crate::prepare::listing::points::point_names;

/// The listings that may be included, and the first layout of the catalogue that is.
struct Included<'a> {
    /// The including file.
    by: &'a Path,
    files: CatalogueAndFiles,
    of_catalogue: RefCell<Option<String>>,
}

impl IncludeSource for Included<'_> {
    fn text(&self, wanted: Wanted<'_>) -> Result<String, String> {
        if let Wanted::OfCatalogue(name) = wanted {
            let mut first = self.of_catalogue.borrow_mut();
            first.get_or_insert_with(|| name.to_owned());
        }
        if let Wanted::File(path) = wanted {
            inputs::note(&self.by.with_file_name(path));
        }
        self.files.text(wanted)
    }
}

/// A listing, and the first layout of the catalogue that it includes.
pub(crate) fn parsed(text: &str, file: &str) -> Result<(Listing, Option<String>), Mistakes> {
    let includes = Included {
        by: Path::new(file),
        files: CatalogueAndFiles::beside(file),
        of_catalogue: RefCell::default(),
    };
    let listing = Listing::parse_with(text, file, &includes)?;
    Ok((listing, includes.of_catalogue.into_inner()))
}

/// Checks that the motion file is in metres and in the axes of the catalogue if its listing includes a layout of it,
/// unless the file states all points itself.
pub(crate) fn check_unit(
    source: &Source,
    file: &MotionFile,
    place: Range<usize>,
    (listing, included): &(Listing, Option<String>),
) -> Result<(), Failure> {
    let Some(included) = included else {
        return Ok(());
    };
    let stated = file.points.get_ref();
    let is_as_there = file.length == Length::Metre && file.axes == Axes::Iso;
    if is_as_there || point_names(listing).all(|point| stated.has(point)) {
        return Ok(());
    }
    let message = format!(
        "the listing includes `{included}` of the catalogue, whose hardpoints are in metres and in the axes of ISO 8855; state \
         all points, or unit = \"m\" and no axes, or include a copy with your own: suspension list {included}"
    );
    Err(source.refuse(&place, message))
}
