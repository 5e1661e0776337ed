//! The source of the texts of included listings.

use std::path::Path;

/// A listing that another includes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted<'a> {
    /// A listing of the catalogue, by its name.
    OfCatalogue(&'a str),
    /// A file, by its path relative to the folder of the text that is read.
    File(&'a Path),
}

/// A source of the texts of included listings.
pub trait IncludeSource {
    /// The text of a listing.
    ///
    /// # Errors
    ///
    /// A sentence that says why there is no such text.
    fn text(&self, wanted: Wanted<'_>) -> Result<String, String>;
}

/// A source without listings: a listing that is read with it cannot include others.
#[derive(Clone, Copy, Debug)]
pub struct NoIncludes;

impl IncludeSource for NoIncludes {
    fn text(&self, _: Wanted<'_>) -> Result<String, String> {
        Err("no other listing can be read from here; write its statements instead".to_owned())
    }
}
