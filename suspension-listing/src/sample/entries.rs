//! The entries of the Jacobian with their values in some positions.

use super::gradient::{Gradient, gradients};
use crate::eliminate::Entry;
use crate::system::{Place, Positions, System};

/// The entries of the Jacobian that are not always zero, with their values in some positions, up to the first
/// position whose geometry is degenerate.
pub fn entries(system: &System, positions: &[Positions]) -> Vec<Entry> {
    let positions = positions.iter();
    let gradients: Vec<Vec<Gradient>> = positions
        .map_while(|position| gradients(system, position))
        .collect();
    let places = system.places();
    let entries = places.iter().map(|place| Entry {
        row: place.row,
        column: place.column,
        unit: place.unit,
        carried: place.carried,
        values: gradients.iter().map(|each| value(place, each)).collect(),
    });
    entries.collect()
}

/// The value of an entry in the gradients of all equations.
pub(super) fn value(place: &Place<'_>, gradients: &[Gradient]) -> f64 {
    gradients[place.equation][place.argument][place.row_of_equation]
}
