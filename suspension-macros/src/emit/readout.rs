//! All points and their rates from the unknowns, and the roles of wheel and kingpin.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::terms::{ident, parameter};
use super::{form, frames};
use suspension_listing::name::Name;
use suspension_listing::system::{System, Wheel};

/// All points from their parts, and the frames made from them.
pub(super) fn points_impl(system: &System) -> TokenStream {
    let fixed = system.fixed.iter().map(|point| &point.named.name);
    let free = system.free.iter().map(|point| &point.named.name);
    let count = Literal::usize_unsuffixed(system.markers.len());
    let markers = system.markers.iter().enumerate().map(|(index, marker)| {
        let (name, index) = (&marker.named.name, Literal::usize_unsuffixed(index));
        quote!(#name: markers[#index])
    });
    let points = quote!(Self {
        #(#fixed: fixed.#fixed,)*
        #(#free: free.#free,)*
        #(#markers,)*
    });
    let parameters = [
        ("fixed", quote!(&Fixed<T>)),
        ("free", quote!(&Free<T>)),
        ("markers", quote!([Vector3<T>; #count])),
    ];
    let parameters = parameters.map(|(name, kind)| parameter(name, &kind, &points));
    let frames = frames::methods_of_points(system);
    quote! {
        impl<T: Scalar> Points<T> {
            #[inline(always)]
            fn all(#(#parameters),*) -> Self {
                #points
            }

            #frames
        }
    }
}

/// `points`, `velocities`, `accelerations` and `unknowns` of `impl Linkage`.
pub(super) fn points(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let unknowns = unknowns(system);
    let carry_forces = carry_forces(system);
    let [points, velocities, accelerations] = [
        ("position", "fixed", [].as_slice()),
        ("velocity", "fixed_rate", &["at"]),
        ("acceleration", "fixed_second_rate", &["at", "velocities"]),
    ]
    .map(|(method, fixed, before)| markers(system, method, fixed, before));
    let at = parameter("at", &quote!(&Points<T>), &velocities);
    let [at_and, rate] =
        ["at", "velocities"].map(|name| parameter(name, &quote!(&Points<T>), &accelerations));
    quote! {
        fn points(&self, q: &SVector<T, #n>, fixed: &Fixed<T>) -> Points<T> {
            let free = Free::of(q);
            let markers = #points;
            Points::all(fixed, &free, markers)
        }

        fn velocities(
            &self,
            #at,
            velocity: &SVector<T, #n>,
            fixed_rate: &Fixed<T>,
        ) -> Points<T> {
            let free = Free::of(velocity);
            let markers = #velocities;
            Points::all(fixed_rate, &free, markers)
        }

        fn accelerations(
            &self,
            #at_and,
            #rate,
            acceleration: &SVector<T, #n>,
            fixed_second_rate: &Fixed<T>,
        ) -> Points<T> {
            let free = Free::of(acceleration);
            let markers = #accelerations;
            Points::all(fixed_second_rate, &free, markers)
        }

        #carry_forces

        fn unknowns(&self, points: &Points<T>) -> SVector<T, #n> {
            #unknowns
        }
    }
}

/// The markers by a method of their constants, from the frame that carries each. The frame is taken from structs of
/// points, and last from `free` and `fixed`.
fn markers(system: &System, method: &str, fixed: &str, before: &[&str]) -> TokenStream {
    let (method, free, fixed) = (ident(method), ident("free"), ident(fixed));
    let markers = system.markers.iter().map(|marker| {
        let name = &marker.named.name;
        let before = before.iter().map(|points| {
            let points = ident(points);
            frames::frame_from_points(system, &marker.frame, &quote!(#points))
        });
        let last = frames::frame_from_free(system, &marker.frame, &free, &fixed);
        quote!(self.#name.#method(#(&#before,)* &#last))
    });
    quote!([#(#markers),*])
}

/// `carry_forces`, if there are markers.
fn carry_forces(system: &System) -> Option<TokenStream> {
    let (forces, free, fixed) = (ident("forces"), ident("free"), ident("fixed"));
    let markers = system.markers.iter().map(|marker| {
        let name = &marker.named.name;
        let frame = frames::frame_from_free(system, &marker.frame, &free, &fixed);
        let at_frame = marker.frame.iter().map(|site| &site.name);
        quote!(self.#name.carry_force(#forces.#name, &#frame, [#(&mut #forces.#at_frame),*]);)
    });
    let body = quote!(#(#markers)*);
    let n = Literal::usize_unsuffixed(system.size());
    let of_chassis = parameter("fixed", &quote!(&Fixed<T>), &body);
    (!system.markers.is_empty()).then(|| {
        quote! {
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn carry_forces(&self, q: &SVector<T, #n>, #of_chassis, #forces: &mut Points<T>) {
                let #free = Free::of(q);
                #body
            }
        }
    })
}

/// The coordinates of the free points and the scalars, from the struct `points`.
fn unknowns(system: &System) -> TokenStream {
    let free: Vec<&Name> = system.free.iter().map(|point| &point.named.name).collect();
    let names = &system.scalars;
    let scalars = form::scalars(system, &|site| {
        let name = &site.name;
        quote!(points.#name)
    });
    if scalars.is_empty() {
        return quote!(Free { #(#free: points.#free),* }.unknowns());
    }
    quote! {
        let mut free = Free { #(#free: points.#free,)* #(#names: T::zero()),* };
        #(#scalars)*
        free.unknowns()
    }
}

/// `impl HasWheel` and `impl HasKingpin` for the first wheel, if the listing states them.
pub(super) fn roles_of_points(system: &System) -> TokenStream {
    let first = system.wheels.first();
    let wheel = first.map(|Wheel { axis, carrier, .. }| {
        quote! {
            impl<T: Scalar> HasWheel<T> for Points<T> {
                fn wheel(&self) -> [Vector3<T>; 2] {
                    [#(self.#axis),*]
                }

                fn carrier(&self) -> [Vector3<T>; 3] {
                    [#(self.#carrier),*]
                }
            }
        }
    });
    let kingpin = first.and_then(|wheel| wheel.kingpin.as_ref()).map(|axis| {
        quote! {
            impl<T: Scalar> HasKingpin<T> for Points<T> {
                fn kingpin(&self) -> [Vector3<T>; 2] {
                    [#(self.#axis),*]
                }
            }
        }
    });
    quote!(#wheel #kingpin)
}
