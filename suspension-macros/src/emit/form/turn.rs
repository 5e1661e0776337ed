//! `Turn`: an angle about an axis, by sine and cosine of its quarter.

use proc_macro2::TokenStream;
use quote::quote;

use suspension_listing::form::Turn;
use suspension_listing::name::Name;
use suspension_listing::system::{Site, SiteMotion, System};

use super::ends::vectors_at;
use super::{Emit, Operations};
use crate::emit::fields::point_index;
use crate::emit::gradient::{By, Gradient};
use crate::emit::terms::assign;

impl Emit for Turn {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Turn))
    }

    fn constant_from_points(&self, _name: &Name, system: &System) -> TokenStream {
        let [.., [_, end]] = &self.lines;
        let index = point_index(system, &end.name);
        let lines = vectors_at(&self.lines);
        quote!(parts::turn(#index, [#(#lines),*])?)
    }

    /// Lengths do not determine the angle.
    fn constant_from_lengths(&self, name: &Name, _system: &System) -> TokenStream {
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

    fn residual(&self, name: &Name) -> TokenStream {
        let (sine, cosine) = (&self.sine, &self.cosine);
        assign(name, &quote!(self.#name.residual(free.#sine, free.#cosine)))
    }

    fn gradient(&self, name: &Name) -> Gradient<'_> {
        let parts = [&self.sine, &self.cosine];
        let by = parts.map(|part| By::Scalar(part, quote!(self.#name.gradient(free.#part))));
        Gradient {
            statements: TokenStream::new(),
            by: by.into(),
        }
    }

    fn curvature(&self, name: &Name) -> Option<TokenStream> {
        let (sine, cosine) = (&self.sine, &self.cosine);
        let changes = quote!([v.#sine, v.#cosine], [w.#sine, w.#cosine]);
        Some(assign(name, &quote!(self.#name.curvature(#changes))))
    }

    fn input_rate(&self, _name: &Name, _motion: SiteMotion) -> Option<TokenStream> {
        None
    }

    fn cost(&self) -> [Operations; 3] {
        [(4, 2), (2, 0), (3, 1)].map(Operations::from)
    }
}
