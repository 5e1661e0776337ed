//! The stand-in for a linkage whose listing has mistakes: the errors, beside the same types
//! and implementations without bodies, so that code which uses them raises no further errors.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::fields::{self, Field};
use super::types;
use super::{build, gather, indices};
use crate::module::Module;
use suspension_listing::Kind;
use suspension_listing::name::{KEYWORD_OF_2024, Name};
use suspension_listing::system::System;

/// The errors and the stand-in.
pub(crate) fn stub(
    module: &Module,
    system: &System,
    names: &[(Name, Kind)],
    error: &syn::Error,
) -> TokenStream {
    let Module {
        attributes,
        vis,
        name,
        core,
        ..
    } = module;
    let errors = error.to_compile_error();
    let types = types_without_bodies(module, system, names);
    let indices = indices::modules(system);
    let listing = gather::listing_of(system, &quote!(loop {}));
    let is_stated = build::positions(system).all(|(_, at)| at.is_some());
    let designed = is_stated.then(|| build::designed_as(system, &quote!(loop {})));
    let n = Literal::usize_unsuffixed(system.size());
    quote! {
        #errors
        #(#attributes)*
        #[allow(dead_code, missing_docs, non_snake_case, unreachable_pub)]
        #vis mod #name {
            use #core::generated::*;

            #types
            #indices
            #listing
            #designed
            stand_in!(#n);
        }
    }
}

fn types_without_bodies(module: &Module, system: &System, names: &[(Name, Kind)]) -> TokenStream {
    let fixed = system.fixed.iter().map(|point| point.named.name.clone());
    let kinds = [Kind::CHASSIS_POINT, Kind::FREE_POINT, Kind::MARKER];
    let points = names.iter().filter(|(_, kind)| kinds.contains(kind));
    let points = points.map(|(name, _)| name.clone());
    let drives = system.drives.iter().map(|drive| drive.named.name.clone());
    let measures = system.measures.iter();
    let measures = measures.map(|measure| measure.named.name.clone());
    let lengths = fields::length_fields(system);
    let lengths = lengths.into_iter().map(|field| field.name);
    let (vector, number) = (quote!(Vector3<T>), quote!(T));
    let structs = [
        ("Points", &vector, distinct(points)),
        ("Fixed", &vector, distinct(fixed)),
        ("Drives", &number, distinct(drives)),
        ("Measures", &number, distinct(measures)),
        ("Lengths", &number, distinct(lengths)),
    ];
    let structs = structs
        .into_iter()
        .map(|(name, value, fields)| types::named(name, "", value, module, &fields));
    let corner = types::corner(system);
    quote! {
        #(#structs)*

        #corner

        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Model<T = f64> {
            fixed: Fixed<T>,
        }
    }
}

/// Fields without those whose name is taken already, or is a keyword of edition 2024, which is refused and would be
/// refused again.
fn distinct(names: impl Iterator<Item = Name>) -> Vec<Field> {
    let mut seen = BTreeSet::new();
    names
        .filter(|name| name.as_str() != KEYWORD_OF_2024 && seen.insert(name.clone()))
        .map(|name| Field::undocumented(name, String::new()))
        .collect()
}
