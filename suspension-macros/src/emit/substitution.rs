//! Unrolled solutions with the factors: for any right-hand side, for one that is mostly zero, and
//! with the transpose.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::unrolled::Unrolled;
use super::{carried, rates, written_out};
use suspension_listing::eliminate::Step;
use suspension_listing::system::System;

/// For any right-hand side.
pub(super) fn solve(unrolled: &Unrolled<'_>, n: &Literal) -> TokenStream {
    let all_rows = unrolled.order.steps.iter().map(|step| step.row).collect();
    let statements = down_and_up(unrolled, all_rows);
    written_out(&quote! {
        fn solve(&self, right: &SVector<T, #n>) -> SVector<T, #n> {
            let [mut rows] = right.data.0;
            let mut unknowns = [T::zero(); #n];
            #(#statements)*
            SVector::from(unknowns)
        }
    })
}

/// For one that is zero but in the rows that drives change.
pub(super) fn solve_drives(unrolled: &Unrolled<'_>, n: &Literal, system: &System) -> TokenStream {
    let driven = rates::driven_rows(system);
    let statements = down_and_up(unrolled, driven);
    written_out(&quote! {
        fn solve_drives(&self, right: &SVector<T, #n>) -> SVector<T, #n> {
            let [mut rows] = right.data.0;
            let mut unknowns = [T::zero(); #n];
            #(#statements)*
            SVector::from(unknowns)
        }
    })
}

/// `J^T y = right`: first with the transposed upper factor, then with the lower one.
pub(super) fn solve_transposed(unrolled: &Unrolled<'_>, n: &Literal) -> TokenStream {
    let substituted = carried::transposed(unrolled);
    let steps = unrolled.order.steps.iter().filter(|step| !step.carried);
    let upper = steps.flat_map(|step| {
        let column = unrolled.column(step.column);
        step.right.iter().map(move |&right| {
            let (entry, right) = (unrolled.entry(step.row, right), unrolled.column(right));
            quote!(unknowns[#right] = unknowns[#right].minus_product(self.#entry, unknowns[#column]);)
        })
    });
    let diagonal = unrolled.order.steps.iter().map(|step| {
        let (row, column) = (unrolled.row(step.row), unrolled.column(step.column));
        let scaled = unrolled
            .inverse(step)
            .map(|inverse| quote!(* self.#inverse));
        quote!(rows[#row] = unknowns[#column] #scaled;)
    });
    let lower = unrolled.order.steps.iter().rev().flat_map(|step| {
        let pivot = unrolled.row(step.row);
        step.below.iter().map(move |&below| {
            let (multiplier, below) = (unrolled.entry(below, step.column), unrolled.row(below));
            quote!(rows[#pivot] = rows[#pivot].minus_product(self.#multiplier, rows[#below]);)
        })
    });
    written_out(&quote! {
        fn solve_transposed(&self, right: &SVector<T, #n>) -> SVector<T, #n> {
            let [mut unknowns] = right.data.0;
            let mut rows = [T::zero(); #n];
            #substituted
            #(#upper)*
            #(#diagonal)*
            #(#lower)*
            SVector::from(rows)
        }
    })
}

/// The statements of both substitutions, where only the rows of `live` are not zero at first.
fn down_and_up(unrolled: &Unrolled<'_>, mut live: BTreeSet<usize>) -> Vec<TokenStream> {
    let steps = &unrolled.order.steps;
    let mut statements = Vec::new();
    for step in steps {
        if !live.contains(&step.row) {
            continue;
        }
        let pivot = unrolled.row(step.row);
        for &row in &step.below {
            let multiplier = unrolled.entry(row, step.column);
            let is_live = !live.insert(row);
            let row = unrolled.row(row);
            statements.push(if is_live {
                quote!(rows[#row] = rows[#row].minus_product(self.#multiplier, rows[#pivot]);)
            } else {
                quote!(rows[#row] = -(self.#multiplier * rows[#pivot]);)
            });
        }
    }
    let mut known = BTreeSet::new();
    for step in steps.iter().rev().filter(|step| !step.carried) {
        let start = live.contains(&step.row).then(|| unrolled.row(step.row));
        if let Some(sum) = back_substituted(unrolled, step, start, &known) {
            known.insert(step.column);
            let unknown = unrolled.column(step.column);
            statements.push(quote!(unknowns[#unknown] = #sum;));
        }
    }
    statements.push(carried::substituted(unrolled, &live));
    statements
}

/// A row divided by its pivot, less the unknowns found so far; `None` where that is zero.
fn back_substituted(
    unrolled: &Unrolled<'_>,
    step: &Step,
    start: Option<TokenStream>,
    known: &BTreeSet<usize>,
) -> Option<TokenStream> {
    let scaled = unrolled
        .inverse(step)
        .map(|inverse| quote!(* self.#inverse));
    let start = start.map(|row| match &scaled {
        Some(scaled) if !step.right.is_empty() => quote!((rows[#row] #scaled)),
        _ => quote!(rows[#row] #scaled),
    });
    let terms = step.right.iter().filter(|column| known.contains(column));
    terms.fold(start, |sum, &column| {
        let (entry, column) = (unrolled.entry(step.row, column), unrolled.column(column));
        Some(match sum {
            Some(sum) => quote!(#sum.minus_product(self.#entry, unknowns[#column])),
            None => quote!((-(self.#entry * unknowns[#column]))),
        })
    })
}
