//! What stands around the statements of a listing: the module that they become.

use proc_macro2::TokenStream;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Ident, Token, Visibility, braced};

use suspension_listing::Listing;
use suspension_listing::errors::{self, Errors};
use suspension_listing::parse;

/// `docs vis mod name { statements }`, without the statements.
pub(crate) struct Module {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) vis: Visibility,
    pub(crate) name: Ident,
}

/// Reads a module, its listing, and the errors of the statements that could not be read.
pub(crate) fn parse(tokens: TokenStream) -> syn::Result<(Module, Listing, Errors)> {
    parse_module.parse2(tokens)
}

fn parse_module(input: ParseStream<'_>) -> syn::Result<(Module, Listing, Errors)> {
    let attributes = input.call(Attribute::parse_outer)?;
    let vis = input.parse()?;
    input.parse::<Token![mod]>()?;
    let name: Ident = input.parse()?;
    let content;
    braced!(content in input);
    let (listing, mut errors) = parse::statements(&content, name.span())?;
    if !input.is_empty() {
        errors.push(errors::behind_the_listing(input.span()));
        input.parse::<TokenStream>()?;
    }
    let module = Module {
        attributes,
        vis,
        name,
    };
    Ok((module, listing, errors))
}
