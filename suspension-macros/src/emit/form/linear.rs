//! `Linear`: a prescribed sum of coordinates, or a prescribed scalar.

use std::iter;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use suspension_listing::form::{Linear, Prescribed, Term};
use suspension_listing::name::Name;
use suspension_listing::system::{AXES, Site, SiteMotion, System};

use super::{Emit, Operations};
use crate::emit::gradient::{By, Gradient};
use crate::emit::terms::{assign, ident, value_of};

impl Emit for Linear {
    fn constant(&self) -> Option<TokenStream> {
        matches!(self.prescribed, Prescribed::Design).then(|| quote!(Held))
    }

    fn constant_from_points(&self, _name: &Name, _system: &System) -> TokenStream {
        let terms = coordinates(self, |site| {
            let name = &site.name;
            quote!(at.#name)
        });
        let sum = sum(terms);
        quote!(Held::new(#sum))
    }

    /// Lengths do not determine where points are.
    fn constant_from_lengths(&self, name: &Name, _system: &System) -> TokenStream {
        quote!(self.#name)
    }

    fn residual(&self, name: &Name) -> TokenStream {
        let (free, fixed) = (ident("free"), ident("fixed"));
        let terms = coordinates(self, |site| value_of(site, &free, &fixed));
        let scalar = self.scalar.iter().map(|scalar| (1.0, quote!(free.#scalar)));
        let terms = terms.chain(scalar);
        let off = match &self.prescribed {
            Prescribed::Drive(drive) => {
                let drive = (-self.scale.recip(), quote!(drives.#drive));
                sum(terms.chain(iter::once(drive)))
            }
            Prescribed::Design => {
                let sum = sum(terms);
                quote!(self.#name.residual(#sum))
            }
        };
        assign(name, &off)
    }

    fn gradient(&self, _name: &Name) -> Gradient<'_> {
        let terms = self.terms.iter().map(|Term { factor, site, axis }| {
            let value = match factor {
                1.0 => quote!(T::one()),
                -1.0 => quote!(-T::one()),
                factor => constant(*factor),
            };
            By::Coordinate(site, *axis, value)
        });
        let scalar = self.scalar.iter();
        let scalar = scalar.map(|scalar| By::Scalar(scalar, quote!(T::one())));
        Gradient {
            statements: TokenStream::new(),
            by: terms.chain(scalar).collect(),
        }
    }

    fn curvature(&self, _name: &Name) -> Option<TokenStream> {
        None
    }

    /// `drive_rate`, if a drive prescribes the sum, minus the rates of the terms.
    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<TokenStream> {
        let of_drive = match &self.prescribed {
            Prescribed::Drive(drive) if motion == SiteMotion::DrivenAnchor => {
                Some((self.scale.recip(), quote!(drive_rate.#drive)))
            }
            _ => None,
        };
        let moved = self.terms.iter().filter(|term| term.site.motion == motion);
        let rates = moved.map(|Term { factor, site, axis }| {
            let (site, axis) = (&site.name, ident(AXES[*axis]));
            (-factor, quote!(fixed_rate.#site.#axis))
        });
        let (plus, less): (Vec<_>, Vec<_>) = rates.partition(|(factor, _)| *factor > 0.0);
        let terms: Vec<_> = of_drive.into_iter().chain(plus).chain(less).collect();
        (!terms.is_empty()).then(|| assign(name, &sum(terms.into_iter())))
    }

    fn cost(&self) -> [Operations; 3] {
        let terms = self.terms.len() + usize::from(self.scalar.is_some());
        let scaled = self.terms.iter().filter(|term| term.factor.abs() != 1.0);
        let scaled = scaled.count() + usize::from(self.scale != 1.0);
        [(scaled, terms), (0, 0), (0, 0)].map(Operations::from)
    }
}

/// The terms, each with its factor, of points at `place`.
fn coordinates(
    form: &Linear,
    place: impl Fn(&Site) -> TokenStream,
) -> impl Iterator<Item = (f64, TokenStream)> {
    form.terms.iter().map(move |term| {
        let (site, axis) = (place(&term.site), ident(AXES[term.axis]));
        (term.factor, quote!(#site.#axis))
    })
}

/// A sum of terms, each with its factor.
pub(crate) fn sum(terms: impl Iterator<Item = (f64, TokenStream)>) -> TokenStream {
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
