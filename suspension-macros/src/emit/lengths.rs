//! Constant lengths: into the model, and out of it.

use proc_macro2::TokenStream;
use quote::quote;

use super::{clusters, fields, form};
use suspension_listing::name::Name;
use suspension_listing::system::{Body, System, carried_name, frame_name, pair_name};

/// The distances that equations keep.
pub(super) fn distances(system: &System) -> impl Iterator<Item = &Name> {
    let equations = system.equations.iter();
    let kept = equations.filter(|equation| equation.form.equations().keeps().is_some());
    kept.map(|equation| &equation.named.name)
}

/// The length of a frame's edge: given, or where both ends are on the chassis, as it stands.
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
            let value = form.of_lengths(name, system);
            quote!(#name: #value)
        })
    });
    let [cluster_frames, clustered] = clusters::of_lengths(system);
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
