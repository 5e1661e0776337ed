//! Frames of three points that carry others: a method each of the structs that have the points.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Ident;

use super::terms::{Binding, ident, value_of};
use suspension_listing::name::Name;
use suspension_listing::system::{Site, System, frame_name};

type Frame = [Site; 3];

/// Each frame once, under the name of the first body, cluster or marker that has it.
fn distinct_frames(system: &System) -> Vec<(Name, &Frame)> {
    let bodies = system.bodies.iter().chain(&system.clusters);
    let bodies = bodies.map(|body| (&body.name, &body.frame));
    let markers = system.markers.iter();
    let markers = markers.map(|marker| (&marker.named.name, &marker.frame));
    let mut all: Vec<(Name, &Frame)> = Vec::new();
    for (owner, frame) in bodies.chain(markers) {
        if !all.iter().any(|(_, other)| is_same(other, frame)) {
            all.push((frame_name(owner), frame));
        }
    }
    all
}

fn is_same(a: &Frame, b: &Frame) -> bool {
    let mut pairs = a.iter().zip(b);
    pairs.all(|(a, b)| a.name == b.name)
}

/// The methods of `Points`.
pub(super) fn methods_of_points(system: &System) -> TokenStream {
    let methods = distinct_frames(system).into_iter().map(|(name, frame)| {
        let points = frame.iter().map(|site| &site.name);
        method(&name, &quote!(), &quote!(#(self.#points),*))
    });
    quote!(#(#methods)*)
}

/// The methods of `Free`, which take the chassis points if they need any.
pub(super) fn methods_of_free(system: &System) -> TokenStream {
    let methods = distinct_frames(system).into_iter().map(|(name, frame)| {
        let (free, fixed) = (super::terms::ident("self"), super::terms::ident("fixed"));
        let points = frame.iter().map(|site| value_of(site, &free, &fixed));
        let fixed = needs_chassis(frame).then(|| quote!(fixed: &Fixed<T>));
        method(&name, &quote!(#fixed), &quote!(#(#points),*))
    });
    quote!(#(#methods)*)
}

fn method(name: &Name, fixed: &TokenStream, points: &TokenStream) -> TokenStream {
    quote! {
        #[inline(always)]
        fn #name(&self, #fixed) -> Frame<T> {
            Frame::new(#points)
        }
    }
}

fn needs_chassis(frame: &Frame) -> bool {
    !frame.iter().all(Site::is_free)
}

fn name_of(system: &System, frame: &Frame) -> Name {
    let mut all = distinct_frames(system).into_iter();
    let found = all.find(|(_, other)| is_same(other, frame));
    found.map_or_else(|| Name::made(String::new()), |(name, _)| name)
}

/// A frame in the struct `points`.
pub(super) fn frame_from_points(
    system: &System,
    frame: &Frame,
    points: &TokenStream,
) -> TokenStream {
    let name = name_of(system, frame);
    quote!(#points.#name())
}

/// A frame in the structs `free` and `fixed`.
pub(super) fn frame_from_free(
    system: &System,
    frame: &Frame,
    free: &Ident,
    fixed: &Ident,
) -> TokenStream {
    let name = name_of(system, frame);
    let fixed = needs_chassis(frame).then_some(fixed);
    quote!(#free.#name(#fixed))
}

/// The free points at `q`, and the frames of the bodies there.
pub(super) fn with_free(system: &System) -> impl Iterator<Item = Binding> {
    let (free, fixed) = (&ident("free"), &ident("fixed"));
    let frames: Vec<Binding> = bindings(system, "", free, fixed).collect();
    [Binding::free(free, "q")].into_iter().chain(frames)
}

/// `body_frame = free.body_frame()` for each body that carries points.
pub(super) fn bindings<'a>(
    system: &'a System,
    suffix: &'a str,
    free: &'a Ident,
    fixed: &'a Ident,
) -> impl Iterator<Item = Binding> {
    let bodies = system.bodies.iter().filter(|body| !body.carried.is_empty());
    bodies.map(move |body| {
        let name = Name::made(format!("{}{suffix}", frame_name(&body.name)));
        Binding::new(&name, frame_from_free(system, &body.frame, free, fixed))
    })
}
