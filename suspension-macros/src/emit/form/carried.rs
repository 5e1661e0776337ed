//! `Carried`: a point of a rigid body.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use suspension_listing::form::Carried;
use suspension_listing::name::Name;
use suspension_listing::system::{Equation, Site, SiteMotion, System, frame_name, pair_name};

use super::{Emit, Operations, Rows, Write};
use crate::emit::fields::point_index;
use crate::emit::indices;
use crate::emit::terms::{Binding, assign_vector, ident, value_of};

/// The points of a frame in the gradient.
const BLOCKS: [&str; 3] = ["origin", "second", "third"];

impl Emit for Carried {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Carried))
    }

    fn is_framed(&self) -> bool {
        true
    }

    fn of_points(&self, _name: &Name, system: &System) -> TokenStream {
        let (point, frame) = (&self.point.name, frame_name(&self.body));
        let index = point_index(system, point);
        quote!(parts::carried(#index, design.#point, &#frame)?)
    }

    fn of_lengths(&self, name: &Name, system: &System) -> TokenStream {
        let (point, frame) = (&self.point.name, frame_name(&self.body));
        let index = point_index(system, point);
        let of_frame = self.frame.iter();
        let lengths = of_frame.map(|site| pair_name(&self.body, point, &site.name));
        quote!(parts::carried_at(#index, &self.#name, &#frame, [#(lengths.#lengths),*])?)
    }

    fn residual(&self, name: &Name) -> Rows {
        let (point, frame) = (
            value_of(&self.point, &ident("free"), &ident("fixed")),
            frame_name(&self.body),
        );
        in_rows(name, quote!(self.#name.residual(#point, &#frame)))
    }

    fn jacobian(&self, equation: &Equation, write: &Write<'_>) -> TokenStream {
        let (name, frame, rows) = (
            &equation.named.name,
            frame_name(&self.body),
            equation.rows(),
        );
        let columns = indices::unknown_names(&self.point.name);
        let identity = rows.iter().zip(&columns);
        let identity = identity.map(|(row, column)| write(row, column, quote!(T::one())));
        let blocks = BLOCKS.into_iter().zip(&self.frame);
        let blocks = blocks.map(|(block, site)| entries(site, &rows, block, write));
        let entries = quote!(#(#identity)* #(#blocks)*);
        let gradient =
            (!entries.is_empty()).then(|| quote!(let gradient = self.#name.gradient(&#frame);));
        quote!(#gradient #entries)
    }

    fn curvature(&self, name: &Name) -> Option<Rows> {
        let frame = frame_name(&self.body);
        let [v, w] = ["v", "w"].map(|rate| format_ident!("{frame}_{rate}"));
        Some(in_rows(name, quote!(self.#name.curvature(&#v, &#w))))
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<Rows> {
        let blocks = BLOCKS.map(ident).into_iter().zip(&self.frame);
        let moved = blocks.filter(|(_, site)| site.motion == motion);
        let terms: Vec<TokenStream> = moved
            .map(|(block, site)| {
                let site = &site.name;
                quote!(- #name.#block * fixed_rate.#site)
            })
            .collect();
        let (frame, entries) = (frame_name(&self.body), assign_vector(name, &ident("term")));
        (!terms.is_empty()).then(|| Rows {
            variable: Some(Binding::new(name, quote!(self.#name.gradient(&#frame)))),
            assignments: quote! {
                let term = #(#terms)*;
                #entries
            },
        })
    }

    fn cost(&self) -> [Operations; 3] {
        [(15, 15), (6, 5), (15, 9)].map(Operations::from)
    }
}

/// Rows of a vector that has the equations' name.
fn in_rows(name: &Name, vector: TokenStream) -> Rows {
    Rows {
        variable: Some(Binding::new(name, vector)),
        assignments: assign_vector(name, name),
    }
}

fn entries(site: &Site, rows: &[Name], block: &str, write: &Write<'_>) -> TokenStream {
    if !site.is_free() {
        return TokenStream::new();
    }
    let block = ident(block);
    let mut entries = TokenStream::new();
    for (i, row) in (1..).zip(rows) {
        for (j, column) in (1..).zip(&indices::unknown_names(&site.name)) {
            let entry = format_ident!("m{i}{j}");
            entries.extend(write(row, column, quote!(gradient.#block.#entry)));
        }
    }
    entries
}
