//! The unrolled factorisation in a fixed order of pivots: struct `Factors` and how it is made.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::Ident;

use super::jacobian::bind_points;
use super::terms::position_parameters;
use super::unrolled::Unrolled;
use super::written_out::written_out;
use super::{carried, entries, indices, substitution};
use suspension_listing::eliminate::EliminationOrder;
use suspension_listing::system::System;

/// The struct and its solutions.
pub(super) fn factors(system: &System, order: &EliminationOrder) -> TokenStream {
    let n = Literal::usize_unsuffixed(system.size());
    let unrolled = Unrolled::new(system, order);
    let fields = unrolled.fields();
    let carried = carried::fields(system);
    let [equations, unknowns] = unrolled.names.meanings.each_ref().map(|meanings| {
        let each = meanings
            .iter()
            .map(|(short, name)| format!("`{short}` {name}"));
        each.collect::<Vec<_>>().join(", ")
    });
    let equations = format!(" An entry is named by its equation: {equations};");
    let unknowns = format!(" and its unknown: {unknowns}.");
    let solve = substitution::solve(&unrolled, &n);
    let solve_transposed = substitution::solve_transposed(&unrolled, &n);
    quote! {
        /// The Jacobian eliminated in a fixed order, `L D U`: multipliers below each pivot, what is
        /// left of its row, divided by the pivot, to the right, and in its own place the pivot's
        /// inverse. Pivots that are 1 in every position are left out, and of carried points the rows:
        /// frame and constants stand for them.
        ///
        #[doc = #equations]
        #[doc = #unknowns]
        #[derive(Clone, Copy, Debug)]
        pub struct Factors<T> {
            growth_squared: T,
            determinant_sign: T,
            #carried
            #(#fields: T,)*
        }

        impl<T: Scalar> JacobianFactors<T, #n> for Factors<T> {
            #solve

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

/// `Linkage::pivots`.
pub(super) fn pivots(system: &System, order: &EliminationOrder) -> TokenStream {
    let (rows, unknowns) = (system.rows(), indices::unknowns(system));
    let pivots = order.steps.iter().map(|step| {
        let row = indices::equation(&rows[step.row]);
        let column = indices::unknown(&unknowns[step.column]);
        quote!([#row, #column])
    });
    quote! {
        fn pivots(&self) -> &[[usize; 2]] {
            &[#(#pivots),*]
        }
    }
}

/// `Linkage::factor`.
pub(super) fn factor(system: &System, order: &EliminationOrder) -> TokenStream {
    let unrolled = Unrolled::new(system, order);
    let fields = unrolled.fields();
    let entries = entries::entries(&unrolled);
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
    let body = bind_points(
        system,
        quote! {
            #entries
            #substituted
            #(#steps)*
            let pivots = [#(#pivots),*];
            Factors {
                growth_squared: sum_of_squares(pivots),
                determinant_sign: #sign product(pivots),
                #carried
                #(#fields,)*
            }
        },
    );
    let [q, fixed] = position_parameters(system, &body);
    written_out(&quote! {
        fn factor(&self, #q, #fixed) -> Factors<T> {
            #body
        }
    })
}
