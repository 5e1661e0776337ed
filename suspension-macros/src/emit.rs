//! From the system to the module that the user gets.

mod build;
mod docs;
mod equations;
mod indices;
mod jacobian;
mod rates;
mod readout;
mod terms;
mod types;

use proc_macro2::TokenStream;
use quote::quote;

use crate::ast::Listing;
use crate::system::System;

/// The whole module.
pub(crate) fn module(system: &System) -> TokenStream {
    let System {
        docs, vis, name, ..
    } = system;
    let header = docs::header(system);
    let types = types::all(system);
    let indices = indices::modules(system);
    let linkage = equations::linkage_impl(system);
    let build = build::build_impl(system);
    let roles = readout::roles(system);
    quote! {
        #(#docs)*
        #header
        #vis mod #name {
            use ::suspension_core::generated::*;

            #types
            #indices
            #linkage
            #build
            #roles
        }
    }
}

/// The errors of a listing, beside the types that can be told from its names.
pub(crate) fn stub(listing: &Listing, error: &syn::Error) -> TokenStream {
    let Listing {
        docs, vis, name, ..
    } = listing;
    let errors = error.to_compile_error();
    let types = types::stub(listing);
    quote! {
        #errors
        #(#docs)*
        #vis mod #name {
            use ::suspension_core::generated::*;

            #types
        }
    }
}
