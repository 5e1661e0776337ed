//! Loads in measures: they act at the points of each measure and on bodies that carry one of these points.

use nalgebra::Vector3;

use crate::loads::forces::Here;
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
