//! Tuning: hardpoints and lengths are moved within boxes until quantities meet their targets.
//!
//! The suspension is rebuilt for each trial and solved at all places of all targets. The sum of the squared errors is
//! minimised, each error relative to its allowed value.

mod fit;
mod target;

use std::sync::atomic::AtomicBool;

use nalgebra::{DVector, Vector3};

use crate::failure::Failure;
use crate::kinematics::{Changes, Kinematics};
use fit::{Bounds, Fit, fit, start};

pub use fit::MOST_STEPS;
pub use target::{Deviations, Reading, Target, Wanted};

/// Something that may be moved.
#[derive(Clone, Debug, PartialEq)]
pub struct Move {
    /// Its name.
    pub name: String,
    /// What changes where it is moved by one unit of length.
    pub per_unit: Changes,
    /// The least and the greatest that it may be moved.
    pub by: [f64; 2],
}

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Tuned {
    /// How far each move went.
    pub moved: Vec<f64>,
    /// How far each target is off before, and with the moves.
    pub targets: Vec<[Deviations; 2]>,
    /// All points of the design, in the file's coordinates.
    pub points: Vec<Vector3<f64>>,
    /// The drives at the design, in the file's coordinates.
    pub drives: Vec<f64>,
    /// Points, by number, that assembly puts elsewhere than the moves do: what holds them was not moved.
    pub held: Vec<usize>,
    /// Targets, by number, that no move changes, next to the design.
    pub unaffected: Vec<usize>,
    /// Moves, by number, that change no target there.
    pub idle: Vec<usize>,
    /// Whether the user interrupted before the best was found.
    pub interrupted: bool,
}

/// Moves what may be moved until the targets are met, or as near as they can be.
///
/// # Errors
///
/// [`Failure::Solver`] where the mechanism as it is does not get to all places of a target.
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
            "{source}: the moves have no place in their boxes at which the mechanism gets to all places of the targets; widen \
             the boxes"
        ))
    };
    let at = at.ok_or_else(unmoved)?;
    let tuned = problem.moved(&at).ok_or_else(unmoved)?;
    let after = problem.deviations(&*tuned).ok_or_else(unmoved)?;
    let [unaffected, idle] = problem.without_effect(&boxes);
    Ok(Tuned {
        unaffected,
        idle,
        moved: at.iter().copied().collect(),
        targets: before.into_iter().zip(after).map(|(a, b)| [a, b]).collect(),
        points: tuned.points(),
        drives: tuned.given(&tuned.first_drives()),
        held: held(mechanism, problem.changes(&at).points),
        interrupted: is_cut,
    })
}

/// A mechanism, what may be moved of it, and what is to be reached.
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

    /// What all moves together change, each `moved` so far.
    fn changes(&self, moved: &DVector<f64>) -> Changes {
        let each = self.moves.iter().zip(moved.iter());
        Changes::together(each.map(|(each, by)| each.per_unit.times(*by)))
    }

    /// The mechanism, each move made so far; `None` where it cannot be assembled.
    fn moved(&self, moved: &DVector<f64>) -> Option<Box<dyn Kinematics + '_>> {
        self.mechanism.changed(&self.changes(moved))
    }

    /// How far each target of a mechanism is off.
    fn deviations(&self, mechanism: &dyn Kinematics) -> Option<Vec<Deviations>> {
        let each = self.targets.iter();
        each.map(|target| target.deviations(mechanism)).collect()
    }

    /// How far the targets are off with the moves, in parts of what they may be off.
    fn residuals(&self, moved: &DVector<f64>) -> Option<DVector<f64>> {
        let off = self.deviations(&*self.moved(moved)?)?;
        let parts = off.iter().zip(self.targets);
        let parts = parts.flat_map(|(off, target)| off.iter().map(|off| off / target.within));
        Some(DVector::from_vec(parts.collect()))
    }

    /// Targets that no move changes, and moves that change no target, next to where the moves begin.
    fn without_effect(&self, boxes: &[Bounds]) -> [Vec<usize>; 2] {
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

    /// Of each move whether it changes each target, from where the moves begin to next to that; `None` where a trial has no answer.
    fn changed(&self, boxes: &[Bounds]) -> Option<Vec<Vec<bool>>> {
        /// Of a box, and of what a target may be off: what changes less would change a thousandth of that in the whole box.
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

/// The points that are not where they were moved to once the mechanism is assembled.
fn held(mechanism: &dyn Kinematics, points: Vec<(usize, Vector3<f64>)>) -> Vec<usize> {
    /// Of how far they were moved.
    const OFF: f64 = 1e-3;
    /// Of the largest coordinate.
    const ROUNDING: f64 = 1e-9;
    let before = mechanism.points();
    let mut moved = vec![Vector3::zeros(); before.len()];
    for (point, by) in &points {
        moved[*point] += by;
    }
    let lengths = Vec::new();
    let assembled = mechanism.changed(&Changes { points, lengths });
    let after = assembled.map_or_else(Vec::new, |mechanism| mechanism.points());
    let size = before
        .iter()
        .fold(0.0, |most, point| f64::max(most, point.amax()));
    let each = before.iter().zip(&after).zip(&moved).enumerate();
    let held = each.filter(|(_, ((before, after), by))| {
        let off = (*after - *before - *by).norm();
        **by != Vector3::zeros() && off > (OFF * by.norm()).max(ROUNDING * size)
    });
    held.map(|(point, _)| point).collect()
}
