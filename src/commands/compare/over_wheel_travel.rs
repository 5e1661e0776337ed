//! Curves over the travel of the wheel, for drives of which equal changes do not move the wheels equally far.

use crate::characteristics::{Curves, Effect, Line, through_design};
use crate::commands::compare::differences::{ALIKE, pairs, title_of_both};
use crate::mechanism::Unit;

/// Returns whether equal changes of the two drives move the wheels unequally far; `false` for drives that steer.
pub(super) fn are_unlike(both: [&Curves; 2]) -> bool {
    let [a, b] = both;
    if a.movement.effect == Effect::Steer {
        return false;
    }
    let is_further = |[a, b]: [f64; 2]| (b - a).abs() > ALIKE * a.abs();
    a.dimension != b.dimension || rises(both).is_some_and(is_further)
}

/// Returns how far the wheel of each rises per change of its drive, on average over the curve.
pub(super) fn rises([a, b]: [&Curves; 2]) -> Option<[f64; 2]> {
    let [of_a, of_b] = rising([a, b]).or_else(|| wheels([a, b]).next())?;
    Some([rise(a, of_a)?, rise(b, of_b)?])
}

fn rise(curves: &Curves, line: &Line) -> Option<f64> {
    let points = curves.points(line);
    let mut known = points.iter().filter(|(_, value)| value.is_finite());
    let (first, last) = (known.next()?, known.next_back()?);
    Some((last.1 - first.1) / (last.0 - first.0))
}

/// Pairs the heights of the wheels along both curves.
fn wheels([a, b]: [&Curves; 2]) -> impl Iterator<Item = [&Line; 2]> {
    let is_travel = |pair: &[&Line; 2]| pair[0].is_wheel_travel();
    pairs(a, b).into_iter().filter(is_travel)
}

/// Returns the first wheel that rises everywhere along both curves.
fn rising(both: [&Curves; 2]) -> Option<[&Line; 2]> {
    wheels(both).find(|pair| pair.iter().all(|line| line.is_rising()))
}

/// Returns both curves over the travel of the first wheel that rises everywhere, over their common range, with lengths in
/// `unit`; `None` if there is no such wheel.
pub(super) fn by_wheel([a, b]: [&Curves; 2], unit: Unit) -> Option<[Curves; 2]> {
    let [of_a, of_b] = rising([a, b])?;
    let ([from_a, to_a], [from_b, to_b]) = (of_a.ends()?, of_b.ends()?);
    let (from, to) = (from_a.max(from_b), to_a.min(to_b));
    if from >= to {
        return None;
    }
    let travels = through_design([from, to], a.changes.len());
    let title = title_of_both([&of_a.title, &of_b.title]).to_string();
    let over = |(curves, wheel): (&Curves, &Line)| Curves {
        title: title.clone(),
        moved: title.clone(),
        ..curves.over_travel_of(wheel, travels.clone(), unit)
    };
    Some([(a, of_a), (b, of_b)].map(over))
}
