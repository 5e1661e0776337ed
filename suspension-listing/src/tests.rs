//! How listings are lowered, and in which order their equations are eliminated.

mod elimination;
mod lowering;
mod sampling;

use proc_macro2::TokenStream;
use quote::ToTokens;

use crate::system::System;
use crate::{lower, parse};

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
    let (listing, _) = parse::listing(catalogue_listing(name)).expect("a listing");
    lower::system(&listing)
}
