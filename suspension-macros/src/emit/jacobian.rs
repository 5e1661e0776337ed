//! The dense Jacobian: each equation writes its derivatives with respect to its points into its rows.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::form::gradients;
use super::gradient::{By, Gradient};
use super::terms::{bind, ident, position_parameters};
use super::written_out::written_out;
use super::{frames, indices};
use suspension_listing::system::{System, coordinate_name};

pub(super) fn jacobian(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let rows = gradients(system).map(|(_, equation, gradient)| {
        let Gradient { statements, by } = gradient;
        let row = equation.rows();
        let row = row.first().map(indices::equation);
        let by = by.iter().map(put);
        (by.len() > 0).then(|| quote!(#statements rows.at(#row) #(#by)*;))
    });
    let body = quote! {
        let mut rows = Rows::zero();
        #(#rows)*
        rows.matrix()
    };
    let body = bind_points(system, body);
    let [q, fixed] = position_parameters(system, &body);
    written_out(&quote! {
        fn jacobian(&self, #q, #fixed) -> SMatrix<T, #n, #n> {
            #body
        }
    })
}

/// A call that writes a derivative into the rows.
fn put(by: &By<'_>) -> TokenStream {
    let coordinate = |name, axis| indices::unknown(&coordinate_name(name, axis));
    let (method, column, value) = match by {
        By::Point(site, value) => ("by", coordinate(&site.name, 0), value),
        By::Coordinate(site, axis, value) => ("by_one", coordinate(&site.name, *axis), value),
        By::Scalar(scalar, value) => ("by_one", indices::unknown(scalar), value),
        By::PointOfThree(site, value) => ("three_by", coordinate(&site.name, 0), value),
        By::Diagonal(site, value) => ("diagonal_by", coordinate(&site.name, 0), value),
        By::ScalarOfThree(scalar, value) => ("three_by_one", indices::unknown(scalar), value),
    };
    let method = ident(method);
    quote!(.#method(#column, #value))
}

/// `body` after the free points and frames that it reads.
pub(super) fn bind_points(system: &System, body: TokenStream) -> TokenStream {
    bind(frames::with_free(system).collect(), body)
}
