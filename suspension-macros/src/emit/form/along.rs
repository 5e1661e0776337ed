//! `Along`: a point on a line.

use proc_macro2::TokenStream;
use quote::quote;

use suspension_listing::form::Along;
use suspension_listing::name::Name;
use suspension_listing::system::{Equation, Site, SiteMotion, System};

use super::{Emit, Operations, Rows, Write};
use crate::emit::fields::point_index;
use crate::emit::indices;
use crate::emit::lengths::kept_length;
use crate::emit::terms::{assign_vector, ident, value_of};

impl Emit for Along {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Along))
    }

    fn has_length(&self) -> bool {
        true
    }

    fn of_points(&self, _name: &Name, system: &System) -> TokenStream {
        let [from, to] = self.line.each_ref().map(|site| &site.name);
        let index = point_index(system, to);
        quote!(parts::line(#index, (design.#to - design.#from).norm())?)
    }

    fn of_lengths(&self, _name: &Name, system: &System) -> TokenStream {
        let [from, to] = self.line.each_ref();
        let (index, length) = (
            point_index(system, &to.name),
            kept_length(system, [from, to]),
        );
        quote!(parts::line(#index, #length)?)
    }

    fn scalar(&self, name: &Name, place: &dyn Fn(&Site) -> TokenStream) -> Option<TokenStream> {
        let (point, line) = (place(&self.point), self.line.each_ref().map(place));
        Some(quote!(self.#name.distance(#point, [#(#line),*])))
    }

    fn residual(&self, name: &Name) -> Rows {
        let (point, line, distance) = (place(&self.point), line(self), &self.distance);
        let entries = assign_vector(name, &ident("term"));
        let term = quote! {
            let term = self.#name.residual(#point, #line, free.#distance);
            #entries
        };
        term.into()
    }

    fn jacobian(&self, equation: &Equation, write: &Write<'_>) -> TokenStream {
        let (name, rows) = (&equation.named.name, equation.rows());
        let (line, distance) = (line(self), &self.distance);
        let [from, to] = &self.line;
        let point = diagonal(&self.point, &rows, &quote!(T::one()), write);
        let from = diagonal(from, &rows, &quote!(gradient.from), write);
        let to = diagonal(to, &rows, &quote!(gradient.to), write);
        let by_distance = rows.iter().zip(["x", "y", "z"].map(ident));
        let by_distance =
            by_distance.map(|(row, axis)| write(row, distance, quote!(gradient.distance.#axis)));
        quote! {
            let gradient = self.#name.gradient(#line, free.#distance);
            #point
            #from
            #to
            #(#by_distance)*
        }
    }

    fn curvature(&self, name: &Name) -> Option<Rows> {
        let [from, to] = &self.line;
        let changes = ["v", "w"].map(|rate| {
            let (free, fixed) = (ident(rate), ident(&format!("{rate}_fixed")));
            let [from, to] = [from, to].map(|site| value_of(site, &free, &fixed));
            let distance = &self.distance;
            quote!((difference(#to, #from), #free.#distance))
        });
        let entries = assign_vector(name, &ident("term"));
        let term = quote! {
            let term = self.#name.curvature(#(#changes),*);
            #entries
        };
        Some(term.into())
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<Rows> {
        let (line, distance) = (line(self), &self.distance);
        let [from, to] = &self.line;
        let factors = [
            (&self.point, quote!()),
            (from, quote!(*gradient.from)),
            (to, quote!(*gradient.to)),
        ];
        let moved = factors
            .into_iter()
            .filter(|(site, _)| site.motion == motion);
        let terms: Vec<TokenStream> = moved
            .map(|(site, factor)| {
                let site = &site.name;
                quote!(- fixed_rate.#site #factor)
            })
            .collect();
        let entries = assign_vector(name, &ident("term"));
        let of_line = [from, to].iter().any(|site| site.motion == motion);
        let gradient =
            of_line.then(|| quote!(let gradient = self.#name.gradient(#line, free.#distance);));
        (!terms.is_empty()).then(|| {
            let term = quote! {
                #gradient
                let term = #(#terms)*;
                #entries
            };
            term.into()
        })
    }

    fn cost(&self) -> [Operations; 3] {
        [(4, 9), (4, 4), (9, 9)].map(Operations::from)
    }
}

fn place(site: &Site) -> TokenStream {
    value_of(site, &ident("free"), &ident("fixed"))
}

fn line(form: &Along) -> TokenStream {
    let ends = form.line.each_ref().map(place);
    quote!([#(#ends),*])
}

/// A multiple of the identity.
fn diagonal(site: &Site, rows: &[Name], value: &TokenStream, write: &Write<'_>) -> TokenStream {
    let columns = indices::unknown_names(&site.name);
    let free = rows.iter().zip(&columns).filter(|_| site.is_free());
    let entries = free.map(|(row, column)| write(row, column, value.clone()));
    quote!(#(#entries)*)
}
