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

/// What one equation, or the frame that several share, costs.
fn add(total: &mut Operations, multiplications: usize, additions: usize) {
    total.multiplications += multiplications;
    total.additions += additions;
}

/// Operations of residual, Jacobian and curvature, as `suspension_core::constraint` writes them.
fn operations(system: &System) -> [Operations; 3] {
    let [mut residual, mut jacobian, mut curvature] = [Operations::default(); 3];
    for body in system.bodies.iter().filter(|body| !body.carried.is_empty()) {
        let _ = body;
        add(&mut residual, 0, 6);
        add(&mut jacobian, 0, 6);
        add(&mut curvature, 0, 12);
    }
    for equation in &system.equations {
        match equation {
            Equation::Distance { .. } => {
                add(&mut residual, 6, 6);
                add(&mut jacobian, 3, 3);
                add(&mut curvature, 4, 8);
            }
            Equation::Carried { .. } => {
                add(&mut residual, 15, 15);
                add(&mut jacobian, 6, 21);
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
    let shape = format!(
        " `{n}` unknowns `q` (the coordinates of {}), `{n}` equations `F(q) = 0`, Jacobian `{n} x {n}` \
         with {non_zeros} non-zeros of {}.",
        list(system.free.iter().map(|point| &point.name)),
        n * n,
    );
    let [residual, jacobian, curvature] = operations(system).map(
        |Operations {
             multiplications,
             additions,
         }| { format!("{multiplications} multiplications and {additions} additions") },
    );
    let counts = format!(
        " Residual: {residual}. Jacobian: {jacobian}. Curvature: {curvature}. No division, no branch."
    );
    let equations = format!(" Equations: {}.", list(system.rows().iter()));
    quote! {
        #[doc = ""]
        #[doc = #shape]
        #[doc = #counts]
        #[doc = ""]
        #[doc = #equations]
    }
}

fn list<'a>(names: impl Iterator<Item = &'a syn::Ident>) -> String {
    names
        .map(|name| format!("`{name}`"))
        .collect::<Vec<_>>()
        .join(", ")
}
