//! From the system to the module that the user gets.

mod build;
mod carried;
mod clusters;
mod docs;
mod elimination;
mod entries;
mod equations;
mod fields;
mod form;
mod frames;
mod gather;
mod gradient;
mod indices;
mod jacobian;
mod lengths;
mod measures;
mod operations;
mod quantity;
mod rates;
mod readout;
mod short;
mod stub;
mod substitution;
mod terms;
mod types;
mod unrolled;
mod written_out;

use proc_macro2::TokenStream;
use quote::quote;

use suspension_listing::eliminate::EliminationOrder;
use suspension_listing::system::System;

use crate::module::Module;

pub(crate) use stub::stub;

/// The whole module.
pub(crate) fn module(module: &Module, system: &System, order: &EliminationOrder) -> TokenStream {
    let Module {
        attributes,
        vis,
        name,
        core,
        ..
    } = module;
    let docs = &system.docs;
    let header = docs::header(system, order);
    let types = types::types(module, system);
    let indices = indices::modules(system);
    let linkage = equations::linkage_impl(system, order);
    let factors = elimination::factors(system, order);
    let listing = gather::listing(system);
    let build = build::build_impl(system);
    let roles = readout::roles_of_points(system);
    quote! {
        #(#attributes)*
        #(#[doc = #docs])*
        #header
        // A program need not use every name, nor pass the module on; names made of two of the listing's
        // may have two underscores in a row, and numbers are those of the listing, near constants of mathematics or not.
        #[allow(clippy::approx_constant, dead_code, non_snake_case, unreachable_pub)]
        #vis mod #name {
            use #core::generated::*;
            // Before macros of the same names that the crate may have in scope.
            use #core::generated::{unknown_names, vector_of};

            #types
            #indices
            #linkage
            #factors
            #listing
            #build
            #roles
        }
    }
}
