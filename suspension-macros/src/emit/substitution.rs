//! Unrolled back-substitutions with the factors, and with their transpose.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::carried;
use super::unrolled::Unrolled;
use super::written_out::written_out;
use suspension_listing::eliminate::Step;

/// `J x = right`: first with the lower factor, then with the upper one.
pub(super) fn solve(unrolled: &Unrolled<'_>, n: &Literal) -> TokenStream {
    let (rows, unknowns) = (&unrolled.names.rows, &unrolled.names.columns);
    let lower = unrolled.order.steps.iter().flat_map(|step| {
        let pivot = unrolled.row(step.row);
        step.below.iter().map(move |&below| {
            let (multiplier, below) = (unrolled.entry(below, step.column), unrolled.row(below));
            quote!(let #below = #below.minus_product(self.#multiplier, #pivot);)
        })
    });
    let steps = unrolled.order.steps.iter().filter(|step| !step.carried);
    let upper = steps.rev().map(|step| {
        let (unknown, value) = (
            unrolled.column(step.column),
            back_substituted(unrolled, step),
        );
        quote!(let #unknown = #value;)
    });
    let substituted = carried::substituted(unrolled);
    written_out(&quote! {
        fn solve(&self, right: &SVector<T, #n>) -> SVector<T, #n> {
            let [[#(#rows),*]] = right.data.0;
            #(#lower)*
            #(#upper)*
            #substituted
            vector_of![#(#unknowns),*]
        }
    })
}

/// A row divided by its pivot, minus the unknowns found so far.
fn back_substituted(unrolled: &Unrolled<'_>, step: &Step) -> TokenStream {
    let row = unrolled.row(step.row);
    let start = match unrolled.inverse(step) {
        Some(inverse) if step.right.is_empty() => quote!(#row * self.#inverse),
        Some(inverse) => quote!((#row * self.#inverse)),
        None => quote!(#row),
    };
    step.right.iter().fold(start, |sum, &column| {
        let (entry, column) = (unrolled.entry(step.row, column), unrolled.column(column));
        quote!(#sum.minus_product(self.#entry, #column))
    })
}

/// `J^T y = right`: first with the transposed upper factor, then with the lower one.
pub(super) fn solve_transposed(unrolled: &Unrolled<'_>, n: &Literal) -> TokenStream {
    let (rows, columns) = (&unrolled.names.rows, &unrolled.names.columns);
    let substituted = carried::transposed(unrolled);
    let steps = unrolled.order.steps.iter().filter(|step| !step.carried);
    let upper = steps.flat_map(|step| {
        let column = unrolled.column(step.column);
        step.right.iter().map(move |&right| {
            let (entry, right) = (unrolled.entry(step.row, right), unrolled.column(right));
            quote!(let #right = #right.minus_product(self.#entry, #column);)
        })
    });
    let diagonal = unrolled.order.steps.iter().map(|step| {
        let (row, column) = (unrolled.row(step.row), unrolled.column(step.column));
        let inverse = unrolled.inverse(step);
        let scaled = inverse.map(|inverse| quote!(* self.#inverse));
        quote!(let #row = #column #scaled;)
    });
    let lower = unrolled.order.steps.iter().rev().flat_map(|step| {
        let pivot = unrolled.row(step.row);
        step.below.iter().map(move |&below| {
            let (multiplier, below) = (unrolled.entry(below, step.column), unrolled.row(below));
            quote!(let #pivot = #pivot.minus_product(self.#multiplier, #below);)
        })
    });
    written_out(&quote! {
        fn solve_transposed(&self, right: &SVector<T, #n>) -> SVector<T, #n> {
            let [[#(#columns),*]] = right.data.0;
            #substituted
            #(#upper)*
            #(#diagonal)*
            #(#lower)*
            vector_of![#(#rows),*]
        }
    })
}
