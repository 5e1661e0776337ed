//! Drives that bear loads which springs of the file could.

use crate::kinematics::Kinematics;
use crate::loads::forces::{ROUNDING, summed};
use crate::loads::{Case, Outcome, Structure};
use crate::mechanism::State;

impl Structure<'_> {
    /// The drives of travel that bear a load in a case, each with the spring of the file that moves most with it alone; both by
    /// number. None where the case states what acts in a spring's measure.
    pub fn unborne(
        &self,
        mechanism: &dyn Kinematics,
        case: &Case,
        (state, outcome): (&State, &Outcome),
    ) -> Vec<(usize, usize)> {
        let (springs, travel) = (&mechanism.names.vehicle.springs, travel(mechanism));
        let is_stated = |measure| case.along.iter().any(|(stated, _)| *stated == measure);
        if springs.iter().any(|spring| is_stated(spring.measure)) {
            return Vec::new();
        }
        let bears = |drive: usize| {
            let is_relieved = case.borne_by.iter().any(|(borne, _)| *borne == drive);
            !is_relieved && outcome.on_drives[drive].abs() > ROUNDING * outcome.largest_load
        };
        if !travel.iter().any(|drive| bears(*drive)) {
            return Vec::new();
        }
        let is_free = |measure| case.borne_by.iter().all(|(_, bearing)| *bearing != measure);
        let free = springs.iter().enumerate();
        let free = free.filter(|(_, spring)| is_free(spring.measure));
        let moved = free.filter_map(|(number, spring)| {
            let ratios = self.ratios(mechanism, state, spring.measure)?;
            Some((number, spring.load, ratios))
        });
        let moved: Vec<Moved> = moved.collect();
        let unborne = travel.iter().filter(|drive| bears(**drive));
        let unborne = unborne.filter_map(|drive| Some((*drive, most(&moved, *drive, &travel)?)));
        unborne.collect()
    }

    /// What a measure changes by per unit of each drive: the work of a force of 1 N in it.
    fn ratios(
        &self,
        mechanism: &dyn Kinematics,
        state: &State,
        measure: usize,
    ) -> Option<Vec<f64>> {
        let here = self.here(mechanism, state);
        let acting = here.in_measure(measure, 1.0);
        Some(here.under(&summed(&acting, here.points()), &[])?.on_drives)
    }
}

/// A spring by number, its load at the design position, and what its measure changes by per unit of each drive.
type Moved = (usize, f64, Vec<f64>);

/// The spring that moves with a drive and least with the others of travel; of several alike the one with the largest load.
fn most(moved: &[Moved], drive: usize, travel: &[usize]) -> Option<usize> {
    let shares = moved.iter().map(|(number, load, ratios)| {
        let all: f64 = travel.iter().map(|drive| ratios[*drive].abs()).sum();
        let share = ratios[drive].abs() / all;
        (*number, [share, (load * ratios[drive]).abs()])
    });
    let moved = shares.filter(|(_, [share, _])| *share > ROUNDING);
    let most = moved.reduce(|most, next| if next.1 > most.1 { next } else { most });
    most.map(|(number, _)| number)
}

/// The drives of travel; where none is known as such the only drive.
fn travel(mechanism: &dyn Kinematics) -> Vec<usize> {
    let names = &mechanism.names;
    match (names.vehicle.travel.as_slice(), names.drives.len()) {
        ([], 1) => vec![0],
        (travel, _) => travel.to_vec(),
    }
}
