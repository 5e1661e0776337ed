//! `Turn`: an angle about an axis, by sine and cosine of its quarter.

use proc_macro2::TokenStream;
use quote::quote;

use suspension_listing::form::Turn;
use suspension_listing::name::Name;
use suspension_listing::system::{Equation, Site, SiteMotion, System};

use super::{Emit, Operations, Rows, Write};
use crate::emit::fields::point_index;
use crate::emit::terms::assign;

impl Emit for Turn {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Turn))
    }

    fn of_points(&self, _name: &Name, system: &System) -> TokenStream {
        let [.., [_, end]] = &self.lines;
        let index = point_index(system, &end.name);
        let lines = self.lines.each_ref().map(|[from, to]| {
            let (from, to) = (&from.name, &to.name);
            quote!(design.#to - design.#from)
        });
        quote!(parts::turn(#index, [#(#lines),*])?)
    }

    /// Lengths do not tell the angle.
    fn of_lengths(&self, name: &Name, _system: &System) -> TokenStream {
        quote!(self.#name)
    }

    fn scalars(&self, name: &Name, place: &dyn Fn(&Site) -> TokenStream) -> Option<TokenStream> {
        let lines = self.lines.each_ref().map(|line| {
            let [from, to] = line.each_ref().map(place);
            quote!(difference(#to, #from))
        });
        let (sine, cosine) = (&self.sine, &self.cosine);
        Some(quote!([free.#sine, free.#cosine] = self.#name.quarter([#(#lines),*]);))
    }

    fn residual(&self, name: &Name) -> Rows {
        let (sine, cosine) = (&self.sine, &self.cosine);
        assign(name, &quote!(self.#name.residual(free.#sine, free.#cosine))).into()
    }

    fn jacobian(&self, equation: &Equation, write: &Write<'_>) -> TokenStream {
        let name = &equation.named.name;
        let entries = [&self.sine, &self.cosine];
        let entries =
            entries.map(|part| write(name, part, quote!(self.#name.gradient(free.#part))));
        quote!(#(#entries)*)
    }

    fn curvature(&self, name: &Name) -> Option<Rows> {
        let (sine, cosine) = (&self.sine, &self.cosine);
        let changes = quote!([v.#sine, v.#cosine], [w.#sine, w.#cosine]);
        Some(assign(name, &quote!(self.#name.curvature(#changes))).into())
    }

    fn input_rate(&self, _name: &Name, _motion: SiteMotion) -> Option<Rows> {
        None
    }

    fn cost(&self) -> [Operations; 3] {
        [(4, 2), (2, 0), (3, 1)].map(Operations::from)
    }
}
