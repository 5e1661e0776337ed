//! What the listing measures, read off the points with the rates.

use proc_macro2::TokenStream;
use quote::quote;

use super::terms::{ident, parameter};
use suspension_listing::name::Name;
use suspension_listing::system::{AXES, Measure, Measured, System};

/// What each measure is.
pub(super) fn kinds(system: &System) -> impl Iterator<Item = TokenStream> {
    system
        .measures
        .iter()
        .map(|measure| match measure.measured {
            Measured::Coordinate { .. } | Measured::Length { .. } => quote!(MeasureKind::Length),
            Measured::Angle { .. } => quote!(MeasureKind::Angle),
        })
}

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
        let values = system.measures.iter().map(value);
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

fn value(Measure { measured, .. }: &Measure) -> TokenStream {
    let line = |[from, to]: &[Name; 2]| quote!(points.map(|points| points.#to - points.#from));
    match measured {
        Measured::Coordinate { axis, of, minus } => {
            let axis = ident(AXES[*axis]);
            let minus = minus.as_ref().map(|minus| quote!(- points.#minus.#axis));
            quote!(points.map(|points| points.#of.#axis #minus))
        }
        Measured::Angle { axis, line: ends } => {
            let (axis, line) = (ident(AXES[*axis]), line(ends));
            quote!(measure::angle(&#line, Vector3::#axis()))
        }
        Measured::Length { line: ends } => {
            let line = line(ends);
            quote!(measure::length(&#line))
        }
    }
}
