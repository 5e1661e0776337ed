//! Drives that bear loads which springs of the file could bear, or another spring on the other side.

use crate::kinematics::Kinematics;
use crate::loads::forces::ROUNDING;
use crate::loads::{Case, Outcome, Structure};
use crate::mechanism::{Pair, State};

/// The drives of travel that bear a load in a case; drives, springs and measures by number.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Unborne {
    /// Each drive with the spring of the file that moves most with it.
    pub by_springs: Vec<(usize, usize)>,
    /// The drives with which no spring of the file moves, although one does with the other wheel of the axle.
    pub one_sided: Vec<OneSided>,
}

/// A drive of travel without a spring of its own, while the opposite one has one.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct OneSided {
    /// The drive.
    pub drive: usize,
    /// The measure along which its spring would act.
    pub measure: usize,
    /// The drive of the other wheel.
    pub opposite: usize,
    /// The spring of the opposite drive.
    pub spring: usize,
}

impl Structure<'_> {
    /// The drives of travel that bear a load in a case; none if the case states a load in a spring's measure, or springs act by their
    /// rates.
    pub fn unborne(
        &self,
        mechanism: &dyn Kinematics,
        case: &Case,
        (state, outcome): (&State, &Outcome),
    ) -> Unborne {
        let (springs, travel) = (&mechanism.names.vehicle.springs, travel(mechanism));
        let is_stated = |measure| case.along.iter().any(|(stated, _)| *stated == measure);
        if !case.acting.is_empty() || springs.iter().any(|spring| is_stated(spring.measure)) {
            return Unborne::default();
        }
        let bears = |drive: &usize| {
            let is_relieved = case.borne_by.iter().any(|(borne, _)| borne == drive);
            !is_relieved && outcome.on_drives[*drive].abs() > ROUNDING * outcome.largest_load
        };
        let bearing: Vec<usize> = travel.iter().copied().filter(bears).collect();
        if bearing.is_empty() {
            return Unborne::default();
        }
        let moved = self.moved(mechanism, state, &travel);
        let mut unborne = Unborne::default();
        for drive in bearing {
            let is_taken = |spring: usize| {
                let measure = springs[spring].measure;
                let mut bearing = case.borne_by.iter();
                bearing.any(|(_, by)| *by == measure)
                    || unborne.by_springs.iter().any(|(_, own)| *own == spring)
            };
            if let Some(spring) = moved.spring(drive, &is_taken) {
                unborne.by_springs.push((drive, spring));
            } else {
                unborne.one_sided.extend(moved.one_sided(drive));
            }
        }
        unborne
    }

    /// The first drive of travel with which a spring of the file moves, and that spring.
    pub fn sprung(&self, mechanism: &dyn Kinematics, state: &State) -> Option<(usize, usize)> {
        let travel = travel(mechanism);
        let moved = self.moved(mechanism, state, &travel);
        let spring = |drive: &usize| Some((*drive, moved.spring(*drive, &|_| false)?));
        travel.iter().find_map(spring)
    }

    fn moved<'a>(
        &self,
        mechanism: &'a dyn Kinematics,
        state: &State,
        travel: &'a [usize],
    ) -> Moved<'a> {
        let here = self.here(mechanism, state);
        // The change of a measure per unit of a drive is the work of a force of 1 N in it.
        let ratios = |measure| {
            let acting = here.forces_in_measure(measure, 1.0);
            Some(here.solve(&acting, &[])?.on_drives)
        };
        Moved {
            mechanism,
            ratios: (0..mechanism.names.measures.len()).map(ratios).collect(),
            travel,
        }
    }
}

/// How many times as far as with any other drive of travel a measure moves with the one to which it belongs. A bar or a heave
/// spring belongs to neither wheel, also where one of them stands higher and the wheels do not move it alike.
const OWN: f64 = 2.0;

/// The motion of measures with the drives of travel.
struct Moved<'a> {
    mechanism: &'a dyn Kinematics,
    /// The change of each measure per unit of each drive.
    ratios: Vec<Option<Vec<f64>>>,
    travel: &'a [usize],
}

impl Moved<'_> {
    /// The ratio of a measure to the drive of travel to which it belongs, and the drive's share of all.
    fn with(&self, measure: usize, drive: usize) -> Option<[f64; 2]> {
        let ratios = self.ratios[measure].as_ref()?;
        let own = ratios[drive].abs();
        let others = self.travel.iter().filter(|other| **other != drive);
        let sizes = others.map(|other| ratios[*other].abs());
        let (all, most) = sizes.fold((own, 0.0), |(all, most), size| {
            (all + size, f64::max(most, size))
        });
        (own > OWN * most + ROUNDING * all).then_some([own, own / all])
    }

    /// The spring that moves with a drive and least with the others of travel; if several do so alike, the one with
    /// the largest load.
    fn spring(&self, drive: usize, is_taken: &dyn Fn(usize) -> bool) -> Option<usize> {
        let springs = self.mechanism.names.vehicle.springs.iter().enumerate();
        let free = springs.filter(|(spring, _)| !is_taken(*spring));
        let moved = free.filter_map(|(number, spring)| {
            let [ratio, share] = self.with(spring.measure, drive)?;
            Some((number, [share, (spring.load * ratio).abs()]))
        });
        let most = moved.reduce(|most, next| if next.1 > most.1 { next } else { most });
        most.map(|(number, _)| number)
    }

    /// A drive without a spring, while the one of the other wheel of its axle has one, with the measure that moves
    /// with it most like that spring's measure moves with the other.
    fn one_sided(&self, drive: usize) -> Option<OneSided> {
        let names = &self.mechanism.names;
        if self.spring(drive, &|_| false).is_some() {
            return None;
        }
        let opposite = self.opposite(drive)?;
        let spring = self.spring(opposite, &|_| false)?;
        let along = names.vehicle.springs[spring].measure;
        let [wanted, _] = self.with(along, opposite)?;
        let measures = names.measures.iter().enumerate();
        let alike = measures.filter(|(_, measure)| measure.kind == names.measures[along].kind);
        let off = alike.filter_map(|(measure, _)| {
            let [ratio, _] = self.with(measure, drive)?;
            Some((measure, (ratio - wanted).abs()))
        });
        let (measure, _) = off.min_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(OneSided {
            drive,
            measure,
            opposite,
            spring,
        })
    }

    /// The drive of travel of the other wheel of an axle.
    fn opposite(&self, drive: usize) -> Option<usize> {
        let wheels = &self.mechanism.names.wheels;
        let own = wheels
            .iter()
            .position(|wheel| wheel.travel == Some(drive))?;
        let mut pairs = Pair::all(wheels).into_iter();
        let other = pairs.find_map(|pair| pair.other(own))?;
        wheels[other].travel.filter(|other| *other != drive)
    }
}

/// The drives of travel; if none is known, the only drive.
fn travel(mechanism: &dyn Kinematics) -> Vec<usize> {
    let names = &mechanism.names;
    match (names.vehicle.travel.as_slice(), names.drives.len()) {
        ([], 1) => vec![0],
        (travel, _) => travel.to_vec(),
    }
}
