//! The `linkage!` macro: it turns a list of constraints on points into straight-line Rust.
//!
//! Use it through `suspension_core::linkage`, which documents it with examples.

mod emit;
mod expand;
mod listing_files;
mod module;
mod named;
#[cfg(test)]
mod tests;

/// The macro behind `suspension_core::linkage!`, which writes the path of its own crate, under whatever name that is
/// imported, in brackets before the listing.
#[proc_macro]
pub fn linkage(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand::expand(input.into()).into()
}

/// Derives the traits of the structs of names that `linkage!` writes.
#[doc(hidden)]
#[proc_macro_derive(Named)]
pub fn named(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let written = named::named(input.into());
    written
        .unwrap_or_else(syn::Error::into_compile_error)
        .into()
}
