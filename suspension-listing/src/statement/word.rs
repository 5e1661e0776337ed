//! The first words of statements.

use syn::Ident;
use syn::parse::ParseStream;

use super::operands;
use crate::listing::{Listing, Named};

/// The word that begins a statement, and the function that reads the rest.
pub(crate) struct Word {
    pub(crate) word: &'static str,
    /// An example.
    pub(crate) syntax: &'static str,
    /// Reads what follows the first word, to the semicolon, into a listing.
    pub(crate) read: fn(Head, ParseStream<'_>, &mut Listing) -> syn::Result<()>,
}

/// The beginning of a statement.
pub(crate) struct Head {
    pub(crate) docs: Vec<String>,
    pub(crate) word: Ident,
}

impl Head {
    /// `name:` after the first word.
    pub(super) fn named(self, input: ParseStream<'_>) -> syn::Result<Named> {
        let name = operands::name(input)?;
        input.parse::<syn::Token![:]>()?;
        Ok(Named {
            docs: self.docs,
            name,
        })
    }
}
