//! The header of a generated module: shapes, names and counts.

use proc_macro2::TokenStream;
use quote::quote;

use crate::system::{Equation, System};

/// Multiplications and additions of straight-line code.
#[derive(Clone, Copy, Default)]
struct Operations {
    multiplications: usize,
    additions: usize,
}

fn add(total: &mut Operations, multiplications: usize, additions: usize) {
    total.multiplications += multiplications;
    total.additions += additions;
}

/// Operations of residual, Jacobian and curvature, as `suspension_core::constraint` writes them;
/// a change of sign is none.
fn operations(system: &System) -> [Operations; 3] {
    let [mut residual, mut jacobian, mut curvature] = [Operations::default(); 3];
    let bodies = system.bodies.iter().filter(|body| !body.carried.is_empty());
    let frames = bodies.count();
    add(&mut residual, 0, 6 * frames);
    add(&mut jacobian, 0, 6 * frames);
    add(&mut curvature, 0, 12 * frames);
    for equation in &system.equations {
        match equation {
            Equation::Distance { .. } => {
                add(&mut residual, 6, 6);
                add(&mut jacobian, 3, 3);
                add(&mut curvature, 4, 8);
            }
            Equation::Carried { .. } => {
                add(&mut residual, 15, 15);
                add(&mut jacobian, 6, 18);
                add(&mut curvature, 15, 9);
            }
            Equation::Coordinate { minus, .. } => {
                add(&mut residual, 0, 1 + usize::from(minus.is_some()));
            }
        }
    }
    [residual, jacobian, curvature]
}

pub(super) fn header(system: &System) -> TokenStream {
    let n = system.size();
    let non_zeros: usize = system.pattern().iter().map(Vec::len).sum();
    let unknowns = list(system.free.iter().map(|point| &point.name));
    let equations = list(system.rows().iter());
    let row = |(what, count): (&str, Operations)| {
        let Operations {
            multiplications,
            additions,
        } = count;
        format!(" | {what} | {multiplications} | {additions} |")
    };
    let [residual, jacobian, curvature] = operations(system);
    let counts = [
        ("residual", residual),
        ("Jacobian", jacobian),
        ("curvature", curvature),
    ]
    .map(row);
    let text = [
        String::new(),
        format!(" {n} unknowns `q`: the coordinates of {unknowns}."),
        String::new(),
        format!(" {n} equations `F(q) = 0`: {equations}."),
        String::new(),
        format!(" Jacobian: {n} x {n}, {non_zeros} non-zeros of {}.", n * n),
        String::new(),
        " | no division, no branch | multiplications | additions |".to_owned(),
        " |---|---|---|".to_owned(),
    ];
    quote!(#(#[doc = #text])* #(#[doc = #counts])*)
}

fn list<'a>(names: impl Iterator<Item = &'a syn::Ident>) -> String {
    names
        .map(|name| format!("`{name}`"))
        .collect::<Vec<_>>()
        .join(", ")
}
