//! Curves over the travel of the wheel, where equal changes of two drives are not equal travels.

use crate::characteristics::{Curves, Does, Line, Sort, Title};
use crate::commands::compare::differences::{ALIKE, pairs, title_of_both};
use crate::file::Dimension;
use crate::mechanism::{Unit, evenly_spaced};
use crate::quantities::WHEEL_TRAVEL;

/// Whether equal changes of the two drives do not move the wheels equally far; not asked of drives that steer.
pub(super) fn are_unlike(both: [&Curves; 2]) -> bool {
    let [a, b] = both;
    if a.way.does == Does::Steer {
        return false;
    }
    let is_further = |[a, b]: [f64; 2]| (b - a).abs() > ALIKE * a.abs();
    a.dimension != b.dimension || rises(both).is_some_and(is_further)
}

/// How far the wheel of each rises per change of its drive, on average over the curve.
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

/// How far wheels travel along both.
fn wheels([a, b]: [&Curves; 2]) -> impl Iterator<Item = [&Line; 2]> {
    let is_travel = |pair: &[&Line; 2]| pair[0].title.of_wheel == WHEEL_TRAVEL.title;
    pairs(a, b).into_iter().filter(is_travel)
}

/// The first wheel that rises all along both.
fn rising(both: [&Curves; 2]) -> Option<[&Line; 2]> {
    wheels(both).find(|pair| pair.iter().all(|line| is_rising(line)))
}

/// Both over the travel of the first wheel that rises all along, as far as both go, with lengths in `unit`; `None` where there is none.
pub(super) fn by_wheel([a, b]: [&Curves; 2], unit: Unit) -> Option<[Curves; 2]> {
    let [of_a, of_b] = rising([a, b])?;
    let [from_a, to_a] = ends(of_a)?;
    let [from_b, to_b] = ends(of_b)?;
    let (from, to) = (from_a.max(from_b), to_a.min(to_b));
    if from >= to {
        return None;
    }
    let changes = evenly_spaced([from, to], a.changes.len());
    let title = title_of_both([&of_a.title, &of_b.title]);
    Some([(a, of_a), (b, of_b)].map(|(curves, travel)| {
        let lines = curves.lines.iter();
        let over = lines.flat_map(|line| lines_over(line, travel, unit));
        let lines = over.map(|line| Line {
            values: read_at(&travel.values, &line.values, &changes),
            ..line
        });
        Curves {
            title: title.clone(),
            way: curves.way,
            moved: title.clone(),
            dimension: Dimension::Length,
            lines: lines.collect(),
            changes: changes.clone(),
        }
    }))
}

fn ends(line: &Line) -> Option<[f64; 2]> {
    let mut known = line.values.iter().flatten();
    Some([*known.next()?, *known.next_back()?])
}

fn is_rising(line: &Line) -> bool {
    let known: Vec<f64> = line.values.iter().copied().flatten().collect();
    known.windows(2).all(|pair| pair[0] < pair[1])
}

/// What a line is over the travel of a wheel: motion ratios are per this travel in place of the drive.
fn lines_over(line: &Line, travel: &Line, unit: Unit) -> Vec<Line> {
    let whole = Line {
        rates: vec![None; line.values.len()],
        ..line.clone()
    };
    match line.sort {
        Sort::Quantity => vec![whole],
        Sort::MotionRatio => Vec::new(),
        Sort::Measure => {
            let both = line.rates.iter().zip(&travel.rates);
            let ratio = both.map(|(of_measure, of_wheel)| Some((*of_measure)? / (*of_wheel)?));
            let ratio = Line {
                title: Title {
                    wheel: None,
                    of_wheel: format!("motion ratio: {} per wheel travel", line.title),
                },
                symbol: format!("{}/{}", line.symbol, unit.symbol()),
                values: ratio
                    .map(|ratio| ratio.filter(|it| it.is_finite()))
                    .collect(),
                sort: Sort::MotionRatio,
                ..whole.clone()
            };
            vec![ratio, whole]
        }
    }
}

/// What is known at rising places, read between them: of four neighbours the cubic through them.
fn read_at(places: &[Option<f64>], values: &[Option<f64>], wanted: &[f64]) -> Vec<Option<f64>> {
    const NEIGHBOURS: usize = 4;
    let both = places.iter().zip(values).enumerate();
    let known = both.filter_map(|(number, (place, value))| Some((number, (*place)?, (*value)?)));
    let known: Vec<(usize, f64, f64)> = known.collect();
    let read = |at: &f64| {
        let after = known.partition_point(|(_, place, _)| place < at);
        let [before, after] = [after.saturating_sub(1), after];
        let (next, last) = (known.get(after)?, known.get(before)?);
        let is_between = next.1 == *at || (last.1 <= *at && next.0 == last.0 + 1);
        let first = before
            .saturating_sub(NEIGHBOURS / 2 - 1)
            .min(known.len().saturating_sub(NEIGHBOURS));
        let through = &known[first..known.len().min(first + NEIGHBOURS)];
        is_between.then(|| polynomial(through, *at))
    };
    wanted.iter().map(read).collect()
}

/// The polynomial through points, in Lagrange's form.
fn polynomial(through: &[(usize, f64, f64)], at: f64) -> f64 {
    let term = |(number, place, value): &(usize, f64, f64)| {
        let others = through.iter().filter(|(other, ..)| other != number);
        let weights = others.map(|(_, other, _)| (at - other) / (place - other));
        value * weights.product::<f64>()
    };
    through.iter().map(term).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_read_exactly_between_uneven_places_and_not_beyond_them() {
        let places = [0.0, 0.1, 0.25, 0.3, 0.5, 0.6, 0.8];
        let cubic = |x: f64| 1.0 + x * (2.0 - x * (3.0 - 4.0 * x));
        let known = places.map(Some);
        let values = places.map(|place| Some(cubic(place)));
        let wanted = [0.0, 0.05, 0.3, 0.41, 0.79, 0.8];
        for (at, found) in wanted.iter().zip(read_at(&known, &values, &wanted)) {
            let found = found.expect("between the ends");
            assert!((found - cubic(*at)).abs() < 1e-15 * 16.0, "{at}: {found}");
        }
        assert_eq!(read_at(&known, &values, &[-0.01, 0.81]), [None, None]);
    }

    #[test]
    fn nothing_is_read_across_what_is_missing() {
        let places = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(Some);
        let values = [Some(0.0), Some(1.0), None, Some(3.0), Some(4.0), Some(5.0)];
        let found = read_at(&places, &values, &[0.5, 1.0, 1.5, 2.5, 3.0, 3.5]);
        let is_known = found.iter().map(Option::is_some);
        let expected = [true, true, false, false, true, true];
        assert_eq!(is_known.collect::<Vec<_>>(), expected);
    }
}
