//! What the inputs' rates contribute to velocity and acceleration: `-dF/du udot`.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::Ident;

use super::terms::{
    Binding, assign, assign_carried, bind, carried, frames, ident, parameter, rows, vector,
};
use super::written_out;
use suspension_listing::system::{
    AXES, Equation, Site, SiteMotion, System, carried_name, frame_name,
};

/// Of the drives, and of the chassis points that they move.
pub(super) fn drive_rate(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let body = terms(system, SiteMotion::DrivenAnchor, |drive| {
        Some(quote!(drive_rate.#drive))
    });
    let [q, fixed, fixed_rate] = parameters(system, &body);
    let drive_rate = parameter("drive_rate", &quote!(&Drives<T>), &body);
    written_out(&quote! {
        fn drive_rate(&self, #q, #fixed, #fixed_rate, #drive_rate) -> SVector<T, #n> {
            #body
        }
    })
}

/// The rows that `drive_rate` fills.
pub(super) fn driven_rows(system: &System) -> BTreeSet<usize> {
    let is_driven = |site: &Site| site.motion == SiteMotion::DrivenAnchor;
    let of_equation = |equation: &Equation| {
        let driven = match equation {
            Equation::Distance { from, .. } => is_driven(from),
            Equation::Carried { frame, .. } => frame.iter().any(is_driven),
            Equation::Coordinate { .. } => true,
        };
        vec![driven; equation.rows().len()]
    };
    let rows = system.equations.iter().flat_map(of_equation).enumerate();
    rows.filter_map(|(row, driven)| driven.then_some(row))
        .collect()
}

/// Of the chassis points that no drive moves.
pub(super) fn chassis_rate(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let body = terms(system, SiteMotion::Anchor, |_| None);
    let [q, fixed, fixed_rate] = parameters(system, &body);
    written_out(&quote! {
        fn chassis_rate(&self, #q, #fixed, #fixed_rate) -> SVector<T, #n> {
            #body
        }
    })
}

fn parameters(system: &System, body: &TokenStream) -> [TokenStream; 3] {
    let n = Literal::usize_unsuffixed(system.size());
    [
        parameter("q", &quote!(&SVector<T, #n>), body),
        parameter("fixed", &quote!(&Fixed<T>), body),
        parameter("fixed_rate", &quote!(&Fixed<T>), body),
    ]
}

/// The non-zero rows for the chassis points with the given motion and, where `drive` gives one,
/// the drive's own rate.
fn terms(
    system: &System,
    motion: SiteMotion,
    drive_rate: impl Fn(&Ident) -> Option<TokenStream>,
) -> TokenStream {
    let (free, fixed) = (&ident("free"), &ident("fixed"));
    let gradients = carried(system, |body, _| {
        let frame = frame_name(&body.name);
        quote!(gradient(&#frame))
    });
    let assignments: Vec<TokenStream> = system
        .equations
        .iter()
        .filter_map(|equation| match equation {
            Equation::Distance {
                named, from, to, ..
            } => (from.motion == motion).then(|| distance(&named.name, from, to)),
            Equation::Carried { body, point, frame } => carried_rows(body, point, frame, motion),
            Equation::Coordinate {
                drive,
                axis,
                of,
                minus,
            } => coordinate(drive_rate(drive), *axis, of, minus.as_ref(), motion)
                .map(|term| assign(drive, &term)),
        })
        .collect();
    let result = rows(system, &assignments);
    let bindings = [Binding::free(free, "q")]
        .into_iter()
        .chain(frames(system, "", free, fixed))
        .chain(gradients);
    bind(bindings.collect(), result)
}

fn distance(name: &Ident, from: &Site, to: &Site) -> TokenStream {
    let (vector, from) = (
        vector(from, to, &ident("free"), &ident("fixed")),
        &from.name,
    );
    assign(
        name,
        &quote!(dot(self.#name.gradient(#vector), fixed_rate.#from)),
    )
}

fn carried_rows(
    body: &Ident,
    point: &Site,
    frame: &[Site; 3],
    motion: SiteMotion,
) -> Option<TokenStream> {
    let name = carried_name(body, &point.name);
    let blocks = ["origin", "second", "third"]
        .map(ident)
        .into_iter()
        .zip(frame);
    let moved = blocks.filter(|(_, site)| site.motion == motion);
    let terms: Vec<TokenStream> = moved
        .map(|(block, site)| {
            let site = &site.name;
            quote!(- #name.#block * fixed_rate.#site)
        })
        .collect();
    let entries = assign_carried(body, point, &ident("term"));
    (!terms.is_empty()).then(|| {
        quote! {
            let term = #(#terms)*;
            #entries
        }
    })
}

/// `drive_rate - of_rate + minus_rate`, of what moves.
fn coordinate(
    drive_rate: Option<TokenStream>,
    axis: usize,
    of: &Site,
    minus: Option<&Site>,
    motion: SiteMotion,
) -> Option<TokenStream> {
    let axis = ident(AXES[axis]);
    let rate = |site: &Site| {
        let name = &site.name;
        (site.motion == motion).then(|| quote!(fixed_rate.#name.#axis))
    };
    let plus = [drive_rate, minus.and_then(rate)]
        .into_iter()
        .flatten()
        .collect::<Vec<_>>();
    let less = rate(of).map(|of| quote!(- #of));
    (!plus.is_empty() || less.is_some()).then(|| quote!(#(#plus)+* #less))
}
