//! The listings that a listing may include: those of the catalogue, and files.

use std::fs::read_to_string;
use std::path::PathBuf;

use suspension_listing::include::{IncludeSource, Wanted};

use crate::catalogue;

/// The listings of the catalogue, and the files in the folder of one listing.
#[derive(Clone, Debug, Default)]
pub struct CatalogueAndFiles {
    /// The file of the listing that is read, if it is in one.
    file: Option<PathBuf>,
}

impl CatalogueAndFiles {
    /// The catalogue with the files in the folder of this file.
    pub fn beside(file: impl Into<PathBuf>) -> Self {
        Self {
            file: Some(file.into()),
        }
    }
}

impl IncludeSource for CatalogueAndFiles {
    fn text(&self, wanted: Wanted<'_>) -> Result<String, String> {
        match wanted {
            Wanted::OfCatalogue(name) => {
                let besides = format!("; a file of your own stands in quotes, \"{name}.linkage\"");
                let listing = catalogue::listing(name).map(str::to_owned);
                listing.ok_or_else(|| catalogue::unknown(name, &besides))
            }
            Wanted::File(path) => {
                let Some(file) = &self.file else {
                    return Err(
                        "this listing is not from a file, so that none can be beside it; include one of the catalogue"
                            .to_owned(),
                    );
                };
                let path = file.with_file_name(path);
                // Reading from anything but a file may never end.
                if path.metadata().is_ok_and(|found| !found.is_file()) {
                    return Err(format!(
                        "cannot read {}: it is no regular file",
                        path.display()
                    ));
                }
                read_to_string(&path)
                    .map_err(|cause| format!("cannot read {}: {cause}", path.display()))
            }
        }
    }
}
