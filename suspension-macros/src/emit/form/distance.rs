//! `Distance`: a constant length.

use proc_macro2::TokenStream;
use quote::quote;

use suspension_listing::form::Distance;
use suspension_listing::name::Name;
use suspension_listing::system::{SiteMotion, System};

use super::{Emit, Operations, ends};
use crate::emit::fields::length_index;
use crate::emit::gradient::Gradient;
use crate::emit::terms::{assign, line};

impl Emit for Distance {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Distance))
    }

    fn has_length(&self) -> bool {
        true
    }

    fn constant_from_points(&self, name: &Name, system: &System) -> TokenStream {
        let (from, to) = (&self.from.name, &self.to.name);
        let index = length_index(system, name);
        quote!(parts::distance(#index, at.#from, at.#to)?)
    }

    fn constant_from_lengths(&self, name: &Name, _system: &System) -> TokenStream {
        quote!(Distance::new(lengths.#name))
    }

    fn residual(&self, name: &Name) -> TokenStream {
        let vector = line([&self.from, &self.to], "free", "fixed");
        let row = assign(name, &quote!(self.#name.residual(d)));
        quote!(let d = #vector; #row)
    }

    fn gradient(&self, name: &Name) -> Gradient<'_> {
        ends::gradient(name, [&self.from, &self.to])
    }

    fn curvature(&self, name: &Name) -> Option<TokenStream> {
        let [v, w] = [("v", "v_fixed"), ("w", "w_fixed")]
            .map(|(free, fixed)| line([&self.from, &self.to], free, fixed));
        let row = assign(name, &quote!(self.#name.curvature(v_d, w_d)));
        let rows = quote! {
            let v_d = #v;
            let w_d = #w;
            #row
        };
        Some(rows)
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<TokenStream> {
        ends::input_rate(name, [&self.from, &self.to], motion)
    }

    fn cost(&self) -> [Operations; 3] {
        [(7, 6), (3, 3), (4, 8)].map(Operations::from)
    }
}
