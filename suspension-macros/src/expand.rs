//! The pipeline: parse, check and lower, order, emit.

use proc_macro2::TokenStream;

use suspension_listing::{checked, order};

use crate::{emit, module};

/// Expands a listing. Where it has mistakes, all of them are reported, and the types are still
/// emitted so that code which uses them raises no further errors.
pub(crate) fn expand(input: TokenStream) -> TokenStream {
    let (module, listing, errors) = match module::parse(input) {
        Ok(parsed) => parsed,
        Err(error) => return error.into_compile_error(),
    };
    let (system, found) = checked(&listing, errors);
    match found {
        Ok(()) => emit::module(&module, &listing, &system, &order(&system)),
        Err(error) => emit::stub(&module, &listing, &system, &error),
    }
}
