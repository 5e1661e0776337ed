//! `Along`: a point on a line, or in a plane.

use proc_macro2::{Literal, TokenStream};
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
        Some(match self.ends.as_slice() {
            [_] => quote!(OnLine),
            _ => quote!(InPlane),
        })
    }

    fn has_length(&self) -> bool {
        true
    }

    fn of_points(&self, _name: &Name, system: &System) -> TokenStream {
        let from = &self.from.name;
        let ends: Vec<&Name> = self.ends.iter().map(|end| &end.name).collect();
        let last = ends.last().map(|last| point_index(system, last));
        match ends.as_slice() {
            [to] => quote!(parts::line(#last, (design.#to - design.#from).norm())?),
            ends => quote!(parts::plane(#last, Frame::new(design.#from, #(design.#ends),*))?),
        }
    }

    /// Of a plane the lengths are no more than units of the distances.
    fn of_lengths(&self, name: &Name, system: &System) -> TokenStream {
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

    fn residual(&self, name: &Name) -> Rows {
        let (point, from, ends) = (place(&self.point), place(&self.from), ends(self));
        let entries = assign_vector(name, &ident("term"));
        let term = quote! {
            let term = self.#name.residual(#point, #from, #ends);
            #entries
        };
        term.into()
    }

    fn jacobian(&self, equation: &Equation, write: &Write<'_>) -> TokenStream {
        let rows = equation.rows();
        let gradient = gradient(self, &equation.named.name);
        let point = diagonal(&self.point, &rows, &quote!(T::one()), write);
        let from = diagonal(&self.from, &rows, &quote!(gradient.from), write);
        let lines = self.ends.iter().zip(&self.distances).enumerate();
        let lines = lines.map(|(line, (to, distance))| {
            let line = Literal::usize_unsuffixed(line);
            let to = diagonal(to, &rows, &quote!(gradient.lines[#line].0), write);
            let by_distance = rows.iter().zip(["x", "y", "z"].map(ident));
            let by_distance = by_distance
                .map(|(row, axis)| write(row, distance, quote!(gradient.lines[#line].1.#axis)));
            quote!(#to #(#by_distance)*)
        });
        quote! {
            #gradient
            #point
            #from
            #(#lines)*
        }
    }

    fn curvature(&self, name: &Name) -> Option<Rows> {
        let changes = ["v", "w"].map(|rate| {
            let (free, fixed) = (ident(rate), ident(&format!("{rate}_fixed")));
            let from = value_of(&self.from, &free, &fixed);
            let lines = self.ends.iter().zip(&self.distances).map(|(to, distance)| {
                let to = value_of(to, &free, &fixed);
                quote!((difference(#to, #from), #free.#distance))
            });
            quote!([#(#lines),*])
        });
        let entries = assign_vector(name, &ident("term"));
        let term = quote! {
            let term = self.#name.curvature(#(#changes),*);
            #entries
        };
        Some(term.into())
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<Rows> {
        let ends = self.ends.iter().enumerate().map(|(line, to)| {
            let line = Literal::usize_unsuffixed(line);
            (to, quote!(*gradient.lines[#line].0))
        });
        let lines = [(&self.from, quote!(*gradient.from))]
            .into_iter()
            .chain(ends);
        let of_motion = |(site, _): &(&Site, TokenStream)| site.motion == motion;
        let lines: Vec<(&Site, TokenStream)> = lines.filter(of_motion).collect();
        let gradient = (!lines.is_empty()).then(|| gradient(self, name));
        let point = [(&self.point, quote!())].into_iter().filter(of_motion);
        let terms: Vec<TokenStream> = point
            .chain(lines)
            .map(|(site, factor)| {
                let site = &site.name;
                quote!(- fixed_rate.#site #factor)
            })
            .collect();
        let entries = assign_vector(name, &ident("term"));
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

fn gradient(form: &Along, name: &Name) -> TokenStream {
    let (from, ends) = (place(&form.from), ends(form));
    quote!(let gradient = self.#name.gradient(#from, #ends);)
}

/// A multiple of the identity.
fn diagonal(site: &Site, rows: &[Name], value: &TokenStream, write: &Write<'_>) -> TokenStream {
    let columns = indices::unknown_names(&site.name);
    let free = rows.iter().zip(&columns).filter(|_| site.is_free());
    let entries = free.map(|(row, column)| write(row, column, value.clone()));
    quote!(#(#entries)*)
}
