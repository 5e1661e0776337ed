//! Listings that another one includes.

mod included;
mod source;

use std::path::{Path, PathBuf};

use proc_macro2::{Span, TokenStream};
use syn::{Error, Ident, LitStr};

use crate::vector::Vector;

pub(crate) use included::{Included, mistakes};
pub use source::{IncludeSource, NoIncludes, Wanted};

/// Another listing, and the name that is put before its own names.
pub(crate) struct Include {
    pub(crate) name: Ident,
    pub(crate) source: Source,
    /// The displacement of its positions.
    pub(crate) at: Option<Vector>,
}

/// The source of an included listing.
pub(crate) enum Source {
    OfCatalogue(Ident),
    File(LitStr),
}

impl Source {
    /// Its name in messages.
    pub(crate) fn name(&self) -> String {
        match self {
            Self::OfCatalogue(name) => name.to_string(),
            Self::File(path) => path.value(),
        }
    }

    fn span(&self) -> Span {
        match self {
            Self::OfCatalogue(name) => name.span(),
            Self::File(path) => path.span(),
        }
    }

    /// The path of the file, relative to the folder of the text that is read, if it is named in a text at `from`;
    /// empty for a listing of the catalogue.
    pub(crate) fn path(&self, from: &Path) -> PathBuf {
        match self {
            Self::OfCatalogue(_) => PathBuf::new(),
            Self::File(path) => from.with_file_name(path.value()),
        }
    }

    pub(crate) fn wanted<'a>(&self, name: &'a str, path: &'a Path) -> Wanted<'a> {
        match self {
            Self::OfCatalogue(_) => Wanted::OfCatalogue(name),
            Self::File(_) => Wanted::File(path),
        }
    }
}

impl Include {
    /// The error that there is nothing to include.
    pub(crate) fn refused(&self, message: String) -> Error {
        Error::new(self.source.span(), message)
    }

    /// The included text, with its `tokens`.
    pub(crate) fn included(&self, text: String, tokens: Option<&TokenStream>) -> Included {
        Included::new(self.source.name(), self.source.span(), text, tokens)
    }
}
