//! The elimination step by step, each entry under its name.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::Ident;

use super::short::ShortNames;
use suspension_listing::eliminate::{EliminationOrder, Step};
use suspension_listing::system::System;

/// The rows, columns and order of an elimination under their names.
pub(super) struct Unrolled<'a> {
    pub(super) system: &'a System,
    pub(super) order: &'a EliminationOrder,
    pub(super) names: ShortNames,
    stored: Vec<(usize, usize)>,
}

impl<'a> Unrolled<'a> {
    pub(super) fn new(system: &'a System, order: &'a EliminationOrder) -> Self {
        Self {
            system,
            order,
            names: ShortNames::new(system),
            stored: stored(order),
        }
    }

    /// An entry of the Jacobian, which later is an entry of its factors.
    pub(super) fn entry(&self, row: usize, column: usize) -> Ident {
        format_ident!("{}_{}", self.row(row), self.column(column))
    }

    /// An entry of a right-hand side.
    pub(super) fn row(&self, row: usize) -> &Ident {
        &self.names.rows[row]
    }

    pub(super) fn column(&self, column: usize) -> &Ident {
        &self.names.columns[column]
    }

    /// The inverse of a step's pivot; `None` if that is 1.
    pub(super) fn inverse(&self, step: &Step) -> Option<Ident> {
        (!step.unit).then(|| self.entry(step.row, step.column))
    }

    /// Entries in the order of elimination, each once.
    pub(super) fn fields(&self) -> Vec<Ident> {
        let stored = self.stored.iter();
        stored
            .map(|(row, column)| self.entry(*row, *column))
            .collect()
    }

    pub(super) fn is_stored(&self, row: usize, column: usize) -> bool {
        self.stored.contains(&(row, column))
    }

    /// Whether an entry of the fill-in starts here.
    pub(super) fn fills(
        &self,
        row: usize,
        column: usize,
        filled: &mut Vec<(usize, usize)>,
    ) -> bool {
        let is_new = self.order.fill.contains(&(row, column)) && !filled.contains(&(row, column));
        if is_new {
            filled.push((row, column));
        }
        is_new
    }

    /// One step: the pivot's inverse, the multipliers, and the products that are subtracted from each row below.
    pub(super) fn eliminate(&self, step: &Step, filled: &mut Vec<(usize, usize)>) -> TokenStream {
        let inverse = self.inverse(step);
        let invert = inverse
            .iter()
            .map(|pivot| quote!(let #pivot = T::one() / #pivot;));
        let mut statements: Vec<TokenStream> = invert.collect();
        for &row in &step.below {
            let multiplier = self.entry(row, step.column);
            statements.extend(
                inverse
                    .iter()
                    .map(|pivot| quote!(let #multiplier = #multiplier * #pivot;)),
            );
            for &column in &step.right {
                let (entry, of_pivot) = (self.entry(row, column), self.entry(step.row, column));
                statements.push(if self.fills(row, column, filled) {
                    quote!(let #entry = -(#multiplier * #of_pivot);)
                } else {
                    quote!(let #entry = #entry.minus_product(#multiplier, #of_pivot);)
                });
            }
        }
        statements.extend(inverse.iter().flat_map(|pivot| {
            step.right.iter().map(move |&column| {
                let entry = self.entry(step.row, column);
                quote!(let #entry = #entry * #pivot;)
            })
        }));
        quote!(#(#statements)*)
    }
}

/// Entries in the order of elimination, each once: for each step the pivot's inverse, its row, the multipliers.
fn stored(order: &EliminationOrder) -> Vec<(usize, usize)> {
    let mut stored = Vec::new();
    for step in &order.steps {
        stored.extend((!step.unit).then_some((step.row, step.column)));
        let right = step.right.iter().filter(|_| !step.carried);
        stored.extend(right.map(|&column| (step.row, column)));
        stored.extend(step.below.iter().map(|&row| (row, step.column)));
    }
    stored
}
