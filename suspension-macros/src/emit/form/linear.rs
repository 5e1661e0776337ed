//! `Linear`: a prescribed sum of coordinates, or a prescribed scalar.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use suspension_listing::form::{Linear, Term};
use suspension_listing::name::Name;
use suspension_listing::system::{AXES, Equation, SiteMotion, System};

use super::{Emit, Operations, Rows, Write};
use crate::emit::indices;
use crate::emit::terms::{assign, ident, value_of};

impl Emit for Linear {
    fn of_points(&self, _name: &Name, _system: &System) -> TokenStream {
        TokenStream::new()
    }

    fn of_lengths(&self, _name: &Name, _system: &System) -> TokenStream {
        TokenStream::new()
    }

    fn residual(&self, name: &Name) -> Rows {
        let terms = self.terms.iter().map(|term| {
            let (site, axis) = (
                value_of(&term.site, &ident("free"), &ident("fixed")),
                ident(AXES[term.axis]),
            );
            (term.factor, quote!(#site.#axis))
        });
        let scalar = self.scalar.iter().map(|scalar| (1.0, quote!(free.#scalar)));
        let terms = terms.chain(scalar);
        let (sum, drive) = (sum(terms), &self.drive);
        assign(name, &quote!(#sum - drives.#drive)).into()
    }

    fn jacobian(&self, equation: &Equation, write: &Write<'_>) -> TokenStream {
        let scalar = self.scalar.iter();
        let scalar = scalar.map(|scalar| write(&equation.named.name, scalar, quote!(T::one())));
        let free = self.terms.iter().filter(|term| term.site.is_free());
        let entries = free.map(|Term { factor, site, axis }| {
            let column = &indices::unknown_names(&site.name)[*axis];
            let value = match factor {
                1.0 => quote!(T::one()),
                -1.0 => quote!(-T::one()),
                factor => constant(*factor),
            };
            write(&equation.named.name, column, value)
        });
        quote!(#(#entries)* #(#scalar)*)
    }

    fn curvature(&self, _name: &Name) -> Option<Rows> {
        None
    }

    /// `drive_rate` less the terms' rates.
    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<Rows> {
        let drive = &self.drive;
        let of_drive =
            (motion == SiteMotion::DrivenAnchor).then(|| (1.0, quote!(drive_rate.#drive)));
        let moved = self.terms.iter().filter(|term| term.site.motion == motion);
        let rates = moved.map(|Term { factor, site, axis }| {
            let (site, axis) = (&site.name, ident(AXES[*axis]));
            (-factor, quote!(fixed_rate.#site.#axis))
        });
        let (plus, less): (Vec<_>, Vec<_>) = rates.partition(|(factor, _)| *factor > 0.0);
        let terms: Vec<_> = of_drive.into_iter().chain(plus).chain(less).collect();
        (!terms.is_empty()).then(|| assign(name, &sum(terms.into_iter())).into())
    }

    fn cost(&self) -> [Operations; 3] {
        let terms = self.terms.len() + usize::from(self.scalar.is_some());
        let scaled = self.terms.iter().filter(|term| term.factor.abs() != 1.0);
        [(scaled.count(), terms), (0, 0), (0, 0)].map(Operations::from)
    }
}

/// A sum of terms, each with its factor.
fn sum(terms: impl Iterator<Item = (f64, TokenStream)>) -> TokenStream {
    let mut sum = TokenStream::new();
    for (factor, term) in terms {
        let sign = if factor < 0.0 {
            quote!(-)
        } else if sum.is_empty() {
            quote!()
        } else {
            quote!(+)
        };
        let size = (factor.abs() != 1.0).then(|| {
            let size = constant(factor.abs());
            quote!(#size *)
        });
        sum.extend(quote!(#sign #size #term));
    }
    sum
}

pub(crate) fn constant(number: f64) -> TokenStream {
    let number = Literal::f64_unsuffixed(number);
    quote!(T::constant(#number))
}
