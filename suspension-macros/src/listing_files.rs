//! The files of listings beside a source file.

use std::cell::RefCell;
use std::fmt::Display;
use std::fs::read_to_string;
use std::path::{Path, PathBuf};

use proc_macro2::{Span, TokenStream};
use quote::quote;

use suspension_listing::include::{IncludeSource, Wanted};

/// The files in the folder of a source file, with a record of which were read.
pub(crate) struct ListingFiles {
    /// The source file, if the compiler tells it.
    source: Option<PathBuf>,
    /// The path of the listing's file, relative to the source file's folder; empty for a listing in braces.
    listing: PathBuf,
    read: RefCell<Vec<PathBuf>>,
}

impl ListingFiles {
    /// The files in the folder of a token's source file, for a listing in the file `listing` there, or in braces.
    pub(crate) fn new(token: Span, listing: &str) -> Self {
        Self {
            source: token.local_file(),
            listing: listing.into(),
            read: RefCell::default(),
        }
    }

    /// The text of the listing.
    pub(crate) fn listing(&self) -> Result<String, String> {
        self.file(&self.listing)
    }

    fn file(&self, path: &Path) -> Result<String, String> {
        let Some(source) = &self.source else {
            return Err(
                "the compiler does not say where this source file is; write the statements in braces".to_owned(),
            );
        };
        let place = source.with_file_name(path);
        let refused = |cause: &dyn Display| {
            let path = path.display();
            format!("cannot read `{path}`, from the folder of this source file: {cause}")
        };
        // Reading from anything but a file may never end, and the compiler with it.
        if place.metadata().is_ok_and(|found| !found.is_file()) {
            return Err(refused(&"it is no regular file"));
        }
        let text = read_to_string(place).map_err(|cause| refused(&cause))?;
        self.read.borrow_mut().push(path.to_owned());
        Ok(text)
    }

    /// Code that makes the compiler look at the files again when they have changed.
    pub(crate) fn watched(&self) -> TokenStream {
        let mut paths = self.read.borrow().clone();
        paths.sort();
        paths.dedup();
        let paths = paths.iter().map(|path| path.to_string_lossy().into_owned());
        quote!(#(const _: &str = include_str!(#paths);)*)
    }
}

impl IncludeSource for ListingFiles {
    fn text(&self, wanted: Wanted<'_>) -> Result<String, String> {
        match wanted {
            Wanted::File(path) => self.file(&self.listing.with_file_name(path)),
            Wanted::OfCatalogue(name) => Err(format!(
                "the macro includes files: `suspension list {name} > {name}.linkage` copies a layout of the catalogue, \
                 then write \"{name}.linkage\""
            )),
        }
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn a_listing_path_that_is_no_regular_file_is_refused_at_once() {
        let files = ListingFiles {
            source: Some("src/lib.rs".into()),
            listing: "/dev/null".into(),
            read: RefCell::default(),
        };
        let expected =
            "cannot read `/dev/null`, from the folder of this source file: it is no regular file";
        assert_eq!(files.listing(), Err(expected.to_owned()));
        let included = files.text(Wanted::File(Path::new("/dev/zero")));
        assert!(included.is_err_and(|message| message.ends_with("it is no regular file")));
    }
}
