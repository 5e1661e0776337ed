//! The Jacobian's numbers in the design position that a listing states, and around it: what the
//! choice of pivots goes by. Nothing of it is emitted.

mod path;

use crate::form::Form;
use crate::system::{Positions, System};
use crate::vector::{Vector, minus};

pub use path::positions;

/// The derivatives of an equation's rows by each of its arguments: the coordinates of its sites, then its
/// scalar.
pub type Gradient = Vec<Vector>;

/// The gradients of all equations, each with the constants that the positions give it; `None` where the
/// geometry is degenerate.
pub fn gradients(system: &System, positions: &Positions) -> Option<Vec<Gradient>> {
    let equations = system.equations.iter();
    let gradients = equations.map(|equation| gradient(system, &equation.form, positions));
    gradients.collect()
}

/// By central differences of the residual, which are exact for a quadratic but for rounding.
fn gradient(system: &System, form: &Form, positions: &Positions) -> Option<Gradient> {
    let form = form.equations();
    let sites = positions.of_sites(form);
    let constants = form.constants(&sites)?;
    let step = extent(&sites);
    let scalar = form.scalar().and_then(|(name, _)| system.scalar(name));
    let mut arguments: Vec<f64> = sites.iter().flatten().copied().collect();
    arguments.extend(scalar.map(|index| positions.scalars[index]));
    let mut sites = sites;
    let mut residual_at = |arguments: &[f64]| {
        let (coordinates, scalar) = arguments.split_at(3 * sites.len());
        for (x, argument) in sites.iter_mut().flatten().zip(coordinates) {
            *x = *argument;
        }
        form.residual(
            &constants,
            &sites,
            scalar.first().copied().unwrap_or_default(),
        )
    };
    let mut gradient = Vec::new();
    for index in 0..arguments.len() {
        let here = arguments[index];
        let mut moved = |x: f64| {
            arguments[index] = x;
            residual_at(&arguments)
        };
        let (ahead, behind) = (moved(here + step), moved(here - step));
        arguments[index] = here;
        let width = (here + step) - (here - step);
        gradient.push(minus(ahead, behind).map(|change| change / width));
    }
    let mut numbers = gradient.iter().flatten();
    numbers.all(|x| x.is_finite()).then_some(gradient)
}

/// How far the sites are apart, along an axis: a step of their own size.
fn extent(at: &[Vector]) -> f64 {
    let first = at.first().copied().unwrap_or_default();
    let from_first = at.iter().flat_map(|site| minus(*site, first));
    let extent = from_first.fold(0.0, |extent: f64, x| extent.max(x.abs()));
    if extent > 0.0 { extent } else { 1.0 }
}
