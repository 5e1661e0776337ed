//! What stands in for a linkage whose listing has mistakes: the errors, beside the same types
//! and implementations without bodies, so that code which uses them raises no further errors.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::fields::{self, Field};
use super::types;
use super::{build, gather, indices};
use crate::module::Module;
use suspension_listing::Kind;
use suspension_listing::name::Name;
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
    let types = all(module, system, names);
    let indices = indices::modules(system);
    let linkage = linkage_impl(system);
    let listing = gather::listing_of(system, &quote!(loop {}));
    let build = build_impl(system);
    let roles = roles();
    quote! {
        #errors
        #(#attributes)*
        #[allow(dead_code, missing_docs, non_snake_case, unreachable_pub)]
        #vis mod #name {
            use #core::generated::*;

            #types
            #indices
            #linkage
            #listing
            #build
            #roles
        }
    }
}

fn all(module: &Module, system: &System, names: &[(Name, Kind)]) -> TokenStream {
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
        pub struct Model<T> {
            fixed: Fixed<T>,
        }
    }
}

/// Fields without those whose name is taken already.
fn distinct(names: impl Iterator<Item = Name>) -> Vec<Field> {
    let mut seen = BTreeSet::new();
    names
        .filter(|name| seen.insert(name.clone()))
        .map(|name| Field::undocumented(name, String::new()))
        .collect()
}

fn linkage_impl(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    quote! {
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Factors<T>(T);

        impl<T: Scalar> JacobianFactors<T, #n> for Factors<T> {
            fn solve(&self, _: &SVector<T, #n>) -> SVector<T, #n> { loop {} }
            fn solve_transposed(&self, _: &SVector<T, #n>) -> SVector<T, #n> { loop {} }
            fn determinant_sign(&self) -> T { loop {} }
            fn growth_squared(&self) -> T { loop {} }
        }

        impl<T: Scalar> Linkage<#n> for Model<T> {
            type Scalar = T;
            type Listing = Listing;
            type Fixed = Fixed<T>;
            type Drives = Drives<T>;
            type Measures = Measures<T>;
            type Points = Points<T>;
            type Factors = Factors<T>;

            fn linked(&self) -> impl Iterator<Item = usize> { ::core::iter::empty() }
            fn listing(&self) -> Listing { loop {} }
            fn fixed(&self) -> &Fixed<T> { loop {} }
            fn size(&self) -> T { loop {} }
            fn coordinates(&self, _: &Signal<Drives<T>>) -> Signal<Drives<T>> { loop {} }
            fn drive_anchors(&self, _: Fixed<T>, _: &Drives<T>) -> Fixed<T> { loop {} }
            fn residual(&self, _: &SVector<T, #n>, _: &Fixed<T>, _: &Drives<T>) -> SVector<T, #n> { loop {} }
            fn jacobian(&self, _: &SVector<T, #n>, _: &Fixed<T>) -> SMatrix<T, #n, #n> { loop {} }
            fn pivots(&self) -> &[[usize; 2]] { loop {} }
            fn factor(&self, _: &SVector<T, #n>, _: &Fixed<T>) -> Factors<T> { loop {} }
            fn curvature(
                &self,
                _: &SVector<T, #n>,
                _: &Fixed<T>,
                _: &SVector<T, #n>,
                _: &Fixed<T>,
            ) -> SVector<T, #n> { loop {} }
            fn drive_rate(
                &self,
                _: &SVector<T, #n>,
                _: &Fixed<T>,
                _: &Fixed<T>,
                _: &Drives<T>,
            ) -> SVector<T, #n> { loop {} }
            fn chassis_rate(&self, _: &SVector<T, #n>, _: &Fixed<T>, _: &Fixed<T>) -> SVector<T, #n> { loop {} }
            fn points(&self, _: &SVector<T, #n>, _: &Fixed<T>) -> Points<T> { loop {} }
            fn velocities(&self, _: &Points<T>, _: &SVector<T, #n>, _: &Fixed<T>) -> Points<T> { loop {} }
            fn accelerations(
                &self,
                _: &Points<T>,
                _: &Points<T>,
                _: &SVector<T, #n>,
                _: &Fixed<T>,
            ) -> Points<T> { loop {} }
            fn unknowns(&self, _: &Points<T>) -> SVector<T, #n> { loop {} }
            fn measures(&self, _: &Signal<Points<T>>) -> Signal<Measures<T>> where T: Real { loop {} }
            fn mirrored(&self, _: &SVector<T, #n>, _: &Fixed<T>) -> impl Iterator<Item = T> { ::core::iter::empty() }
        }
    }
}

fn build_impl(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let is_stated = build::positions(system).all(|(_, at)| at.is_some());
    let designed = is_stated.then(|| build::designed_as(system, &quote!(loop {})));
    quote! {
        impl<T: Real> Build<#n> for Model<T> {
            type Lengths = Lengths<T>;

            fn of(_: Listing, _: &Points<T>) -> Result<Self, GeometryError> { loop {} }
            fn check_pivots(&self, _: &Points<T>) -> Result<(), GeometryError> { loop {} }
            fn with_lengths(self, _: &Lengths<T>) -> Result<Self, GeometryError> { loop {} }
            fn with_markers(self, _: &Points<T>) -> Result<Self, GeometryError> { loop {} }
            fn lengths(&self) -> Lengths<T> { loop {} }
            fn drives_at(&self, _: &Points<T>) -> Drives<T> { loop {} }
            fn fit(&self, _: &SVector<T, #n>, _: &Fixed<T>) -> SVector<T, #n> { loop {} }
        }

        #designed
    }
}

/// Both roles, whether or not the statements that give them could be read.
fn roles() -> TokenStream {
    quote! {
        impl<T: Scalar> HasWheel<T> for Points<T> {
            fn wheel(&self) -> [Vector3<T>; 2] { loop {} }
            fn carrier(&self) -> [Vector3<T>; 3] { loop {} }
        }

        impl<T: Scalar> HasKingpin<T> for Points<T> {
            fn kingpin(&self) -> [Vector3<T>; 2] { loop {} }
        }
    }
}
