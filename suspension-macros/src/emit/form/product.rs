//! `Product`: two lines at an angle that stays.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use suspension_listing::form::Product;
use suspension_listing::name::Name;
use suspension_listing::system::{Site, SiteMotion, System};

use super::ends::vectors_at;
use super::{Emit, Operations};
use crate::emit::fields::point_index;
use crate::emit::gradient::{By, Gradient};
use crate::emit::lengths::kept_length;
use crate::emit::terms::{assign, line};

impl Emit for Product {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Product))
    }

    fn constant_from_points(&self, _name: &Name, system: &System) -> TokenStream {
        let [_, [_, end]] = &self.lines;
        let index = point_index(system, &end.name);
        let lines = vectors_at(&self.lines);
        quote!(parts::product(#index, [#(#lines),*])?)
    }

    fn constant_from_lengths(&self, name: &Name, system: &System) -> TokenStream {
        let [_, [_, end]] = &self.lines;
        let index = point_index(system, &end.name);
        let lengths = self.lines.each_ref();
        let lengths = lengths.map(|[from, to]| kept_length(system, [from, to]));
        quote!(parts::product_at(#index, &self.#name, [#(#lengths),*])?)
    }

    fn residual(&self, name: &Name) -> TokenStream {
        let lines = lines(self, "free", "fixed");
        assign(name, &quote!(self.#name.residual(#(#lines),*)))
    }

    fn gradient(&self, name: &Name) -> Gradient<'_> {
        let [first, second] = lines(self, "free", "fixed");
        let by = signed(self).map(|(line, site, is_end)| {
            let gradient = quote!(gradient[#line]);
            By::Point(
                site,
                if is_end {
                    gradient
                } else {
                    quote!(opposite(#gradient))
                },
            )
        });
        Gradient {
            statements: quote! {
                let gradient = [self.#name.gradient(#second), self.#name.gradient(#first)];
            },
            by: by.collect(),
        }
    }

    fn curvature(&self, name: &Name) -> Option<TokenStream> {
        let changes = ["v", "w"].map(|rate| {
            let lines = lines(self, rate, &format!("{rate}_fixed"));
            quote!([#(#lines),*])
        });
        Some(assign(name, &quote!(self.#name.curvature(#(#changes),*))))
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<TokenStream> {
        let moved = signed(self).filter(|(_, site, _)| site.motion == motion);
        let mut sum = TokenStream::new();
        for (line, site, is_end) in moved {
            let (point, is_first) = (&site.name, sum.is_empty());
            // The rates are on the other side of the equation, hence the sign.
            let sign = match (is_end, is_first) {
                (true, _) => quote!(-),
                (false, true) => quote!(),
                (false, false) => quote!(+),
            };
            sum.extend(quote!(#sign dot(gradient[#line], fixed_rate.#point)));
        }
        let statements = self.gradient(name).statements;
        (!sum.is_empty()).then(|| {
            let row = assign(name, &sum);
            quote!(#statements #row)
        })
    }

    fn cost(&self) -> [Operations; 3] {
        [(5, 9), (6, 6), (7, 17)].map(Operations::from)
    }
}

/// Both lines, from two structs of points.
fn lines(form: &Product, free: &str, fixed: &str) -> [TokenStream; 2] {
    let lines = form.lines.each_ref();
    lines.map(|ends| line(ends.each_ref(), free, fixed))
}

/// Each end, with the index of its line and whether it is the last.
fn signed(form: &Product) -> impl Iterator<Item = (Literal, &Site, bool)> {
    let lines = form.lines.iter().enumerate();
    lines.flat_map(|(line, [from, to])| {
        let line = Literal::usize_unsuffixed(line);
        [(line.clone(), from, false), (line, to, true)]
    })
}
