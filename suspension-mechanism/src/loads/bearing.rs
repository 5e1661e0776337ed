//! The loads that measures bear in place of drives.

use nalgebra::{DMatrix, DVector};

use crate::loads::forces::{Force, Here, ROUNDING, summed};

/// Whether columns are linearly dependent to rounding, whatever the units of columns and rows.
fn is_singular(mut matrix: DMatrix<f64>) -> bool {
    for mut column in matrix.column_iter_mut() {
        column.unscale_mut(column.amax());
    }
    for mut row in matrix.row_iter_mut() {
        row.unscale_mut(row.amax());
    }
    let is_finite = matrix.iter().all(|entry| entry.is_finite());
    !is_finite || matrix.singular_values().min() < ROUNDING
}

/// The loads that measures must bear so that their drives bear nothing; `None` if they cannot.
pub(super) fn bearing(
    here: &Here<'_>,
    borne_by: &[(usize, usize)],
    forces: &[Force],
) -> Option<Vec<(usize, f64)>> {
    if borne_by.is_empty() {
        return Some(Vec::new());
    }
    let on_drives = |forces: &[Force]| {
        let borne = here.solve(&summed(forces, here.points()), &[])?.on_drives;
        let relieved = borne_by.iter().map(|(drive, _)| borne[*drive]);
        Some(DVector::from_iterator(borne_by.len(), relieved))
    };
    let of_unit = |measure: usize| {
        let acting = here.forces_in_measure(measure, 1.0);
        let rounding = ROUNDING * acting.iter().map(|each| each.force.norm()).sum::<f64>();
        let borne = on_drives(&acting)?;
        Some(borne.map(|borne| if borne.abs() > rounding { borne } else { 0.0 }))
    };
    let of_units = borne_by.iter().map(|(_, measure)| of_unit(*measure));
    let of_units: Vec<DVector<f64>> = of_units.collect::<Option<_>>()?;
    let matrix = DMatrix::from_columns(&of_units);
    if is_singular(matrix.clone()) {
        return None;
    }
    let along = matrix.lu().solve(&-on_drives(forces)?)?;
    let measures = borne_by.iter().map(|(_, measure)| *measure);
    let is_finite = along.iter().all(|along| along.is_finite());
    is_finite.then(|| measures.zip(along.iter().copied()).collect())
}
