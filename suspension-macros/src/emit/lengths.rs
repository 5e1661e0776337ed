//! Constant lengths, written to the model and read from it.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{clusters, fields, form};
use suspension_listing::name::Name;
use suspension_listing::system::{
    Body, Site, System, carried_name, distance_between, frame_name, pair_name,
};

/// The distances that equations keep.
pub(super) fn distances(system: &System) -> impl Iterator<Item = &Name> {
    let equations = system.equations.iter();
    let kept = equations.filter(|equation| equation.form.equations().keeps().is_some());
    kept.map(|equation| &equation.named.name)
}

/// The length of a frame's edge: the given length or, if both ends are on the chassis, their present distance.
fn edge(body: &Body, index: usize, given: &TokenStream) -> TokenStream {
    let [a, b] = body.frame_pairs()[index];
    if a.is_free() || b.is_free() {
        let name = pair_name(&body.name, &a.name, &b.name);
        quote!(#given.#name)
    } else {
        let (a, b) = (&a.name, &b.name);
        quote!((self.fixed.#b - self.fixed.#a).norm())
    }
}

/// The length between two sites that nothing moves relative to each other: the given length, their present distance
/// on the chassis, or their distance in the body that carries both.
pub(super) fn kept_length(system: &System, ends: [&Site; 2]) -> TokenStream {
    let [a, b] = ends;
    let lists = |body: &&Body| {
        ends.iter()
            .all(|end| body.points().any(|p| p.name == end.name))
    };
    let is_given = distance_between(&system.equations, &a.name, &b.name).is_some();
    match system.bodies.iter().find(lists) {
        Some(body) if !is_given && (a.is_free() || b.is_free()) => {
            let [a, b] = ends.map(|end| point_at_rest(system, body, end));
            quote!((#b - #a).norm())
        }
        _ => clusters::length(system, ends),
    }
}

/// A point of a body at rest whose frame has the given lengths.
fn point_at_rest(system: &System, body: &Body, site: &Site) -> TokenStream {
    let frame = frame_name(&body.name);
    let mut points = body.frame.iter();
    if let Some(index) = points.position(|point| point.name == site.name) {
        let index = Literal::usize_unsuffixed(index);
        return quote!(#frame.points()[#index]);
    }
    let name = carried_name(&body.name, &site.name);
    let mut constants = form::constants(system, true);
    let carried = constants.find(|constant| *constant.name == name);
    let carried = carried.map(|constant| constant.form.constant_from_lengths(&name, system));
    quote!(#carried.position(&#frame))
}

pub(super) fn with_lengths(system: &System) -> TokenStream {
    let frames = system.bodies.iter().map(|body| {
        let name = frame_name(&body.name);
        let [.., third] = &body.frame;
        let third = fields::point_index(system, &third.name);
        let edges = (0..3).map(|index| edge(body, index, &quote!(lengths)));
        quote!(let #name = parts::frame_of_lengths(#third, [#(#edges),*])?;)
    });
    let frame_names = system.bodies.iter().map(|body| frame_name(&body.name));
    let [stated, framed] = [false, true].map(|framed| {
        let constants = form::constants(system, framed);
        constants.map(|form::Constant { name, form, .. }| {
            let value = form.constant_from_lengths(name, system);
            quote!(#name: #value)
        })
    });
    let [cluster_frames, clustered] = clusters::build_from_lengths(system);
    quote! {
        fn with_lengths(self, lengths: &Lengths<T>) -> Result<Self, GeometryError> {
            parts::positive(lengths.values())?;
            #(#frames)*
            #cluster_frames
            let model = Self {
                #(#stated,)*
                #(#frame_names,)*
                #(#framed,)*
                #clustered
                ..self
            };
            Ok(model.sized())
        }
    }
}

pub(super) fn lengths(system: &System) -> TokenStream {
    let fields = fields::length_fields(system);
    let names: Vec<&Name> = fields.iter().map(|field| &field.name).collect();
    let stated: Vec<&Name> = distances(system).collect();
    let of_bodies = system.bodies.iter().map(|body| {
        let frame = frame_name(&body.name);
        let edges = body.frame_pairs().map(|[a, b]| {
            let name = pair_name(&body.name, &a.name, &b.name);
            let wanted = names.iter().any(|field| **field == name) && !stated.contains(&&name);
            wanted.then_some(name)
        });
        let needed = edges.iter().any(Option::is_some);
        let edges = edges.map(|edge| edge.map_or(quote!(_), |name| quote!(#name)));
        let reaches = body.carried.iter().map(|point| {
            let name = carried_name(&body.name, &point.name);
            let lengths = body
                .frame
                .iter()
                .map(|site| pair_name(&body.name, &point.name, &site.name));
            quote!(let [#(#lengths),*] = self.#name.lengths(&self.#frame);)
        });
        let edges = needed.then(|| quote!(let [#(#edges),*] = self.#frame.lengths();));
        quote!(#edges #(#reaches)*)
    });
    let values = names.iter().map(|name| {
        if stated.contains(name) {
            quote!(#name: self.#name.length())
        } else {
            quote!(#name)
        }
    });
    let result = if names.is_empty() {
        quote!(Lengths::default())
    } else {
        quote!(Lengths { #(#values),* })
    };
    quote! {
        fn lengths(&self) -> Lengths<T> {
            #(#of_bodies)*
            #result
        }
    }
}
