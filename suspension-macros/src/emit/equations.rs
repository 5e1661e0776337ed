//! The unrolled residual and curvature, and how inputs enter: `impl Linkage`.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::terms::{Binding, ident, parameter, position_parameters, vector};
use super::written_out::written_out;
use super::{clusters, elimination, form, frames, jacobian, measures, quantity, rates, readout};
use suspension_listing::eliminate::EliminationOrder;
use suspension_listing::system::{Equation, System};

pub(super) fn linkage_impl(system: &System, order: &EliminationOrder) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let watched = clusters::watched(system);
    let methods = [
        coordinates(system),
        put_drives(system),
        residual(system),
        jacobian::jacobian(system),
        elimination::pivots(system, order),
        elimination::factor(system, order),
        curvature(system),
        rates::drive_rate(system),
        rates::chassis_rate(system),
        readout::points(system),
        measures::measures(system),
    ];
    quote! {
        impl<T: Scalar> Linkage<#n> for Model<T> {
            type Scalar = T;
            type Listing = Listing;
            type Fixed = Fixed<T>;
            type Drives = Drives<T>;
            type Measures = Measures<T>;
            type Points = Points<T>;
            type Factors = Factors<T>;

            fn listing(&self) -> Listing {
                Listing
            }

            fn fixed(&self) -> &Fixed<T> {
                &self.fixed
            }

            fn size(&self) -> T {
                self.size
            }

            #(#methods)*

            #watched
        }
    }
}

/// Converts angles to the coordinates that they prescribe.
fn coordinates(system: &System) -> TokenStream {
    let angles: Vec<TokenStream> = system
        .drives
        .iter()
        .filter_map(quantity::coordinate)
        .collect();
    let body = if angles.is_empty() {
        quote!(*drives)
    } else {
        quote! {
            let mut coordinates = *drives;
            #(#angles)*
            coordinates
        }
    };
    quote! {
        #[inline(always)]
        fn coordinates(&self, drives: &Signal<Drives<T>>) -> Signal<Drives<T>> {
            #body
        }
    }
}

/// Inserts driven coordinates into the chassis points.
fn put_drives(system: &System) -> TokenStream {
    let moves: TokenStream = system.drives.iter().filter_map(quantity::moves).collect();
    let fixed = parameter("fixed", &quote!(&mut Fixed<T>), &moves);
    let drives = parameter("drives", &quote!(&Drives<T>), &moves);
    quote! {
        #[inline(always)]
        fn put_drives(&self, #fixed, #drives) {
            #moves
        }
    }
}

/// The equations, with those first that use the frames which have just been made: the operands of the frames are then
/// still at hand.
fn frames_first(system: &System) -> impl Iterator<Item = &Equation> {
    let of = |framed| {
        let equations = system.equations.iter();
        equations.filter(move |equation| form::emitter(equation).is_framed() == framed)
    };
    of(true).chain(of(false))
}

fn residual(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let rows =
        frames_first(system).map(|equation| form::emitter(equation).residual(&equation.named.name));
    let body = vector(system, frames::with_free(system), rows);
    let [q, fixed] = position_parameters(system, &body);
    let drives = parameter("drives", &quote!(&Drives<T>), &body);
    written_out(&quote! {
        fn residual(&self, #q, #fixed, #drives) -> SVector<T, #n> {
            #body
        }
    })
}

fn curvature(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let [v, v_fixed, w, w_fixed] = &["v", "v_fixed", "w", "w_fixed"].map(ident);
    let rows = frames_first(system)
        .filter_map(|equation| form::emitter(equation).curvature(&equation.named.name));
    let bindings = [Binding::free(v, "v"), Binding::free(w, "w")]
        .into_iter()
        .chain(frames::bindings(system, "_v", v, v_fixed))
        .chain(frames::bindings(system, "_w", w, w_fixed));
    let body = vector(system, bindings, rows);
    let vectors = ["v", "w"].map(|name| parameter(name, &quote!(&SVector<T, #n>), &body));
    let fixed = ["v_fixed", "w_fixed"].map(|name| parameter(name, &quote!(&Fixed<T>), &body));
    written_out(&quote! {
        fn curvature(&self, #(#vectors, #fixed),*) -> SVector<T, #n> {
            #body
        }
    })
}
