//! All points and their rates from the unknowns, and the roles of wheel and kingpin.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::Ident;

use crate::system::{Marker, System, Wheel};

/// `points`, `velocities`, `accelerations` and `unknowns` of `impl Linkage`.
pub(super) fn points(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let free: Vec<&Ident> = system.free.iter().map(|point| &point.name).collect();
    let points = all_points(system, |marker| {
        let frame = frame_of_sites(marker);
        quote!(position(&#frame))
    });
    let velocities = all_points(system, |marker| {
        let (at, rate) = (frame_of(marker, &quote!(at)), frame_of_sites(marker));
        quote!(velocity(&#at, &#rate))
    });
    let accelerations = all_points(system, |marker| {
        let (at, rate) = (
            frame_of(marker, &quote!(at)),
            frame_of(marker, &quote!(velocities)),
        );
        let second_rate = frame_of_sites(marker);
        quote!(acceleration(&#at, &#rate, &#second_rate))
    });
    quote! {
        fn points(&self, q: &SVector<T, #n>, fixed: &Fixed<T>) -> Points<T> {
            let free = Free::of(q);
            #points
        }

        fn velocities(
            &self,
            at: &Points<T>,
            velocity: &SVector<T, #n>,
            fixed: &Fixed<T>,
        ) -> Points<T> {
            let free = Free::of(velocity);
            #velocities
        }

        fn accelerations(
            &self,
            at: &Points<T>,
            velocities: &Points<T>,
            acceleration: &SVector<T, #n>,
            fixed: &Fixed<T>,
        ) -> Points<T> {
            let free = Free::of(acceleration);
            #accelerations
        }

        fn unknowns(points: &Points<T>) -> SVector<T, #n> {
            Free { #(#free: points.#free),* }.unknowns()
        }
    }
}

/// A `Points` with each marker computed by a method of its constants.
fn all_points(system: &System, marker: impl Fn(&Marker) -> TokenStream) -> TokenStream {
    let fixed = system.fixed.iter().map(|point| &point.name);
    let free = system.free.iter().map(|point| &point.name);
    let markers = system.markers.iter().map(|m| {
        let (name, call) = (&m.named.name, marker(m));
        quote!(#name: self.#name.#call)
    });
    quote! {
        Points {
            #(#fixed: fixed.#fixed,)*
            #(#free: free.#free,)*
            #(#markers,)*
        }
    }
}

/// The frame that carries a marker, from one struct of points.
pub(super) fn frame_of(marker: &Marker, points: &TokenStream) -> TokenStream {
    let names = marker.frame.iter().map(|site| &site.name);
    quote!(Frame::new(#(#points.#names),*))
}

/// The frame that carries a marker, from `free` and `fixed`.
fn frame_of_sites(marker: &Marker) -> TokenStream {
    let points = marker.frame.iter().map(|site| {
        let name = &site.name;
        if site.is_free() {
            quote!(free.#name)
        } else {
            quote!(fixed.#name)
        }
    });
    quote!(Frame::new(#(#points),*))
}

/// `impl HasWheel` and `impl HasKingpin`, where the listing states them.
pub(super) fn roles(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let wheel = system.wheel.as_ref().map(|Wheel { axis, carrier }| {
        quote! {
            impl<T: Scalar> HasWheel<#n> for Model<T> {
                fn wheel(points: &Points<T>) -> [Vector3<T>; 2] {
                    [#(points.#axis),*]
                }

                fn carrier(points: &Points<T>) -> [Vector3<T>; 3] {
                    [#(points.#carrier),*]
                }
            }
        }
    });
    let kingpin = system.kingpin.as_ref().map(|axis| {
        quote! {
            impl<T: Scalar> HasKingpin<#n> for Model<T> {
                fn kingpin(points: &Points<T>) -> [Vector3<T>; 2] {
                    [#(points.#axis),*]
                }
            }
        }
    });
    quote!(#wheel #kingpin)
}
