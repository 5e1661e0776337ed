//! What the listing measures, read off the points with the rates.

use proc_macro2::TokenStream;
use quote::quote;

use super::quantity;
use super::terms::parameter;
use suspension_listing::name::Name;
use suspension_listing::system::System;

/// `measures` of `impl Linkage`.
pub(super) fn measures(system: &System) -> TokenStream {
    let names: Vec<&Name> = system
        .measures
        .iter()
        .map(|measure| &measure.named.name)
        .collect();
    let body = if names.is_empty() {
        quote!(Signal::default())
    } else {
        let values = system
            .measures
            .iter()
            .map(|measure| quantity::measured(&measure.quantity));
        quote! {
            let each = Measures { #(#names: #values),* };
            Signal {
                value: Measures { #(#names: each.#names.value),* },
                rate: Measures { #(#names: each.#names.rate),* },
                second_rate: Measures { #(#names: each.#names.second_rate),* },
            }
        }
    };
    let points = parameter("points", &quote!(&Signal<Points<T>>), &body);
    quote! {
        fn measures(&self, #points) -> Signal<Measures<T>>
        where
            T: Real,
        {
            #body
        }
    }
}
