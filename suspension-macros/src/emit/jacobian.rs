//! The unrolled Jacobian: each equation gives its non-zero entries under their names.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::form::Write;
use super::terms::{Binding, bind, ident, parameter};
use super::{form, frames, indices, written_out};
use suspension_listing::system::System;

pub(super) fn jacobian(system: &System) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let entries = entries(system, &|row, column, value| {
        let (row, column) = (indices::equation(row), indices::unknown(column));
        quote!(columns[#column][#row] = #value;)
    });
    let body = with_points(
        system,
        quote! {
            let mut columns = [[T::zero(); #n]; #n];
            #entries
            from_columns(columns)
        },
    );
    let [q, fixed] = parameters(system, &body);
    written_out(&quote! {
        fn jacobian(&self, #q, #fixed) -> SMatrix<T, #n, #n> {
            #body
        }
    })
}

/// `q` and `fixed`.
pub(super) fn parameters(system: &System, body: &TokenStream) -> [TokenStream; 2] {
    let n = Literal::usize_unsuffixed(system.size());
    [
        parameter("q", &quote!(&SVector<T, #n>), body),
        parameter("fixed", &quote!(&Fixed<T>), body),
    ]
}

/// `body` behind the free points and frames that it reads.
pub(super) fn with_points(system: &System, body: TokenStream) -> TokenStream {
    let (free, fixed) = (&ident("free"), &ident("fixed"));
    let bindings = [Binding::free(free, "q")]
        .into_iter()
        .chain(frames::bindings(system, "", free, fixed));
    bind(bindings.collect(), body)
}

/// All entries that are not always zero, each passed through `write`.
pub(super) fn entries(system: &System, write: &Write<'_>) -> TokenStream {
    let of_equations = system
        .equations
        .iter()
        .map(|equation| form::of(equation).jacobian(equation, write));
    quote!(#(#of_equations)*)
}
