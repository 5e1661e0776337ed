//! Names as plain text, which can be sent between threads and kept.

use std::fmt;

use proc_macro2::{Span, TokenStream};
use quote::{IdentFragment, ToTokens};
use syn::Ident;
use syn::ext::IdentExt;

/// A word that Rust reserves from its edition of 2024 on; syn accepts it as a name.
pub const KEYWORD_OF_2024: &str = "gen";

/// A name that a listing states, or one made of such names.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Name {
    text: String,
    /// Whether Rust requires `r#` before it.
    raw: bool,
}

/// A name with its docs, one string per line.
#[derive(Clone, Debug)]
pub struct Named {
    pub name: Name,
    pub docs: Vec<String>,
}

impl Name {
    /// A name made from others; it has an underscore, which no keyword has.
    pub fn made(text: String) -> Self {
        Self { text, raw: false }
    }

    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// The identifier at a place of the source.
    pub fn at(&self, span: Span) -> Ident {
        if self.raw {
            Ident::new_raw(&self.text, span)
        } else {
            Ident::new(&self.text, span)
        }
    }
}

impl From<&Ident> for Name {
    fn from(ident: &Ident) -> Self {
        let text = ident.unraw().to_string();
        // These four cannot be raw identifiers, which the compiler reports at their place in its source.
        let never_raw = ["self", "Self", "super", "crate"].contains(&text.as_str());
        let raw = *ident != text && !never_raw;
        Self { text, raw }
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl ToTokens for Name {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.at(Span::call_site()).to_tokens(tokens);
    }
}

impl IdentFragment for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}
