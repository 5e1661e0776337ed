//! All points and their rates from the unknowns, and the roles of wheel and kingpin.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::form;
use super::terms::{ident, parameter, value_of};
use suspension_listing::name::Name;
use suspension_listing::system::{Marker, System, Wheel};

/// `points`, `velocities`, `accelerations` and `unknowns` of `impl Linkage`.
pub(super) fn points(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let unknowns = unknowns(system);
    let points = all_points(
        system,
        "free",
        "fixed",
        |_, frame| quote!(position(&#frame)),
    );
    let [velocities, accelerations] = [velocities(system), accelerations(system)];
    quote! {
        fn points(&self, q: &SVector<T, #n>, fixed: &Fixed<T>) -> Points<T> {
            let free = Free::of(q);
            #points
        }

        #velocities

        #accelerations

        fn unknowns(&self, points: &Points<T>) -> SVector<T, #n> {
            #unknowns
        }
    }
}

/// The free points' coordinates and the scalars, from the struct `points`.
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

fn velocities(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let velocities = all_points(system, "rate", "fixed_rate", |marker, rate| {
        let frame = frame_of(marker, &quote!(at));
        quote!(velocity(&#frame, &#rate))
    });
    let at = parameter("at", &quote!(&Points<T>), &velocities);
    quote! {
        fn velocities(
            &self,
            #at,
            velocity: &SVector<T, #n>,
            fixed_rate: &Fixed<T>,
        ) -> Points<T> {
            let rate = Free::of(velocity);
            #velocities
        }
    }
}

fn accelerations(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let (second_rate, fixed) = ("second_rate", "fixed_second_rate");
    let accelerations = all_points(system, second_rate, fixed, |marker, second_rate| {
        let [frame, rate] = ["at", "velocities"].map(|points| {
            let points = ident(points);
            frame_of(marker, &quote!(#points))
        });
        quote!(acceleration(&#frame, &#rate, &#second_rate))
    });
    let [at, rate] =
        ["at", "velocities"].map(|name| parameter(name, &quote!(&Points<T>), &accelerations));
    quote! {
        fn accelerations(
            &self,
            #at,
            #rate,
            acceleration: &SVector<T, #n>,
            fixed_second_rate: &Fixed<T>,
        ) -> Points<T> {
            let second_rate = Free::of(acceleration);
            #accelerations
        }
    }
}

/// A `Points` from the structs `free` and `fixed`, each marker computed by a method of its
/// constants from the frame that carries it.
fn all_points(
    system: &System,
    free: &str,
    fixed: &str,
    method: impl Fn(&Marker, TokenStream) -> TokenStream,
) -> TokenStream {
    let (free, fixed) = (ident(free), ident(fixed));
    let on_chassis = system.fixed.iter().map(|point| &point.named.name);
    let unknown = system.free.iter().map(|point| &point.named.name);
    let markers = system.markers.iter().map(|marker| {
        let points = marker
            .frame
            .iter()
            .map(|site| value_of(site, &free, &fixed));
        let name = &marker.named.name;
        let call = method(marker, quote!(Frame::new(#(#points),*)));
        quote!(#name: self.#name.#call)
    });
    quote! {
        Points {
            #(#on_chassis: #fixed.#on_chassis,)*
            #(#unknown: #free.#unknown,)*
            #(#markers,)*
        }
    }
}

/// The frame that carries a marker, from one struct of points.
pub(super) fn frame_of(marker: &Marker, points: &TokenStream) -> TokenStream {
    let names = marker.frame.iter().map(|site| &site.name);
    quote!(Frame::new(#(#points.#names),*))
}

/// `wheel_axis`, `wheel_carrier` and `kingpin` of `impl Linkage`: the first wheel's.
pub(super) fn roles(system: &System) -> TokenStream {
    let wheel = system.wheels.first();
    let kingpin = wheel.and_then(|wheel| wheel.kingpin.as_ref());
    let [axis, carrier, kingpin] = [
        role("wheel_axis", 2, wheel.map(|wheel| wheel.axis.as_slice())),
        role(
            "wheel_carrier",
            3,
            wheel.map(|wheel| wheel.carrier.as_slice()),
        ),
        role("kingpin", 2, kingpin.map(|axis| axis.as_slice())),
    ];
    quote!(#axis #carrier #kingpin)
}

fn role(name: &str, count: usize, points: Option<&[Name]>) -> TokenStream {
    let (name, count) = (ident(name), Literal::usize_unsuffixed(count));
    let body = match points {
        Some(names) => quote!(Some([#(points.#names),*])),
        None => quote!(None),
    };
    let points = parameter("points", &quote!(&Points<T>), &body);
    quote! {
        #[inline]
        fn #name(&self, #points) -> Option<[Vector3<T>; #count]> {
            #body
        }
    }
}

/// `impl HasWheel` and `impl HasKingpin` of the first wheel, where the listing states them.
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
