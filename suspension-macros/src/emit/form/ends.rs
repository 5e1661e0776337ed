//! What rows about the vector between two points have in common, whether its length is constant or an unknown.

use proc_macro2::TokenStream;
use quote::quote;

use suspension_listing::name::Name;
use suspension_listing::system::{Site, SiteMotion};

use crate::emit::gradient::{By, Gradient};
use crate::emit::terms::{assign, line};

/// The derivatives of a row with respect to the ends of the vector.
pub(super) fn gradient<'a>(name: &Name, [from, to]: [&'a Site; 2]) -> Gradient<'a> {
    let vector = line([from, to], "free", "fixed");
    Gradient {
        statements: quote! {
            let d = #vector;
            let gradient = self.#name.gradient(d);
        },
        by: vec![
            By::Point(to, quote!(gradient)),
            By::Point(from, quote!(opposite(gradient))),
        ],
    }
}

/// The row of `-dF/du udot` for a chassis point with the given motion where the vector begins, which is where it has one.
pub(super) fn input_rate(
    name: &Name,
    [from, to]: [&Site; 2],
    motion: SiteMotion,
) -> Option<TokenStream> {
    let statements = gradient(name, [from, to]).statements;
    let start = &from.name;
    let row = assign(name, &quote!(dot(gradient, fixed_rate.#start)));
    (from.motion == motion).then(|| quote!(#statements #row))
}

/// The vectors of lines between the points `at`.
pub(super) fn vectors_at<const K: usize>(lines: &[[Site; 2]; K]) -> [TokenStream; K] {
    lines.each_ref().map(|[from, to]| {
        let (from, to) = (&from.name, &to.name);
        quote!(at.#to - at.#from)
    })
}
