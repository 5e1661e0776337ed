//! Unrolled solutions with the factors: for any right-hand side, for one that is mostly zero, and
//! with the transpose.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use super::unrolled::Unrolled;
use super::{carried, rates, written_out};
use suspension_listing::eliminate::Step;
use suspension_listing::system::System;

/// For any right-hand side.
pub(super) fn solve(unrolled: &Unrolled<'_>, n: &Literal) -> TokenStream {
    let rows = &unrolled.names.rows;
    let all_rows = (0..rows.len()).collect();
    let statements = down_and_up(unrolled, all_rows);
    written_out(&quote! {
        fn solve(&self, right: &SVector<T, #n>) -> SVector<T, #n> {
            let [[#(#rows),*]] = right.data.0;
            #statements
        }
    })
}

/// For one that is zero but in the rows that drives change.
pub(super) fn solve_drives(unrolled: &Unrolled<'_>, n: &Literal, system: &System) -> TokenStream {
    let driven = rates::driven_rows(system);
    let rows = unrolled.names.rows.iter().enumerate();
    let rows = rows.map(|(row, name)| {
        if driven.contains(&row) {
            quote!(#name)
        } else {
            quote!(_)
        }
    });
    let rows: Vec<TokenStream> = rows.collect();
    let statements = down_and_up(unrolled, driven);
    written_out(&quote! {
        fn solve_drives(&self, right: &SVector<T, #n>) -> SVector<T, #n> {
            let [[#(#rows),*]] = right.data.0;
            #statements
        }
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
            vector![#(#rows),*]
        }
    })
}

/// Both substitutions, where only the rows of `live` are not zero at first.
fn down_and_up(unrolled: &Unrolled<'_>, mut live: BTreeSet<usize>) -> TokenStream {
    let steps = &unrolled.order.steps;
    let mut statements = TokenStream::new();
    for step in steps {
        if !live.contains(&step.row) {
            continue;
        }
        let pivot = unrolled.row(step.row);
        for &row in &step.below {
            let multiplier = unrolled.entry(row, step.column);
            let is_live = !live.insert(row);
            let row = unrolled.row(row);
            statements.extend(if is_live {
                quote!(let #row = #row.minus_product(self.#multiplier, #pivot);)
            } else {
                quote!(let #row = -(self.#multiplier * #pivot);)
            });
        }
    }
    let mut known = BTreeSet::new();
    for step in steps.iter().rev().filter(|step| !step.carried) {
        let start = live.contains(&step.row);
        if let Some(sum) = back_substituted(unrolled, step, start, &known) {
            known.insert(step.column);
            let unknown = unrolled.column(step.column);
            statements.extend(quote!(let #unknown = #sum;));
        }
    }
    statements.extend(carried::substituted(unrolled, &live, &known));
    let carried = steps.iter().filter(|step| step.carried);
    known.extend(carried.map(|step| step.column));
    let unknowns = unrolled.names.columns.iter().enumerate();
    let unknowns = unknowns.map(|(column, unknown)| {
        if known.contains(&column) {
            unknown.to_token_stream()
        } else {
            quote!(T::zero())
        }
    });
    quote!(#statements vector![#(#unknowns),*])
}

/// A row, where it is not zero, divided by its pivot, less the unknowns found so far; `None` where that is zero.
fn back_substituted(
    unrolled: &Unrolled<'_>,
    step: &Step,
    is_live: bool,
    known: &BTreeSet<usize>,
) -> Option<TokenStream> {
    let row = unrolled.row(step.row);
    let inverse = unrolled.inverse(step);
    let start = is_live.then(|| match inverse {
        Some(inverse) if step.right.is_empty() => quote!(#row * self.#inverse),
        Some(inverse) => quote!((#row * self.#inverse)),
        None => quote!(#row),
    });
    let terms = step.right.iter().filter(|column| known.contains(column));
    terms.fold(start, |sum, &column| {
        let (entry, column) = (unrolled.entry(step.row, column), unrolled.column(column));
        Some(match sum {
            Some(sum) => quote!(#sum.minus_product(self.#entry, #column)),
            None => quote!((-(self.#entry * #column))),
        })
    })
}
