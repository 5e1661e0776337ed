//! Curves over the travel of a wheel, for any drives.

use crate::characteristics::curves::Curves;
use crate::characteristics::line::{Line, Sort};
use crate::characteristics::parameters::symbol_per;
use crate::characteristics::title::Title;
use crate::file::Dimension;
use crate::mechanism::Unit;
use crate::quantities::WHEEL_TRAVEL;

impl Line {
    /// Whether it is the rise of a wheel.
    pub fn is_wheel_travel(&self) -> bool {
        self.title.of_wheel == WHEEL_TRAVEL.title
    }

    /// Whether it rises all along.
    pub fn is_rising(&self) -> bool {
        let known: Vec<f64> = self.values.iter().copied().flatten().collect();
        known.windows(2).all(|pair| pair[0] < pair[1])
    }

    /// Its first and its last value.
    pub fn ends(&self) -> Option<[f64; 2]> {
        let mut known = self.values.iter().flatten();
        Some([*known.next()?, *known.next_back()?])
    }
}

impl Curves {
    /// The same curves over the `travels` of a wheel that rises all along, with lengths in `unit`: interpolated
    /// between the changes of the drive by the cubic through the four nearest. Motion ratios are per travel of the
    /// wheel.
    pub fn over_travel_of(&self, wheel: &Line, travels: Vec<f64>, unit: Unit) -> Self {
        let lines = self.lines.iter();
        let scaled = lines.flat_map(|line| lines_over(line, wheel, unit));
        let lines = scaled.map(|line| Line {
            values: read_at(&wheel.values, &line.values, &travels),
            rates: vec![None; travels.len()],
            ..line
        });
        Self {
            title: wheel.title.to_string(),
            movement: self.movement,
            moved: wheel.title.to_string(),
            dimension: Dimension::Length,
            lines: lines.collect(),
            left_out: self.left_out.clone(),
            is_without_small_steer: self.is_without_small_steer,
            changes: travels,
        }
    }
}

/// A line over the travel of a wheel: motion ratios are per this travel instead of the drive.
fn lines_over(line: &Line, travel: &Line, unit: Unit) -> Vec<Line> {
    match line.sort {
        Sort::Quantity => vec![line.clone()],
        Sort::MotionRatio => Vec::new(),
        Sort::Measure => {
            let both = line.rates.iter().zip(&travel.rates);
            let ratio = both.map(|(of_measure, of_wheel)| Some((*of_measure)? / (*of_wheel)?));
            let ratio = Line {
                title: Title {
                    of_wheel: format!("motion ratio: {} per wheel travel", line.title.of_wheel),
                    ..line.title.clone()
                },
                symbol: symbol_per(&line.symbol, Dimension::Length, unit),
                values: ratio
                    .map(|ratio| ratio.filter(|it| it.is_finite()))
                    .collect(),
                sort: Sort::MotionRatio,
                ..line.clone()
            };
            vec![ratio, line.clone()]
        }
    }
}

/// Values known at rising places, interpolated by the cubic through four neighbours.
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
    fn interpolation_is_exact_for_a_cubic_and_does_not_extrapolate() {
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
    fn interpolation_does_not_cross_missing_values() {
        let places = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(Some);
        let values = [Some(0.0), Some(1.0), None, Some(3.0), Some(4.0), Some(5.0)];
        let found = read_at(&places, &values, &[0.5, 1.0, 1.5, 2.5, 3.0, 3.5]);
        let is_known = found.iter().map(Option::is_some);
        let expected = [true, true, false, false, true, true];
        assert_eq!(is_known.collect::<Vec<_>>(), expected);
    }
}
