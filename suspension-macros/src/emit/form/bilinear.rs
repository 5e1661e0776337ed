//! `Bilinear`: a sum of products, which may define an unknown.

use proc_macro2::TokenStream;
use quote::quote;

use suspension_listing::form::{Bilinear, Factor, Multiplied, Variable};
use suspension_listing::name::Name;
use suspension_listing::system::{AXES, Site, SiteMotion, System};

use super::{Emit, Operations, constant};
use crate::emit::fields::point_index;
use crate::emit::gradient::{By, Gradient};
use crate::emit::lengths::kept_length;
use crate::emit::terms::{assign, ident, value_of};

impl Emit for Bilinear {
    fn constant(&self) -> Option<TokenStream> {
        Some(quote!(Bilinear))
    }

    fn constant_from_points(&self, _name: &Name, system: &System) -> TokenStream {
        let index = end(self, system);
        let lines = self.length.iter().map(|[from, to]| {
            let (from, to) = (&from.name, &to.name);
            quote!((at.#to - at.#from).norm())
        });
        quote!(parts::bilinear(#index, [#(#lines),*])?)
    }

    fn constant_from_lengths(&self, name: &Name, system: &System) -> TokenStream {
        match self.length.as_slice() {
            [[from, to]] => {
                let (index, length) = (end(self, system), kept_length(system, [from, to]));
                quote!(parts::bilinear(#index, [#length])?)
            }
            _ => quote!(self.#name),
        }
    }

    fn scalars(&self, name: &Name, place: &dyn Fn(&Site) -> TokenStream) -> Option<TokenStream> {
        let defined = self.defines.as_ref()?;
        let products = products(self, &|factor| value(factor, place));
        let constant = constant_term(self, name).unwrap_or_else(|| quote!(T::zero()));
        Some(quote!(free.#defined = -self.#name.residual(#constant, [#(#products),*]);))
    }

    fn residual(&self, name: &Name) -> TokenStream {
        let products = products(self, &|factor| value_in(factor, "free", "fixed"));
        let defined = self.defines.iter().map(|defined| quote!(free.#defined));
        let linear = defined.chain(constant_term(self, name));
        let linear = linear.reduce(|sum, term| quote!(#sum + #term));
        let linear = linear.unwrap_or_else(|| quote!(T::zero()));
        assign(
            name,
            &quote!(self.#name.residual(#linear, [#(#products),*])),
        )
    }

    fn gradient(&self, name: &Name) -> Gradient<'_> {
        let defined = self.defines.iter();
        let defined = defined.map(|defined| By::Scalar(defined, quote!(T::one())));
        let derivatives = self.derivatives().into_iter();
        let derivatives = derivatives.map(|(variable, others)| {
            let gradient = gradient(name, &others);
            match variable {
                Variable::Unknown(unknown) => By::Scalar(unknown, gradient),
                Variable::Coordinate { site, axis } => By::Coordinate(site, axis, gradient),
            }
        });
        Gradient {
            statements: TokenStream::new(),
            by: defined.chain(derivatives).collect(),
        }
    }

    fn curvature(&self, name: &Name) -> Option<TokenStream> {
        let [v, w] = ["v", "w"].map(|rate| {
            let fixed = format!("{rate}_fixed");
            products(self, &|factor| value_in(factor, rate, &fixed))
        });
        let changes = v.iter().zip(&w).map(|(v, w)| quote!([#v, #w]));
        Some(assign(name, &quote!(self.#name.curvature([#(#changes),*]))))
    }

    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<TokenStream> {
        let derivatives = self.derivatives().into_iter();
        let terms = derivatives.filter_map(|(variable, others)| match variable {
            Variable::Coordinate { site, axis } if site.motion == motion => {
                let (gradient, point) = (gradient(name, &others), &site.name);
                let axis = ident(AXES[axis]);
                // The rates are on the other side of the equation, hence the sign.
                Some(quote!(- #gradient * fixed_rate.#point.#axis))
            }
            _ => None,
        });
        let sum: TokenStream = terms.collect();
        (!sum.is_empty()).then(|| assign(name, &sum))
    }

    fn cost(&self) -> [Operations; 3] {
        let edges = |factors: &mut dyn Iterator<Item = &Factor>| {
            let edges = factors.filter(|factor| matches!(factor, Factor::Edge { .. }));
            edges.count()
        };
        let products = self.products.len();
        let scaled = self
            .products
            .iter()
            .filter(|product| product.by.abs() != 1.0);
        let scaled = scaled.count();
        let of_factors = edges(&mut self.products.iter().flat_map(|product| &product.factors));
        let derivatives = self.derivatives();
        let terms = || derivatives.iter().flat_map(|(_, others)| others);
        let scaled_terms = terms().filter(|(by, _)| by.abs() != 1.0).count();
        let of_terms = edges(&mut terms().map(|(_, factor)| *factor));
        let linear = usize::from(self.constant != 0.0);
        [
            (products + 1 + scaled, products + 1 + of_factors + linear),
            (derivatives.len() + scaled_terms, terms().count() + of_terms),
            (2 * products + 1 + 2 * scaled, 2 * products + 2 * of_factors),
        ]
        .map(Operations::from)
    }
}

/// The index of the last end of its lines.
fn end(form: &Bilinear, system: &System) -> TokenStream {
    let ends = form.length.iter().flatten();
    let index = ends.last().map(|end| point_index(system, &end.name));
    quote!(#index)
}

/// The constant beside the products.
fn constant_term(form: &Bilinear, name: &Name) -> Option<TokenStream> {
    let of_length = |size: f64| match size {
        1.0 => quote!(self.#name.length()),
        -1.0 => quote!(-self.#name.length()),
        size => {
            let size = constant(size);
            quote!(#size * self.#name.length())
        }
    };
    (form.constant != 0.0).then(|| of_length(form.constant))
}

/// Both factors of each product.
fn products(form: &Bilinear, value: &dyn Fn(&Factor) -> TokenStream) -> Vec<TokenStream> {
    let products = form.products.iter();
    let products = products.map(|Multiplied { by, factors }| {
        let [u, v] = factors.each_ref().map(value);
        let u = multiple(*by, &u);
        quote!((#u, #v))
    });
    products.collect()
}

/// The derivative with respect to the variable that `others` are multiplied by.
fn gradient(name: &Name, others: &[(f64, &Factor)]) -> TokenStream {
    let others = others.iter();
    let others = others.map(|(by, factor)| multiple(*by, &value_in(factor, "free", "fixed")));
    quote!(self.#name.gradient([#(#others),*]))
}

fn multiple(by: f64, value: &TokenStream) -> TokenStream {
    match by {
        1.0 => quote!(#value),
        -1.0 => quote!(-#value),
        by => {
            let by = constant(by);
            quote!(#by * #value)
        }
    }
}

fn value_in(factor: &Factor, free: &str, fixed: &str) -> TokenStream {
    let (free, fixed) = (ident(free), ident(fixed));
    match factor {
        Factor::Unknown(unknown) => quote!(#free.#unknown),
        Factor::Edge { .. } => value(factor, &|site| value_of(site, &free, &fixed)),
    }
}

/// A factor, with each site at `place`.
fn value(factor: &Factor, place: &dyn Fn(&Site) -> TokenStream) -> TokenStream {
    match factor {
        Factor::Unknown(unknown) => quote!(free.#unknown),
        Factor::Edge { line, axis } => {
            let ([from, to], axis) = (line.each_ref().map(place), ident(AXES[*axis]));
            quote!((#to.#axis - #from.#axis))
        }
    }
}
