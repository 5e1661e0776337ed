//! The source of the texts of included listings.

use std::path::Path;

/// A listing that another includes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted<'a> {
    /// One of the catalogue, by its name.
    OfCatalogue(&'a str),
    /// A file, by its path from the folder of the text that is read.
    File(&'a Path),
}

/// Where the texts of included listings come from.
pub trait IncludeSource {
    /// The text of a listing.
    ///
    /// # Errors
    ///
    /// A sentence that says why there is none.
    fn text(&self, wanted: Wanted<'_>) -> Result<String, String>;
}

/// None: a listing that is read so includes no other.
#[derive(Clone, Copy, Debug)]
pub struct NoIncludes;

impl IncludeSource for NoIncludes {
    fn text(&self, _: Wanted<'_>) -> Result<String, String> {
        Err("no other listing can be read from here; write its statements instead".to_owned())
    }
}
