//! The listing as a type of its own, and its model over other numbers: `impl Listing`.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::types::constants;
use suspension_listing::system::System;

pub(super) fn listing(system: &System) -> TokenStream {
    let fixed = system.fixed.iter().map(|point| {
        let name = &point.name;
        quote!(#name: gather_vectors(models.map(|model| model.fixed.#name), &gather))
    });
    let no_fixed = system
        .fixed
        .is_empty()
        .then(|| quote!(no_fields: ::core::marker::PhantomData));
    let constants = constants(system)
        .map(|(name, kind)| quote!(#name: #kind::gather(models.map(|model| model.#name), &gather)));
    let model = quote! {
        Model {
            fixed: Fixed { #(#fixed,)* #no_fixed },
            size: gather(models.map(|model| model.size)),
            #(#constants,)*
        }
    };
    listing_of(system, &model)
}

/// The implementation, with the expression that gathers a model.
pub(super) fn listing_of(system: &System, model: &TokenStream) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    quote! {
        /// This listing, over any number.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct Listing;

        impl AnyNumber<#n> for Listing {
            type Model<T: Scalar> = Model<T>;
            type Fixed<T: Scalar> = Fixed<T>;
            type Drives<T: Scalar> = Drives<T>;
            type Measures<T: Scalar> = Measures<T>;
            type Points<T: Scalar> = Points<T>;

            fn gather<S: Scalar, T: Scalar, const K: usize>(
                models: [&Model<S>; K],
                gather: impl Fn([S; K]) -> T,
            ) -> Model<T> {
                #model
            }
        }
    }
}
