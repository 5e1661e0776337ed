//! Points that links alone make a rigid body: their shape, and whether one is mirrored.

use proc_macro2::TokenStream;
use quote::quote;

use super::fields::point_index;
use super::frames;
use super::terms::{Binding, bind, ident, position_parameters, value_of};
use suspension_listing::name::Name;
use suspension_listing::system::{Body, Site, System, carried_name, distance_between, frame_name};

/// A clustered point: the constant's name, the point, and its cluster.
struct Clustered<'a> {
    constant: Name,
    point: &'a Site,
    cluster: &'a Body,
}

fn clustered(system: &System) -> impl Iterator<Item = Clustered<'_>> {
    system.clusters.iter().flat_map(|cluster| {
        cluster.carried.iter().map(move |point| Clustered {
            constant: carried_name(&cluster.name, &point.name),
            point,
            cluster,
        })
    })
}

/// `frame` and constants from the design: the code before the model, and the fields of the model.
pub(super) fn designed(system: &System) -> [TokenStream; 2] {
    let frames = system.clusters.iter().map(|cluster| {
        let name = frame_name(&cluster.name);
        let third = point_index(system, &cluster.frame[2].name);
        let frame = frames::frame_from_points(system, &cluster.frame, &quote!(at));
        quote!(let #name = parts::frame(#third, #frame)?;)
    });
    let names = frame_names(system);
    let linked = clustered(system).map(
        |Clustered {
             constant,
             point,
             cluster,
         }| {
            let (frame, point) = (frame_name(&cluster.name), &point.name);
            let index = point_index(system, point);
            quote!(#constant: parts::linked(#index, at.#point, &#frame)?)
        },
    );
    [quote!(#(#frames)*), quote!(#(#names,)* #(#linked,)*)]
}

/// The same code from lengths.
pub(super) fn build_from_lengths(system: &System) -> [TokenStream; 2] {
    let frames = system.clusters.iter().map(|cluster| {
        let (name, [a, b, c]) = (frame_name(&cluster.name), &cluster.frame);
        let third = point_index(system, &c.name);
        let edges = [[a, b], [a, c], [b, c]].map(|ends| length(system, ends));
        quote!(let #name = parts::frame_of_lengths(#third, [#(#edges),*])?;)
    });
    let names = frame_names(system);
    let linked = clustered(system).map(
        |Clustered {
             constant,
             point,
             cluster,
         }| {
            let frame = frame_name(&cluster.name);
            let reaches = cluster
                .frame
                .iter()
                .map(|corner| length(system, [point, corner]));
            let index = point_index(system, &point.name);
            quote!(#constant: parts::linked_at(#index, &self.#constant, &#frame, [#(#reaches),*])?)
        },
    );
    [quote!(#(#frames)*), quote!(#(#names,)* #(#linked,)*)]
}

fn frame_names(system: &System) -> impl Iterator<Item = Name> {
    system
        .clusters
        .iter()
        .map(|cluster| frame_name(&cluster.name))
}

/// The given length between two points or, if both are on the chassis, their present distance.
pub(super) fn length(system: &System, [a, b]: [&Site; 2]) -> TokenStream {
    match distance_between(&system.equations, &a.name, &b.name) {
        Some(name) => quote!(lengths.#name),
        None => {
            let (a, b) = (&a.name, &b.name);
            quote!((self.fixed.#b - self.fixed.#a).norm())
        }
    }
}

/// The names and types of the model's constants.
pub(super) fn constants(system: &System) -> impl Iterator<Item = (Name, TokenStream)> {
    let frames = frame_names(system).map(|name| (name, quote!(Frame)));
    let points = clustered(system).map(|clustered| (clustered.constant, quote!(Linked)));
    frames.chain(points)
}

/// `linked` and `mirrored` of `impl Linkage`, if there are clusters.
pub(super) fn watched(system: &System) -> Option<TokenStream> {
    clustered(system).next()?;
    let (free, fixed) = (&ident("free"), &ident("fixed"));
    let places = clustered(system).map(|clustered| point_index(system, &clustered.point.name));
    let frames = system.clusters.iter().map(|cluster| {
        let frame = frames::frame_from_free(system, &cluster.frame, free, fixed);
        Binding::new(&frame_name(&cluster.name), frame)
    });
    let values = clustered(system).map(
        |Clustered {
             constant,
             point,
             cluster,
         }| {
            let (point, frame) = (value_of(point, free, fixed), frame_name(&cluster.name));
            quote!(self.#constant.mirrored(#point, &#frame))
        },
    );
    let bindings = [Binding::free(free, "q")].into_iter().chain(frames);
    let body = bind(bindings.collect(), quote!([#(#values),*].into_iter()));
    let [q, fixed] = position_parameters(system, &body);
    Some(quote! {
        #[inline(always)]
        fn linked(&self) -> impl Iterator<Item = usize> {
            [#(#places),*].into_iter()
        }

        #[inline(always)]
        fn mirrored(&self, #q, #fixed) -> impl Iterator<Item = T> {
            #body
        }
    })
}
