//! Functions inlined in the generated code at their calls.

use proc_macro2::TokenStream;
use quote::quote;

/// A function of equations. In a release build it is written out wherever it is called, so that a step is
/// straight-line code; a debug build compiles it once.
pub(super) fn written_out(function: &TokenStream) -> TokenStream {
    quote! {
        #[cfg_attr(not(debug_assertions), inline(always))]
        #function
    }
}
