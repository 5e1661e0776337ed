//! How listings are lowered, and in which order their equations are eliminated.

mod elimination;
mod lowering;
mod sampling;

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Ident, Token, Visibility, braced};

use crate::Listing;
use crate::errors::Errors;
use crate::system::{Positions, System};
use crate::{checked, parse, sample};

/// The listing of `mod name { statements }`.
fn listing(module: TokenStream) -> (Listing, Errors) {
    let parser = |input: ParseStream<'_>| {
        input.call(Attribute::parse_outer)?;
        input.parse::<Visibility>()?;
        input.parse::<Token![mod]>()?;
        input.parse::<Ident>()?;
        let content;
        braced!(content in input);
        parse::statements(&content, Span::call_site())
    };
    parser.parse2(module).expect("a listing")
}

/// The system of a listing, and its mistakes.
fn lower(module: TokenStream) -> (System, Vec<String>) {
    let (listing, errors) = listing(module);
    let (system, found) = checked(&listing, errors);
    let errors = found.err().into_iter().flatten();
    (system, errors.map(|error| error.to_string()).collect())
}

/// The design position, and others that the drives lead to from there.
fn positions(system: &System) -> Vec<Positions> {
    sample::positions(system, system.design().expect("a design position"))
}

/// The tokens inside the `linkage! { .. }` of a catalogue file.
fn catalogue_listing(name: &str) -> TokenStream {
    let path = format!(
        "{}/../suspension-core/src/linkages/{name}.rs",
        env!("CARGO_MANIFEST_DIR")
    );
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let file = syn::parse_file(&text).expect("a Rust file");
    let listing = file.items.into_iter().find_map(|item| match item {
        syn::Item::Macro(item) if item.mac.path.is_ident("linkage") => Some(item.mac.tokens),
        _ => None,
    });
    listing.expect("a `linkage!` in the file").to_token_stream()
}

/// The system of a catalogue file.
fn catalogue_system(name: &str) -> System {
    let (system, errors) = lower(catalogue_listing(name));
    assert!(errors.is_empty(), "{errors:?}");
    system
}
