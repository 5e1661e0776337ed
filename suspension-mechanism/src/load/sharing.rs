//! Which wheels move each other, as on a twist beam.

use crate::load::design::Design;
use crate::mechanism::{Names, Suspension};

/// How fast a point moves that rounding alone moves, for a unit of travel.
const ROUNDING: f64 = 1e-9;

/// Of each wheel, whether its travel moves the carrier of another one at the design position.
pub(super) fn sharing<L: Suspension<N>, const N: usize>(
    names: &Names,
    design: &Design<L, N>,
) -> Vec<bool> {
    let wheels = names.wheels.iter().enumerate();
    let moves_another = |(number, travel): (usize, usize)| {
        let rates = design.per(travel)?;
        let others = names.wheels.iter().enumerate();
        let others = others.filter(|(other, _)| *other != number);
        let mut points = others.flat_map(|(_, wheel)| wheel.points.carrier);
        Some(points.any(|point| rates[point].amax() > ROUNDING))
    };
    let each = wheels.map(|(number, wheel)| {
        let moves = wheel
            .travel
            .and_then(|travel| moves_another((number, travel)));
        moves.unwrap_or(false)
    });
    each.collect()
}
