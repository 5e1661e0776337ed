//! The listings that a listing may include: those of the catalogue, and files.

use std::fs::read_to_string;
use std::path::PathBuf;

use suspension_core::linkages::LISTINGS;
use suspension_listing::library::{Library, Wanted};

/// The listings of the catalogue, and the files beside one.
#[derive(Clone, Debug, Default)]
pub struct Shelf {
    /// The file of the listing that is read, where it is in one.
    file: Option<PathBuf>,
}

impl Shelf {
    /// With the files beside one.
    pub fn beside(file: impl Into<PathBuf>) -> Self {
        Self {
            file: Some(file.into()),
        }
    }
}

impl Library for Shelf {
    fn text(&self, wanted: Wanted<'_>) -> Result<String, String> {
        match wanted {
            Wanted::OfCatalogue(name) => {
                let mut listings = LISTINGS.iter();
                let listing = listings.find(|(known, _)| *known == name);
                listing.map(|(_, text)| (*text).to_owned()).ok_or_else(|| {
                    let known: Vec<&str> = LISTINGS.iter().map(|(known, _)| *known).collect();
                    let known = known.join(", ");
                    format!(
                        "unknown linkage `{name}`; known are {known}; a file of your own stands in quotes, \"{name}.linkage\""
                    )
                })
            }
            Wanted::File(path) => {
                let Some(file) = &self.file else {
                    return Err(
                        "this listing is not from a file, so that none can be beside it; include one of the catalogue"
                            .to_owned(),
                    );
                };
                let path = file.with_file_name(path);
                // What is read from elsewhere may never end.
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
