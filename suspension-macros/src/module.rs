//! The module that the statements of a listing become. They stand in its
//! braces, or in a file.

use proc_macro2::{Span, TokenStream};
use syn::ext::IdentExt as _;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Ident, LitStr, Token, Visibility, braced, bracketed};

use suspension_listing::errors::{self, Errors};
use suspension_listing::name::Name;
use suspension_listing::{Listing, parse};

use crate::listing_files::ListingFiles;

/// `[core] docs vis mod name`.
pub(crate) struct Module {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) vis: Visibility,
    pub(crate) name: Ident,
    pub(crate) source: Source,
    /// The path of `suspension_core` in the scope of the module.
    pub(crate) core: TokenStream,
}

/// The place of the statements.
pub(crate) enum Source {
    /// In the module's braces, and in files that they include.
    Braces(Box<Listing>, ListingFiles),
    /// In a file: `in "path";`, or `;` if the file has the module's name.
    File(LitStr),
}

impl Module {
    /// The place where a name is declared, as far as the compiler can tell.
    pub(crate) fn place_of(&self, name: &Name) -> Span {
        match &self.source {
            Source::Braces(listing, _) => listing.place_of(name, None),
            Source::File(_) => self.name.span(),
        }
    }
}

/// Reads a module, and the errors of statements in its braces that could not be read.
pub(crate) fn parse(tokens: TokenStream) -> syn::Result<(Module, Errors)> {
    parse_module.parse2(tokens)
}

fn parse_module(input: ParseStream<'_>) -> syn::Result<(Module, Errors)> {
    let core;
    bracketed!(core in input);
    let core = core.parse()?;
    let attributes = input.call(Attribute::parse_outer)?;
    let vis = input.parse()?;
    input.parse::<Token![mod]>().map_err(with_example)?;
    let name: Ident = input.parse()?;
    let (source, mut errors) = source(input, &name)?;
    if !input.is_empty() {
        let error = errors::text_after_listing(input.span());
        if let Source::File(_) = source {
            return Err(error);
        }
        errors.push(error);
        input.parse::<TokenStream>()?;
    }
    let module = Module {
        attributes,
        vis,
        name,
        source,
        core,
    };
    Ok((module, errors))
}

fn source(input: ParseStream<'_>, name: &Ident) -> syn::Result<(Source, Errors)> {
    if input.peek(syn::token::Brace) {
        let content;
        braced!(content in input);
        let files = ListingFiles::new(name.span(), "");
        let (listing, errors) = parse::statements(&content, name.span(), &files)?;
        return Ok((Source::Braces(Box::new(listing), files), errors));
    }
    let path = match input.parse::<Option<Token![in]>>()? {
        Some(_) => input.parse()?,
        None => LitStr::new(&format!("{}.linkage", name.unraw()), name.span()),
    };
    input.parse::<Token![;]>().map_err(with_example)?;
    Ok((Source::File(path), Errors::default()))
}

/// The parser's expectation, and an example of a listing in `linkage!`.
fn with_example(error: syn::Error) -> syn::Error {
    let message = format!(
        "{error}; a listing is written `mod corner {{ ... }}`, or `mod corner;` with its statements in the file corner.linkage"
    );
    syn::Error::new(error.span(), message)
}
