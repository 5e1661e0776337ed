//! The pipeline: parse, check, lower, check, order, emit.

use proc_macro2::TokenStream;

use suspension_listing::{check, eliminate, lower, parse, sample};

use crate::emit;

/// Expands a listing. Where it has mistakes, all of them are reported, and the types are still
/// emitted so that code which uses them raises no further errors.
pub(crate) fn expand(input: TokenStream) -> TokenStream {
    let (listing, mut errors) = match parse::listing(input) {
        Ok(parsed) => parsed,
        Err(error) => return error.into_compile_error(),
    };
    check::names(&listing, &mut errors);
    let system = lower::system(&listing);
    check::angles(&listing, &system, &mut errors);
    if errors.is_empty() {
        check::chassis_points(&listing, &mut errors);
        check::determined(&system, &mut errors);
    }
    match errors.into_result() {
        Ok(()) => {
            let entries = system.entries(&sample::positions(&system));
            emit::module(&system, &eliminate::order(system.size(), &entries))
        }
        Err(error) => emit::stub(&listing, &system, &error),
    }
}
