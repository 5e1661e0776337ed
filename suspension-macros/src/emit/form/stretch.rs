//! `Stretch`: two points an unknown length apart.

use proc_macro2::TokenStream;
use quote::quote;

use suspension_listing::form::Stretch;
use suspension_listing::name::Name;
use suspension_listing::system::{Equation, Site, SiteMotion, System};

use super::{Emit, Operations, Rows, Write, gradient_entries};
use crate::emit::fields::point_index;
use crate::emit::terms::{assign, ident, value_of};

impl Emit for Stretch {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Stretch))
    }

    fn has_length(&self) -> bool {
        true
    }

    fn of_points(&self, _name: &Name, system: &System) -> TokenStream {
        let (from, to) = (&self.from.name, &self.to.name);
        let index = point_index(system, to);
        quote!(parts::stretch(#index, (design.#to - design.#from).norm())?)
    }

    /// A driven length is none of those that are given.
    fn of_lengths(&self, name: &Name, _system: &System) -> TokenStream {
        quote!(self.#name)
    }

    fn scalars(&self, name: &Name, place: &dyn Fn(&Site) -> TokenStream) -> Option<TokenStream> {
        let (from, to, length) = (place(&self.from), place(&self.to), &self.length);
        Some(quote!(free.#length = self.#name.reach(difference(#to, #from));))
    }

    fn residual(&self, name: &Name) -> Rows {
        let (vector, length) = (vector(self, "free", "fixed"), &self.length);
        assign(name, &quote!(self.#name.residual(#vector, free.#length))).into()
    }

    fn jacobian(&self, equation: &Equation, write: &Write<'_>) -> TokenStream {
        let (name, length) = (&equation.named.name, &self.length);
        let vector = vector(self, "free", "fixed");
        let to = gradient_entries(&self.to, name, &quote!(), write);
        let from = gradient_entries(&self.from, name, &quote!(-), write);
        let by_length = write(name, length, quote!(self.#name.by_length(free.#length)));
        quote! {
            let gradient = self.#name.gradient(#vector);
            #to
            #from
            #by_length
        }
    }

    fn curvature(&self, name: &Name) -> Option<Rows> {
        let changes = ["v", "w"].map(|rate| {
            let (vector, free) = (vector(self, rate, &format!("{rate}_fixed")), ident(rate));
            let length = &self.length;
            quote!((#vector, #free.#length))
        });
        Some(assign(name, &quote!(self.#name.curvature(#(#changes),*))).into())
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<Rows> {
        let (vector, from) = (vector(self, "free", "fixed"), &self.from.name);
        let term = quote!(dot(self.#name.gradient(#vector), fixed_rate.#from));
        (self.from.motion == motion).then(|| assign(name, &term).into())
    }

    fn cost(&self) -> [Operations; 3] {
        [(6, 6), (4, 3), (5, 9)].map(Operations::from)
    }
}

/// From one point to the other, in two structs of points.
fn vector(Stretch { from, to, .. }: &Stretch, free: &str, fixed: &str) -> TokenStream {
    let (free, fixed) = (ident(free), ident(fixed));
    let (from, to) = (value_of(from, &free, &fixed), value_of(to, &free, &fixed));
    quote!(difference(#to, #from))
}
