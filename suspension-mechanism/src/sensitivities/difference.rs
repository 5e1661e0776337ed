//! Sensitivities of quantities without exact derivatives, for example the effects of springs, by the difference of sixth order
//! `(45 (f1 - f_1) - 9 (f2 - f_2) + f3 - f_3) / (60 h)` over rebuilt suspensions, with `h` a thousandth of their size.

use nalgebra::DMatrix;

use crate::kinematics::Kinematics;
use crate::mechanism::extent;
use crate::quantities::Column;
use crate::sensitivities::Change;
use crate::sensitivities::design_values::design_values;

/// The distance between neighbours, as a fraction of the suspension's size.
const STEP: f64 = 1e-3;

/// The steps of neighbours, and their weights.
const WEIGHTS: [(f64, f64); 6] = [
    (-3.0, -1.0),
    (-2.0, 9.0),
    (-1.0, -45.0),
    (1.0, 45.0),
    (2.0, -9.0),
    (3.0, 1.0),
];

/// Fills in the derivatives of values along a change for columns that have none.
pub(super) fn fill(
    mechanism: &dyn Kinematics,
    change: &Change,
    columns: &[Column],
    found: &mut DMatrix<f64>,
) {
    if columns.iter().all(|column| column.has_derivatives) {
        return;
    }
    let Some(differences) = derivatives(mechanism, change, columns) else {
        return;
    };
    for (place, column) in columns.iter().enumerate() {
        if !column.has_derivatives {
            found[(place, 0)] = differences[(place, 0)];
        }
    }
}

/// The derivatives of all numbers along a change; `None` if no such suspensions can be built.
pub(super) fn derivatives(
    mechanism: &dyn Kinematics,
    change: &Change,
    columns: &[Column],
) -> Option<DMatrix<f64>> {
    let step = STEP * extent(mechanism.points()).max();
    let mut sum = DMatrix::zeros(columns.len(), 1 + mechanism.names.drives.len());
    for (steps, weight) in WEIGHTS {
        let changed = mechanism
            .changed(&change.per_unit.times(steps * step))
            .ok()?;
        let numbers = design_values(&*changed, columns)?;
        sum += DMatrix::from_fn(sum.nrows(), sum.ncols(), |column, number| {
            weight * numbers[column][number]
        });
    }
    Some(sum / (60.0 * step))
}
