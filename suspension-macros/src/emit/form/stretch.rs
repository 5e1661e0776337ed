//! `Stretch`: two points an unknown length apart.

use proc_macro2::TokenStream;
use quote::quote;

use suspension_listing::form::Stretch;
use suspension_listing::name::Name;
use suspension_listing::system::{Site, SiteMotion, System};

use super::{Emit, Operations, ends};
use crate::emit::fields::point_index;
use crate::emit::gradient::{By, Gradient};
use crate::emit::terms::{assign, ident, line};

impl Emit for Stretch {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Stretch))
    }

    fn has_length(&self) -> bool {
        true
    }

    fn constant_from_points(&self, _name: &Name, system: &System) -> TokenStream {
        let (from, to) = (&self.from.name, &self.to.name);
        let index = point_index(system, to);
        quote!(parts::stretch(#index, (at.#to - at.#from).norm())?)
    }

    /// A driven length is not among the given lengths.
    fn constant_from_lengths(&self, name: &Name, _system: &System) -> TokenStream {
        quote!(self.#name)
    }

    fn scalars(&self, name: &Name, place: &dyn Fn(&Site) -> TokenStream) -> Option<TokenStream> {
        let (from, to, length) = (place(&self.from), place(&self.to), &self.length);
        Some(quote!(free.#length = self.#name.reach(difference(#to, #from));))
    }

    fn residual(&self, name: &Name) -> TokenStream {
        let vector = line([&self.from, &self.to], "free", "fixed");
        let length = &self.length;
        assign(name, &quote!(self.#name.residual(#vector, free.#length)))
    }

    fn gradient(&self, name: &Name) -> Gradient<'_> {
        let mut gradient = ends::gradient(name, [&self.from, &self.to]);
        let length = &self.length;
        let by_length = quote!(self.#name.by_length(free.#length));
        gradient.by.push(By::Scalar(length, by_length));
        gradient
    }

    fn curvature(&self, name: &Name) -> Option<TokenStream> {
        let changes = ["v", "w"].map(|rate| {
            let vector = line([&self.from, &self.to], rate, &format!("{rate}_fixed"));
            let free = ident(rate);
            let length = &self.length;
            quote!((#vector, #free.#length))
        });
        Some(assign(name, &quote!(self.#name.curvature(#(#changes),*))))
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<TokenStream> {
        ends::input_rate(name, [&self.from, &self.to], motion)
    }

    fn cost(&self) -> [Operations; 3] {
        [(6, 6), (4, 3), (5, 9)].map(Operations::from)
    }
}
