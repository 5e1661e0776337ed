//! The derivatives of equations at given positions.

use crate::form::Form;
use crate::system::{Positions, System};
use crate::vector::{Vector, minus};

/// The derivatives of an equation's rows with respect to each of its arguments: the coordinates of its sites, then
/// its scalars.
pub type Gradient = Vec<Vector>;

/// The gradients of all equations, each with the constants that the positions give it; `None` if the geometry is
/// degenerate.
pub fn gradients(system: &System, positions: &Positions) -> Option<Vec<Gradient>> {
    let equations = system.equations.iter();
    let gradients = equations.map(|equation| gradient(system, &equation.form, positions));
    gradients.collect()
}

/// The gradient by central differences of the residual, which are exact to rounding for a quadratic.
fn gradient(system: &System, form: &Form, positions: &Positions) -> Option<Gradient> {
    let form = form.equations();
    let mut sites = positions.at_sites(form);
    let constants = form.constants(&sites)?;
    let step = extent(&sites);
    let indices = form.scalars().into_iter();
    let indices = indices.filter_map(|(name, _)| system.scalar(name));
    let mut scalars: Vec<f64> = indices.map(|index| positions.scalars[index]).collect();
    let mut gradient = Vec::with_capacity(3 * sites.len() + scalars.len());
    for index in 0..3 * sites.len() {
        let (site, axis) = (index / 3, index % 3);
        let here = sites[site][axis];
        gradient.push(difference(here, step, |x| {
            sites[site][axis] = x;
            form.residual(&constants, &sites, &scalars)
        }));
        sites[site][axis] = here;
    }
    for index in 0..scalars.len() {
        let here = scalars[index];
        gradient.push(difference(here, step, |scalar| {
            scalars[index] = scalar;
            form.residual(&constants, &sites, &scalars)
        }));
        scalars[index] = here;
    }
    let mut numbers = gradient.iter().flatten();
    numbers.all(|x| x.is_finite()).then_some(gradient)
}

/// The change of a function per step of its argument.
fn difference(here: f64, step: f64, mut of: impl FnMut(f64) -> Vector) -> Vector {
    let (ahead, behind) = (here + step, here - step);
    let change = minus(of(ahead), of(behind));
    change.map(|change| change / (ahead - behind))
}

/// The extent of the sites along an axis, which is used as the step.
fn extent(at: &[Vector]) -> f64 {
    let first = at.first().copied().unwrap_or_default();
    let from_first = at.iter().flat_map(|site| minus(*site, first));
    let extent = from_first.fold(0.0, |extent: f64, x| extent.max(x.abs()));
    if extent > 0.0 { extent } else { 1.0 }
}
