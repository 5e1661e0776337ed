//! The listings that a listing may include: those of the catalogue, and files.

use std::fs::read_to_string;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use suspension_listing::include::{IncludeSource, Wanted};
use suspension_listing::text::MOST_BYTES;

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
                read(&path).map_err(|cause| format!("cannot read {}: {cause}", path.display()))
            }
        }
    }
}

/// The text of a file, or why there is none.
fn read(path: &Path) -> Result<String, String> {
    let found = path.metadata().map_err(|error| error.to_string())?;
    // Reading from anything but a file may never end.
    if !found.is_file() {
        return Err("it is no regular file".to_owned());
    }
    let bytes = found.len();
    if bytes > MOST_BYTES as u64 {
        return Err(format!(
            "it is {bytes} bytes long; at most {MOST_BYTES} are allowed"
        ));
    }
    read_to_string(path).map_err(|error| match error.kind() {
        ErrorKind::InvalidData => "it is not text in UTF-8; save it in that encoding".to_owned(),
        _ => error.to_string(),
    })
}
