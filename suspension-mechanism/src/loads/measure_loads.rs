//! Loads in measures: they act at the points of each measure and on bodies that carry one of these points.

use nalgebra::{DMatrix, DVector, Vector3};

use crate::loads::forces::{Force, Here, ROUNDING};
use crate::loads::{By, Case, Outcome, Structure};
use crate::mechanism::State;

impl Structure<'_> {
    /// The measures in which loads act, by number and in their order, with the loads in each added together.
    pub(super) fn sum_by_measure(&self, acting: &[(usize, f64)]) -> Vec<(usize, f64)> {
        let measures = 0..self.measured_points.len();
        let each = measures.filter_map(|measure| {
            let in_it = acting.iter().filter(|(acting, _)| *acting == measure);
            let in_it = in_it.map(|(_, along)| *along);
            Some((measure, in_it.reduce(|sum, along| sum + along)?))
        });
        each.collect()
    }

    /// The measures, by number, in which springs act by their rates, with the load of these springs in each.
    pub(super) fn of_springs(&self, case: &Case, state: &State) -> Vec<(usize, f64)> {
        let springs = case.acting.iter().map(|spring| &state.springs[*spring]);
        let acting = springs.map(|spring| (spring.measure, state.load_of(spring)));
        self.sum_by_measure(&acting.collect::<Vec<_>>())
    }

    /// The forces of loads in measures, by number, on the points of each.
    pub(super) fn forces_at_ends(
        &self,
        here: &Here<'_>,
        acting: &[(usize, f64)],
    ) -> Vec<(By, usize, Vector3<f64>)> {
        let at_ends = acting.iter().flat_map(|(measure, along)| {
            let gradient = here.gradient(*measure);
            let at = move |point: &usize| {
                let gradient = gradient.get(*point)?;
                Some((By::Measure(*measure), *point, gradient * *along))
            };
            self.measured_points[*measure].iter().filter_map(at)
        });
        at_ends.collect()
    }

    /// Adds the loads that a body bears `at_ends` of measures that are its markers: it exerts the opposite there.
    pub(super) fn add_at_markers(
        &self,
        outcome: &mut Outcome,
        number: usize,
        at_ends: &[(By, usize, Vector3<f64>)],
    ) {
        let points = &self.statements[number].points;
        let is_own = |body: &[usize; 3]| body.iter().all(|point| points.contains(point));
        for (marker, _) in self.carriers.iter().filter(|(_, body)| is_own(body)) {
            let there = at_ends.iter().filter(|(_, point, _)| point == marker);
            let forces = there.map(|(.., force)| -force);
            if let Some(force) = forces.reduce(|sum, force| sum + force) {
                outcome.joints.push((By::Part(number), *marker, force));
            }
        }
    }
}

/// The loads that measures bear instead of drives, and those of springs that act by their rates, together with those that the case
/// states in the same measures.
pub(super) fn add_stated(
    in_measures: Vec<(usize, f64)>,
    stated: &[(usize, f64)],
) -> Vec<(usize, f64)> {
    let together = |(measure, found): (usize, f64)| {
        let stated = stated.iter().filter(|(along, _)| *along == measure);
        (measure, stated.fold(found, |sum, (_, along)| sum + along))
    };
    in_measures.into_iter().map(together).collect()
}

/// The loads that measures must bear so that their drives bear nothing; `None` if they cannot.
pub(super) fn loads_borne_by_measures(
    here: &Here<'_>,
    borne_by: &[(usize, usize)],
    forces: &[Force],
) -> Option<Vec<(usize, f64)>> {
    if borne_by.is_empty() {
        return Some(Vec::new());
    }
    let on_drives = |forces: &[Force]| {
        let borne = here.solve(forces, &[])?.on_drives;
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
