//! The unrolled factorisation and solution in a fixed order of pivots: `impl Elimination`.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::Ident;

use super::indices;
use crate::eliminate::{Order, Step};
use crate::system::{AXES, System};

/// Rows, columns and order of an elimination under their names.
struct Unrolled<'a> {
    order: &'a Order,
    rows: Vec<Ident>,
    columns: Vec<Ident>,
}

pub(super) fn elimination(system: &System, order: &Order) -> TokenStream {
    let points = system.free.iter();
    let unrolled = Unrolled {
        order,
        rows: system.rows(),
        columns: points
            .flat_map(|point| AXES.map(|axis| format_ident!("{}_{axis}", point.name)))
            .collect(),
    };
    let n = Literal::usize_unsuffixed(system.size());
    let fields = unrolled.fields();
    let factor = unrolled.factor(&n);
    let solve = unrolled.solve(&n);
    quote! {
        /// The Jacobian eliminated in a fixed order: multipliers below each pivot, what is left
        /// of its row to the right, and in its own place the pivot's inverse. Pivots that are 1
        /// in every position are left out.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Factors<T> {
            growth: T,
            determinant_sign: T,
            #(#fields: T,)*
        }

        impl<T: Scalar> Elimination<T, #n> for Factors<T> {
            #factor

            fn growth(&self) -> T {
                self.growth
            }
        }

        impl<T: Scalar> JacobianFactors<T, #n> for Factors<T> {
            #solve

            fn determinant_sign(&self) -> T {
                self.determinant_sign
            }
        }
    }
}

impl Unrolled<'_> {
    /// An entry of the eliminated matrix: `row_by_column`.
    fn entry(&self, row: usize, column: usize) -> Ident {
        format_ident!("{}_by_{}", self.rows[row], self.columns[column])
    }

    fn row(&self, row: usize) -> TokenStream {
        indices::equation(&self.rows[row])
    }

    fn column(&self, column: usize) -> TokenStream {
        indices::unknown(&self.columns[column])
    }

    /// The inverse of a step's pivot; `None` where that is 1.
    fn inverse(&self, step: &Step) -> Option<Ident> {
        (!step.unit).then(|| self.entry(step.row, step.column))
    }

    /// Entries in the order of elimination, each once.
    fn entries(&self) -> Vec<(usize, usize)> {
        let mut entries = Vec::new();
        for step in &self.order.steps {
            if !step.unit {
                entries.push((step.row, step.column));
            }
            entries.extend(step.right.iter().map(|&column| (step.row, column)));
            entries.extend(step.below.iter().map(|&row| (row, step.column)));
        }
        entries
    }

    fn fields(&self) -> Vec<Ident> {
        self.entries()
            .into_iter()
            .map(|(row, column)| self.entry(row, column))
            .collect()
    }

    fn factor(&self, n: &Literal) -> TokenStream {
        let initial = self.entries().into_iter().map(|(row, column)| {
            let entry = self.entry(row, column);
            if self.order.fill.contains(&(row, column)) {
                return quote!(#entry: T::zero());
            }
            let (row, column) = (self.row(row), self.column(column));
            quote!(#entry: columns[#column][#row])
        });
        let mut filled = Vec::new();
        let steps: Vec<TokenStream> = self
            .order
            .steps
            .iter()
            .map(|step| self.eliminate(step, &mut filled))
            .collect();
        let pivots: Vec<Ident> = self
            .order
            .steps
            .iter()
            .filter_map(|step| self.inverse(step))
            .collect();
        let sign = self.order.is_odd().then(|| quote!(-));
        quote! {
            #[inline(always)]
            fn factor(jacobian: &SMatrix<T, #n, #n>) -> Self {
                let columns = &jacobian.data.0;
                let mut lu = Self { growth: T::zero(), determinant_sign: T::zero(), #(#initial),* };
                #(#steps)*
                lu.growth = largest([#(lu.#pivots),*]);
                lu.determinant_sign = #sign product([#(lu.#pivots),*]);
                lu
            }
        }
    }

    /// One step: the pivot's inverse, the multipliers, and what they take from each row below.
    fn eliminate(&self, step: &Step, filled: &mut Vec<(usize, usize)>) -> TokenStream {
        let inverse = self.inverse(step);
        let invert = inverse
            .iter()
            .map(|pivot| quote!(lu.#pivot = T::one() / lu.#pivot;));
        let mut statements: Vec<TokenStream> = invert.collect();
        for &row in &step.below {
            let multiplier = self.entry(row, step.column);
            statements.extend(
                inverse
                    .iter()
                    .map(|pivot| quote!(lu.#multiplier *= lu.#pivot;)),
            );
            for &column in &step.right {
                let (entry, of_pivot) = (self.entry(row, column), self.entry(step.row, column));
                let is_new =
                    self.order.fill.contains(&(row, column)) && !filled.contains(&(row, column));
                statements.push(if is_new {
                    filled.push((row, column));
                    quote!(lu.#entry = -(lu.#multiplier * lu.#of_pivot);)
                } else {
                    quote!(lu.#entry -= lu.#multiplier * lu.#of_pivot;)
                });
            }
        }
        quote!(#(#statements)*)
    }

    fn solve(&self, n: &Literal) -> TokenStream {
        let down = self.order.steps.iter().flat_map(|step| {
            let pivot = self.row(step.row);
            step.below.iter().map(move |&row| {
                let (multiplier, row) = (self.entry(row, step.column), self.row(row));
                quote!(rows[#row] -= self.#multiplier * rows[#pivot];)
            })
        });
        let up = self.order.steps.iter().rev().map(|step| {
            let (row, unknown) = (self.row(step.row), self.column(step.column));
            let terms = step.right.iter().map(|&column| {
                let (entry, column) = (self.entry(step.row, column), self.column(column));
                quote!(- self.#entry * unknowns[#column])
            });
            let sum = quote!(rows[#row] #(#terms)*);
            match self.inverse(step) {
                None => quote!(unknowns[#unknown] = #sum;),
                Some(inverse) if step.right.is_empty() => {
                    quote!(unknowns[#unknown] = #sum * self.#inverse;)
                }
                Some(inverse) => quote!(unknowns[#unknown] = (#sum) * self.#inverse;),
            }
        });
        quote! {
            #[inline(always)]
            fn solve(&self, right: &SVector<T, #n>) -> SVector<T, #n> {
                let [mut rows] = right.data.0;
                let mut unknowns = [T::zero(); #n];
                #(#down)*
                #(#up)*
                SVector::from(unknowns)
            }
        }
    }
}
