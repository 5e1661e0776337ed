//! The Jacobian's numbers in the design position that a listing states, and around it: what the
//! choice of pivots goes by. Nothing of it is emitted.

mod path;

use crate::form::Form;
use crate::system::{Positions, System};
use crate::vector::{Vector, minus};

pub use path::positions;

/// The derivatives of an equation's rows by the coordinates of its sites: by site, axis, row.
pub type Gradient = Vec<[Vector; 3]>;

/// The gradients of all equations, each with the constants that the positions give it; `None` where the
/// geometry is degenerate.
pub fn gradients(system: &System, positions: &Positions) -> Option<Vec<Gradient>> {
    let equations = system.equations.iter();
    let gradients = equations.map(|equation| gradient(&equation.form, positions));
    gradients.collect()
}

/// By central differences of the residual, which are exact for a quadratic but for rounding.
fn gradient(form: &Form, positions: &Positions) -> Option<Gradient> {
    let form = form.equations();
    let sites = form.sites();
    let mut at: Vec<Vector> = sites.iter().map(|site| positions.of(site)).collect();
    let constants = form.constants(&at)?;
    let step = extent(&at);
    let mut gradient = vec![[[0.0; 3]; 3]; sites.len()];
    for (site, by_site) in gradient.iter_mut().enumerate() {
        for (axis, derivative) in by_site.iter_mut().enumerate() {
            let here = at[site][axis];
            let mut residual_at = |x: f64| {
                at[site][axis] = x;
                form.residual(&constants, &at)
            };
            let (ahead, behind) = (residual_at(here + step), residual_at(here - step));
            at[site][axis] = here;
            let width = (here + step) - (here - step);
            *derivative = minus(ahead, behind).map(|change| change / width);
        }
    }
    let numbers = gradient.iter().flatten().flatten();
    numbers
        .into_iter()
        .all(|x| x.is_finite())
        .then_some(gradient)
}

/// How far the sites are apart, along an axis: a step of their own size.
fn extent(at: &[Vector]) -> f64 {
    let from_first = at.iter().flat_map(|site| minus(*site, at[0]));
    let extent = from_first.fold(0.0, |extent: f64, x| extent.max(x.abs()));
    if extent > 0.0 { extent } else { 1.0 }
}
