//! Measured lengths that are zero at the design position.

use suspension_core::listing::MeasureKind;

use crate::characteristics::parameters;
use crate::kinematics::Kinematics;
use crate::mechanism::extent;

/// A length that is this part of the suspension's size is zero but for rounding.
const ROUNDING: f64 = 1e-9;

/// Returns a note for each measured length whose ends are in the same place.
pub(super) fn notes(mechanism: &dyn Kinematics) -> impl Iterator<Item = String> {
    let least = ROUNDING * extent(mechanism.points()).norm();
    let of_design = parameters(mechanism, mechanism.unit).into_iter();
    let of_measures = of_design.filter(|parameter| parameter.quantity.title == "measures");
    let measures = mechanism.names.measures.iter().zip(of_measures);
    measures.filter_map(move |(measure, parameter)| {
        let is_zero = measure.kind == MeasureKind::Length && parameter.value <= least;
        is_zero.then(|| {
            format!(
                "measure `{}` is zero at the design position, as its ends are in the same place: it has no motion ratio there, \
                 and no force acts along it",
                measure.name
            )
        })
    })
}
