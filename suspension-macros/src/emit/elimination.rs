//! The unrolled factorisation in a fixed order of pivots: struct `Factors` and how it is made.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::Ident;

use super::jacobian::{entries, parameters, with_points};
use super::{carried, indices, substitution, written_out};
use suspension_listing::eliminate::{Order, Step};
use suspension_listing::name::Name;
use suspension_listing::system::System;

/// Rows, columns and order of an elimination under their names.
pub(super) struct Unrolled<'a> {
    pub(super) system: &'a System,
    pub(super) order: &'a Order,
    rows: Vec<Name>,
    columns: Vec<Name>,
}

/// The struct and its solutions.
pub(super) fn factors(system: &System, order: &Order) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let unrolled = Unrolled::new(system, order);
    let fields = unrolled.fields();
    let carried = carried::fields(system);
    let solve = substitution::solve(&unrolled, &n);
    let solve_drives = substitution::solve_drives(&unrolled, &n, system);
    let solve_transposed = substitution::solve_transposed(&unrolled, &n);
    quote! {
        /// The Jacobian eliminated in a fixed order, `L D U`: multipliers below each pivot, what is
        /// left of its row, divided by the pivot, to the right, and in its own place the pivot's
        /// inverse. Pivots that are 1 in every position are left out, and of carried points the rows:
        /// frame and constants stand for them.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Factors<T> {
            growth_squared: T,
            determinant_sign: T,
            #carried
            #(#fields: T,)*
        }

        impl<T: Scalar> JacobianFactors<T, #n> for Factors<T> {
            #solve

            #solve_drives

            #solve_transposed

            #[inline(always)]
            fn determinant_sign(&self) -> T {
                self.determinant_sign
            }

            #[inline(always)]
            fn growth_squared(&self) -> T {
                self.growth_squared
            }
        }
    }
}

/// `Linkage::factor`.
pub(super) fn factor(system: &System, order: &Order) -> TokenStream {
    let unrolled = Unrolled::new(system, order);
    let fields = unrolled.fields();
    let entries = entries(system, &|row, column, value| {
        let entry = entry(row, column);
        // Pivots that are 1 in every position are no fields.
        if fields.contains(&entry) {
            quote!(let #entry = #value;)
        } else {
            TokenStream::new()
        }
    });
    let mut filled = Vec::new();
    let substituted = carried::reduce(&unrolled, &mut filled);
    let carried = carried::values(system);
    let steps = order.steps.iter().filter(|step| !step.carried);
    let steps: Vec<TokenStream> = steps
        .map(|step| unrolled.eliminate(step, &mut filled))
        .collect();
    let pivots: Vec<Ident> = order
        .steps
        .iter()
        .filter_map(|step| unrolled.inverse(step))
        .collect();
    let sign = order.is_odd().then(|| quote!(-));
    let body = with_points(
        system,
        quote! {
            #entries
            #substituted
            #(#steps)*
            Factors {
                growth_squared: sum_of_squares([#(#pivots),*]),
                determinant_sign: #sign product([#(#pivots),*]),
                #carried
                #(#fields,)*
            }
        },
    );
    let [q, fixed] = parameters(system, &body);
    written_out(&quote! {
        fn factor(&self, #q, #fixed) -> Factors<T> {
            #body
        }
    })
}

/// An entry of the Jacobian, later of its factors: `row_by_column`.
fn entry(row: &Name, column: &Name) -> Ident {
    format_ident!("{row}_by_{column}")
}

impl<'a> Unrolled<'a> {
    fn new(system: &'a System, order: &'a Order) -> Self {
        Self {
            system,
            order,
            rows: system.rows(),
            columns: indices::unknowns(system),
        }
    }

    pub(super) fn entry(&self, row: usize, column: usize) -> Ident {
        entry(&self.rows[row], &self.columns[column])
    }

    /// `equation::ROW`.
    pub(super) fn row(&self, row: usize) -> TokenStream {
        indices::equation(&self.rows[row])
    }

    /// `unknown::COLUMN`.
    pub(super) fn column(&self, column: usize) -> TokenStream {
        indices::unknown(&self.columns[column])
    }

    /// The inverse of a step's pivot; `None` where that is 1.
    pub(super) fn inverse(&self, step: &Step) -> Option<Ident> {
        (!step.unit).then(|| self.entry(step.row, step.column))
    }

    /// Entries in the order of elimination, each once.
    fn fields(&self) -> Vec<Ident> {
        let mut fields = Vec::new();
        for step in &self.order.steps {
            fields.extend(self.inverse(step));
            let right = step.right.iter().filter(|_| !step.carried);
            fields.extend(right.map(|&column| self.entry(step.row, column)));
            fields.extend(step.below.iter().map(|&row| self.entry(row, step.column)));
        }
        fields
    }

    /// Whether an entry starts from nothing here.
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

    /// One step: the pivot's inverse, the multipliers, and what they take from each row below.
    fn eliminate(&self, step: &Step, filled: &mut Vec<(usize, usize)>) -> TokenStream {
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
