//! `Along`: a point on a line, or in a plane.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use suspension_listing::form::Along;
use suspension_listing::name::Name;
use suspension_listing::system::{Site, SiteMotion, System};

use super::{Emit, Operations};
use crate::emit::fields::point_index;
use crate::emit::gradient::{By, Gradient};
use crate::emit::lengths::kept_length;
use crate::emit::terms::{assign_vector, ident, value_of};

impl Emit for Along {
    fn constant(&self) -> Option<TokenStream> {
        Some(match self.ends.as_slice() {
            [_] => quote!(OnLine),
            _ => quote!(InPlane),
        })
    }

    fn has_length(&self) -> bool {
        true
    }

    fn constant_from_points(&self, _name: &Name, system: &System) -> TokenStream {
        let from = &self.from.name;
        let ends: Vec<&Name> = self.ends.iter().map(|end| &end.name).collect();
        let last = ends.last().map(|last| point_index(system, last));
        match ends.as_slice() {
            [to] => quote!(parts::line(#last, (at.#to - at.#from).norm())?),
            ends => quote!(parts::plane(#last, Frame::new(at.#from, #(at.#ends),*))?),
        }
    }

    /// For a plane the lengths are only units of the distances.
    fn constant_from_lengths(&self, name: &Name, system: &System) -> TokenStream {
        let [to] = self.ends.as_slice() else {
            return quote!(self.#name);
        };
        let (index, length) = (
            point_index(system, &to.name),
            kept_length(system, [&self.from, to]),
        );
        quote!(parts::line(#index, #length)?)
    }

    fn scalars(&self, name: &Name, place: &dyn Fn(&Site) -> TokenStream) -> Option<TokenStream> {
        let [point, from] = [&self.point, &self.from].map(place);
        let ends = self.ends.iter().map(place);
        let distances = &self.distances;
        Some(quote! {
            [#(free.#distances),*] = self.#name.distances(#point, #from, [#(#ends),*]);
        })
    }

    fn residual(&self, name: &Name) -> TokenStream {
        let (point, from, ends) = (place(&self.point), place(&self.from), ends(self));
        assign_vector(name, &quote!(self.#name.residual(#point, #from, #ends)))
    }

    fn gradient(&self, name: &Name) -> Gradient<'_> {
        let (from, ends) = (place(&self.from), ends(self));
        let mut by = vec![
            By::Diagonal(&self.point, quote!(T::one())),
            By::Diagonal(&self.from, quote!(gradient.from)),
        ];
        let lines = self.ends.iter().zip(&self.distances).enumerate();
        by.extend(lines.flat_map(|(line, (to, distance))| {
            let line = Literal::usize_unsuffixed(line);
            [
                By::Diagonal(to, quote!(gradient.lines[#line].0)),
                By::ScalarOfThree(distance, quote!(gradient.lines[#line].1)),
            ]
        }));
        Gradient {
            statements: quote!(let gradient = self.#name.gradient(#from, #ends);),
            by,
        }
    }

    fn curvature(&self, name: &Name) -> Option<TokenStream> {
        let changes = ["v", "w"].map(|rate| {
            let (free, fixed) = (ident(rate), ident(&format!("{rate}_fixed")));
            let from = value_of(&self.from, &free, &fixed);
            let lines = self.ends.iter().zip(&self.distances).map(|(to, distance)| {
                let to = value_of(to, &free, &fixed);
                quote!((difference(#to, #from), #free.#distance))
            });
            quote!([#(#lines),*])
        });
        let [v, w] = changes;
        Some(assign_vector(name, &quote!(self.#name.curvature(#v, #w))))
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<TokenStream> {
        let ends = self.ends.iter().enumerate().map(|(line, to)| {
            let line = Literal::usize_unsuffixed(line);
            (to, quote!(*gradient.lines[#line].0))
        });
        let lines = [(&self.from, quote!(*gradient.from))]
            .into_iter()
            .chain(ends);
        let of_motion = |(site, _): &(&Site, TokenStream)| site.motion == motion;
        let lines: Vec<(&Site, TokenStream)> = lines.filter(of_motion).collect();
        let gradient = (!lines.is_empty()).then(|| self.gradient(name).statements);
        let point = [(&self.point, quote!())].into_iter().filter(of_motion);
        let terms: Vec<TokenStream> = point
            .chain(lines)
            .map(|(site, factor)| {
                let site = &site.name;
                quote!(- fixed_rate.#site #factor)
            })
            .collect();
        (!terms.is_empty()).then(|| {
            let rows = assign_vector(name, &quote!(#(#terms)*));
            quote!(#gradient #rows)
        })
    }

    fn cost(&self) -> [Operations; 3] {
        let lines = self.ends.len();
        [
            (4 * lines, 3 + 6 * lines),
            (4 * lines, 4 * lines),
            (9 * lines, 12 * lines),
        ]
        .map(Operations::from)
    }
}

fn place(site: &Site) -> TokenStream {
    value_of(site, &ident("free"), &ident("fixed"))
}

/// The lines' other ends, each with its distance.
fn ends(form: &Along) -> TokenStream {
    let ends = form.ends.iter().map(place);
    let distances = &form.distances;
    quote!([#((#ends, free.#distances)),*])
}
