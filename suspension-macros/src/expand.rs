//! The pipeline: parse, check, lower, check, emit.

use proc_macro2::TokenStream;

use crate::{check, emit, lower, parse};

/// Expands a listing. Where it has mistakes, all of them are reported, and the types are still
/// emitted so that code which uses them raises no further errors.
pub(crate) fn expand(input: TokenStream) -> TokenStream {
    let (listing, syntax_errors) = match parse::listing(input) {
        Ok(parsed) => parsed,
        Err(error) => return error.into_compile_error(),
    };
    let checked = syntax_errors.into_result().and(check::names(&listing));
    let system = checked
        .map(|()| lower::system(&listing))
        .and_then(|system| {
            check::determined(&system)?;
            Ok(system)
        });
    match system {
        Ok(system) => emit::module(&system),
        Err(error) => emit::stub(&listing, &error),
    }
}
