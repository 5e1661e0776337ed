//! The measures of the listing, computed from the points, with rates.

use proc_macro2::TokenStream;
use quote::quote;

use super::quantity;
use super::terms::parameter;
use suspension_listing::system::System;

/// `measures` of `impl Linkage`.
pub(super) fn measures(system: &System) -> TokenStream {
    let measures = system.measures.iter().map(|measure| {
        let (name, measured) = (&measure.named.name, quantity::measured(&measure.quantity));
        quote! {
            let measured = #measured;
            measures.set(measured, |measures| &mut measures.#name);
        }
    });
    let measures: Vec<TokenStream> = measures.collect();
    let body = if measures.is_empty() {
        quote!(Signal::default())
    } else {
        quote! {
            let mut measures: Signal<Measures<T>> = Signal::default();
            #(#measures)*
            measures
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
