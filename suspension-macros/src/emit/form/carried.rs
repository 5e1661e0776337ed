//! `Carried`: a point of a rigid body.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use suspension_listing::form::Carried;
use suspension_listing::name::Name;
use suspension_listing::system::{SiteMotion, System, frame_name, pair_name};

use super::{Emit, Operations};
use crate::emit::carried::BLOCKS;
use crate::emit::fields::point_index;
use crate::emit::gradient::{By, Gradient};
use crate::emit::terms::{assign_vector, ident, value_of};

impl Emit for Carried {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Carried))
    }

    fn is_framed(&self) -> bool {
        true
    }

    fn constant_from_points(&self, _name: &Name, system: &System) -> TokenStream {
        let (point, frame) = (&self.point.name, frame_name(&self.body));
        let index = point_index(system, point);
        quote!(parts::carried(#index, at.#point, &#frame)?)
    }

    fn constant_from_lengths(&self, name: &Name, system: &System) -> TokenStream {
        let (point, frame) = (&self.point.name, frame_name(&self.body));
        let index = point_index(system, point);
        let of_frame = self.frame.iter();
        let lengths = of_frame.map(|site| pair_name(&self.body, point, &site.name));
        quote!(parts::carried_at(#index, &self.#name, &#frame, [#(lengths.#lengths),*])?)
    }

    fn residual(&self, name: &Name) -> TokenStream {
        let (point, frame) = (
            value_of(&self.point, &ident("free"), &ident("fixed")),
            frame_name(&self.body),
        );
        assign_vector(name, &quote!(self.#name.residual(#point, &#frame)))
    }

    fn gradient(&self, name: &Name) -> Gradient<'_> {
        let frame = frame_name(&self.body);
        let blocks = BLOCKS.map(ident).into_iter().zip(&self.frame);
        let blocks = blocks.map(|(block, site)| By::PointOfThree(site, quote!(gradient.#block)));
        let identity = By::Diagonal(&self.point, quote!(T::one()));
        Gradient {
            statements: quote!(let gradient = self.#name.gradient(&#frame);),
            by: [identity].into_iter().chain(blocks).collect(),
        }
    }

    fn curvature(&self, name: &Name) -> Option<TokenStream> {
        let frame = frame_name(&self.body);
        let [v, w] = ["v", "w"].map(|rate| format_ident!("{frame}_{rate}"));
        Some(assign_vector(name, &quote!(self.#name.curvature(&#v, &#w))))
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<TokenStream> {
        let blocks = BLOCKS.map(ident).into_iter().zip(&self.frame);
        let moved = blocks.filter(|(_, site)| site.motion == motion);
        let terms: Vec<TokenStream> = moved
            .map(|(block, site)| {
                let site = &site.name;
                quote!(- gradient.#block * fixed_rate.#site)
            })
            .collect();
        let statements = self.gradient(name).statements;
        let rows = assign_vector(name, &quote!(#(#terms)*));
        (!terms.is_empty()).then(|| quote!(#statements #rows))
    }

    fn cost(&self) -> [Operations; 3] {
        [(15, 15), (6, 5), (15, 9)].map(Operations::from)
    }
}
