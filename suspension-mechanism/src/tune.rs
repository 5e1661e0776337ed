//! Tuning: hardpoints and lengths are moved within boxes until quantities meet their targets.
//!
//! The suspension is rebuilt for each trial and solved at all places of all targets. The sum of the squared errors is
//! minimised, each error relative to its allowed value.

mod fit;
mod target;

use std::sync::atomic::AtomicBool;

use nalgebra::{DVector, Vector3};

use crate::failure::Failure;
use crate::kinematics::{Changes, Kinematics, misplaced_points};
use fit::{Bounds, Fit, fit, start};

pub use fit::MOST_STEPS;
pub use target::{Deviations, Reading, Target, Wanted};

/// A part of the design that may be moved.
#[derive(Clone, Debug, PartialEq)]
pub struct Move {
    /// Its name.
    pub name: String,
    /// The change per unit of length of the move.
    pub per_unit: Changes,
    /// The smallest and the largest move.
    pub by: [f64; 2],
}

/// The result of tuning.
#[derive(Clone, Debug, PartialEq)]
pub struct Tuned {
    /// The size of each move.
    pub moved: Vec<f64>,
    /// The deviations of each target before the moves and after them.
    pub targets: Vec<[Deviations; 2]>,
    /// All points of the design, in the file's coordinates.
    pub points: Vec<Vector3<f64>>,
    /// The drives at the design, in the file's coordinates.
    pub drives: Vec<f64>,
    /// Points, by number, that assembly puts elsewhere than the moves do, because what holds them was not moved.
    pub held: Vec<usize>,
    /// Targets, by number, that no move changes near the design.
    pub unaffected: Vec<usize>,
    /// Moves, by number, that change no target near the design.
    pub idle: Vec<usize>,
    /// Whether the user interrupted before the best was found.
    pub interrupted: bool,
}

/// Makes moves until the targets are met, or as nearly as they can be.
///
/// # Errors
///
/// [`Failure::Solver`] if the mechanism without moves does not reach all places of a target.
pub fn tune(
    (source, mechanism): (&str, &dyn Kinematics),
    moves: &[Move],
    targets: &[Target],
    interrupted: &AtomicBool,
    on_step: impl FnMut(),
) -> Result<Tuned, Failure> {
    let problem = Problem {
        mechanism,
        moves,
        targets,
    };
    let before = targets.iter().map(|target| target.check(source, mechanism));
    let before = before.collect::<Result<Vec<_>, _>>()?;
    let boxes = problem.boxes();
    let residuals = |moved: &DVector<f64>| problem.residuals(moved);
    let Fit { at, is_cut } = fit(&boxes, residuals, interrupted, on_step);
    let unmoved = || {
        Failure::Solver(format!(
            "{source}: no combination of moves within their boxes lets the mechanism reach all places of the targets; widen \
             the boxes"
        ))
    };
    let at = at.ok_or_else(unmoved)?;
    let tuned = problem.moved(&at).ok_or_else(unmoved)?;
    let after = problem.deviations(&*tuned).ok_or_else(unmoved)?;
    let [unaffected, idle] = problem.find_without_effect(&boxes);
    Ok(Tuned {
        unaffected,
        idle,
        moved: at.iter().copied().collect(),
        targets: before.into_iter().zip(after).map(|(a, b)| [a, b]).collect(),
        points: tuned.points(),
        drives: tuned.drives_in_file(tuned.first_drives()),
        held: held(mechanism, problem.changes(&at).points),
        interrupted: is_cut,
    })
}

/// A mechanism, its moves, and its targets.
struct Problem<'a> {
    mechanism: &'a dyn Kinematics,
    moves: &'a [Move],
    targets: &'a [Target],
}

impl Problem<'_> {
    fn boxes(&self) -> Vec<Bounds> {
        let boxes = self.moves.iter().map(|each| Bounds {
            least: each.by[0],
            greatest: each.by[1],
        });
        boxes.collect()
    }

    /// The changes of all moves together, each of size `moved`.
    fn changes(&self, moved: &DVector<f64>) -> Changes {
        let each = self.moves.iter().zip(moved.iter());
        Changes::sum(each.map(|(each, by)| each.per_unit.times(*by)))
    }

    /// The mechanism with the moves; `None` if it cannot be assembled.
    fn moved(&self, moved: &DVector<f64>) -> Option<Box<dyn Kinematics + '_>> {
        self.mechanism.changed(&self.changes(moved)).ok()
    }

    /// The deviations of each target of a mechanism.
    fn deviations(&self, mechanism: &dyn Kinematics) -> Option<Vec<Deviations>> {
        let each = self.targets.iter();
        each.map(|target| target.deviations(mechanism)).collect()
    }

    /// The deviations of the targets with the moves, as fractions of the permitted ones.
    fn residuals(&self, moved: &DVector<f64>) -> Option<DVector<f64>> {
        let off = self.deviations(&*self.moved(moved)?)?;
        let parts = off.iter().zip(self.targets);
        let parts = parts.flat_map(|(off, target)| off.iter().map(|off| off / target.within));
        Some(DVector::from_vec(parts.collect()))
    }

    /// Targets that no move changes, and moves that change no target, near the start of the moves.
    fn find_without_effect(&self, boxes: &[Bounds]) -> [Vec<usize>; 2] {
        let Some(changed) = self.changed(boxes) else {
            return Default::default();
        };
        let is_unaffected = |target: &usize| changed.iter().all(|by_move| !by_move[*target]);
        let is_idle = |each: &usize| !changed[*each].contains(&true);
        let (targets, moves) = (0..self.targets.len(), 0..self.moves.len());
        [
            targets.filter(is_unaffected).collect(),
            moves.filter(is_idle).collect(),
        ]
    }

    /// For each move, whether it changes each target near the start of the moves; `None` if a trial has no answer.
    fn changed(&self, boxes: &[Bounds]) -> Option<Vec<Vec<bool>>> {
        /// The trial step as a fraction of a box, and the change of a target as a fraction of its permitted
        /// deviation: a smaller change would amount to less than a thousandth of that over the whole box.
        const BESIDE: f64 = 1e-3;
        const SAME: f64 = 1e-6;
        let off = |moved: &DVector<f64>| self.deviations(&*self.moved(moved)?);
        let start = start(boxes);
        let here = off(&start)?;
        let by_move = |(each, bounds): (usize, &Bounds)| {
            let mut at = start.clone();
            at[each] += BESIDE * (bounds.farther_end(at[each]) - at[each]);
            let beside = off(&at)?;
            let pairs = here.iter().zip(&beside).zip(self.targets);
            let changes = pairs.map(|((here, beside), target)| {
                let mut each = here.iter().zip(beside);
                each.any(|(here, beside)| (beside - here).abs() > SAME * target.within)
            });
            Some(changes.collect())
        };
        boxes.iter().enumerate().map(by_move).collect()
    }
}

/// The moved points that are not where they were moved to when the mechanism is assembled.
fn held(mechanism: &dyn Kinematics, points: Vec<(usize, Vector3<f64>)>) -> Vec<usize> {
    let moved: Vec<usize> = points.iter().map(|(point, _)| *point).collect();
    let mut elsewhere = misplaced_points(mechanism, points);
    elsewhere.retain(|point| moved.contains(point));
    elsewhere
}
