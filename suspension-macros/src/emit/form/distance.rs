//! `Distance`: a constant length.

use proc_macro2::TokenStream;
use quote::quote;

use suspension_listing::form::Distance;
use suspension_listing::name::Name;
use suspension_listing::system::{Equation, SiteMotion, System};

use super::{Emit, Operations, Rows, Write, gradient_entries};
use crate::emit::fields::length_index;
use crate::emit::terms::{assign, ident, value_of};

impl Emit for Distance {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Distance))
    }

    fn has_length(&self) -> bool {
        true
    }

    fn of_points(&self, name: &Name, system: &System) -> TokenStream {
        let (from, to) = (&self.from.name, &self.to.name);
        let index = length_index(system, name);
        quote!(parts::distance(#index, design.#from, design.#to)?)
    }

    fn of_lengths(&self, name: &Name, _system: &System) -> TokenStream {
        quote!(Distance::new(lengths.#name))
    }

    fn residual(&self, name: &Name) -> Rows {
        let vector = vector(self, "free", "fixed");
        assign(name, &quote!(self.#name.residual(#vector))).into()
    }

    fn jacobian(&self, equation: &Equation, write: &Write<'_>) -> TokenStream {
        let (name, vector) = (&equation.named.name, vector(self, "free", "fixed"));
        let to = gradient_entries(&self.to, name, &quote!(), write);
        let from = gradient_entries(&self.from, name, &quote!(-), write);
        quote! {
            let gradient = self.#name.gradient(#vector);
            #to
            #from
        }
    }

    fn curvature(&self, name: &Name) -> Option<Rows> {
        let (v, w) = (vector(self, "v", "v_fixed"), vector(self, "w", "w_fixed"));
        Some(assign(name, &quote!(self.#name.curvature(#v, #w))).into())
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<Rows> {
        let (vector, from) = (vector(self, "free", "fixed"), &self.from.name);
        let term = quote!(dot(self.#name.gradient(#vector), fixed_rate.#from));
        (self.from.motion == motion).then(|| assign(name, &term).into())
    }

    fn cost(&self) -> [Operations; 3] {
        [(7, 6), (3, 3), (4, 8)].map(Operations::from)
    }
}

/// From one point to the other, in two structs of points.
fn vector(Distance { from, to }: &Distance, free: &str, fixed: &str) -> TokenStream {
    let (free, fixed) = (ident(free), ident(fixed));
    let (from, to) = (value_of(from, &free, &fixed), value_of(to, &free, &fixed));
    quote!(difference(#to, #from))
}
