//! The header of a generated module: shapes, names and counts.

use proc_macro2::TokenStream;
use quote::quote;

use super::operations::Operations;
use super::{carried, form};
use suspension_listing::eliminate::{self, EliminationOrder};
use suspension_listing::name::Name;
use suspension_listing::system::System;

/// The operations of residual, Jacobian and curvature.
fn evaluations(system: &System) -> [Operations; 3] {
    let bodies = system.bodies.iter().filter(|body| !body.carried.is_empty());
    let frames = bodies.count();
    let mut totals = [(0, 6 * frames), (0, 6 * frames), (0, 12 * frames)].map(Operations::from);
    for equation in &system.equations {
        for (total, cost) in totals.iter_mut().zip(form::emitter(equation).cost()) {
            total.add(cost.multiplications, cost.additions);
        }
    }
    totals
}

/// The operations of the factorisation, including those of the Jacobian, and of a solution.
fn eliminations(
    system: &System,
    order: &EliminationOrder,
    jacobian: Operations,
) -> [Operations; 2] {
    let (mut factor, mut solve) = (jacobian, Operations::default());
    for point in system.substituted() {
        // Its gradient is not formed. Each row below takes `Carried::by_frame` instead, and three terms in each
        // solution, which ends with `Carried::velocity`.
        factor.multiplications -= 6;
        factor.additions -= 5;
        let rows = point.rows(order).len();
        factor.add(24 * rows, (18 + 9) * rows);
        solve.add(21 + 3 * rows, 21 + 3 * rows);
    }
    // The change of each frame.
    solve.add(0, 6 * carried::frames(&system.substituted()).len());
    for step in order.steps.iter().filter(|step| !step.carried) {
        let (right, below) = (step.right.len(), step.below.len());
        let scaled = usize::from(!step.unit);
        factor.divisions += scaled;
        let divided = scaled * (below + right);
        factor.add(below * right + divided, below * right);
        solve.add(below + right + scaled, below + right);
    }
    // An entry of the fill-in starts at zero.
    factor.additions -= order.fill.len();
    // The product of the pivots, whose sign is the determinant's, and the sum of their squares, in
    // four chains each.
    let pivots = factor.divisions;
    factor.add(2 * pivots + 3, pivots + 3);
    [factor, solve]
}

pub(super) fn header(system: &System, order: &EliminationOrder) -> TokenStream {
    let n = system.size();
    let non_zeros = system.places().len();
    let unknowns = list(system.free.iter().map(|point| &point.named.name));
    let scalars = system.scalars.iter();
    let scalars: String = scalars.map(|scalar| format!("; `{scalar}`")).collect();
    let equations = list(system.rows().iter());
    let [residual, jacobian, curvature] = evaluations(system);
    let [factor, solve] = eliminations(system, order, jacobian);
    let counts = [
        ("residual", residual),
        ("Jacobian", jacobian),
        ("curvature", curvature),
        ("factor", factor),
        ("solve", solve),
    ]
    .map(|(what, count)| {
        let Operations {
            multiplications,
            additions,
            divisions,
        } = count;
        format!(" | {what} | {multiplications} | {additions} | {divisions} |")
    });
    let text = [
        String::new(),
        format!(" {n} unknowns `q`: the coordinates of {unknowns}{scalars}."),
        String::new(),
        format!(" {n} equations `F(q) = 0`: {equations}."),
        String::new(),
        format!(
            " Jacobian: {n} x {n}, {non_zeros} non-zeros of {}; {} are stored of its factors. The longest \
             chain of operations in the factorisation is {}, a division counted as {}; in a \
             solution it is {}.",
            n * n,
            order.non_zeros(),
            order.chain,
            eliminate::DIVISION,
            order.substitution_chain(),
        ),
        String::new(),
        " | no branch | multiplications | additions | divisions |".to_owned(),
        " |---|---|---|---|".to_owned(),
    ];
    quote!(#(#[doc = #text])* #(#[doc = #counts])*)
}

fn list<'a>(names: impl Iterator<Item = &'a Name>) -> String {
    names
        .map(|name| format!("`{name}`"))
        .collect::<Vec<_>>()
        .join(", ")
}
