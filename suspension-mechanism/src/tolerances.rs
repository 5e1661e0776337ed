//! The scatter of quantities due to that of hardpoints and lengths.

use std::sync::atomic::{AtomicBool, Ordering};

use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

use crate::characteristics::columns;
use crate::kinematics::{Changes, Kinematics};
use crate::sensitivities::{Change, Sensitivities, design_values};

/// A change with a random size, independent of all others.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// The change.
    pub change: Change,
    /// Its standard deviation, in the unit of lengths.
    pub deviation: f64,
}

/// Standard deviations: for each column those of its value and of its derivatives with respect to each drive.
pub type Deviations = Vec<Vec<f64>>;

/// The standard deviations that follow from sensitivities, to first order: `sqrt(sum (s d)^2)`. They count as unknown
/// if a change makes a suspension that cannot be built.
pub fn first_order(found: &Sensitivities, tolerances: &[Tolerance]) -> Deviations {
    let deviation = |column: usize, number: usize| {
        let parts = tolerances.iter().map(|tolerance| {
            let mut each = found.each.iter();
            let sensitivity = each.find(|each| each.change == tolerance.change);
            sensitivity.map_or(f64::NAN, |each| {
                each.of[(column, number)] * tolerance.deviation
            })
        });
        parts.map(|part| part * part).sum::<f64>().sqrt()
    };
    let columns = found.values.iter().enumerate();
    columns
        .map(|(column, numbers)| {
            (0..numbers.len())
                .map(|number| deviation(column, number))
                .collect()
        })
        .collect()
}

/// The standard deviations of suspensions built with random changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// The standard deviations; NaN if a sample has no such number.
    pub deviations: Deviations,
    /// The number of suspensions that could be built.
    pub built: usize,
}

/// Builds `count` suspensions with normally distributed changes, the same for the same seed; `None` if the user
/// interrupts, or if fewer than two can be built.
pub fn sampled(
    mechanism: &dyn Kinematics,
    tolerances: &[Tolerance],
    (count, seed): (usize, u64),
    interrupted: &AtomicBool,
    mut on_sample: impl FnMut(),
) -> Option<Sampled> {
    let columns = columns(mechanism);
    let mut random = Pcg64::seed_from_u64(seed);
    let mut built = 0;
    let mut spreads: Vec<Vec<Spread>> = Vec::new();
    for _ in 0..count {
        if interrupted.load(Ordering::Relaxed) {
            return None;
        }
        on_sample();
        let each = tolerances.iter().map(|tolerance| {
            let normal: f64 = StandardNormal.sample(&mut random);
            tolerance
                .change
                .per_unit
                .times(normal * tolerance.deviation)
        });
        let changes = Changes::sum(each);
        let changed = mechanism.changed(&changes);
        if let Some(sample) = changed
            .ok()
            .and_then(|changed| design_values(&*changed, &columns))
        {
            built += 1;
            add(&mut spreads, &sample);
        }
    }
    let of_column = |column: &Vec<Spread>| column.iter().map(Spread::deviation).collect();
    (built > 1).then(|| Sampled {
        deviations: spreads.iter().map(of_column).collect(),
        built,
    })
}

/// Adds a sample to the earlier ones.
fn add(spreads: &mut Vec<Vec<Spread>>, sample: &[Vec<f64>]) {
    spreads.resize_with(sample.len(), Vec::new);
    for (spreads, numbers) in spreads.iter_mut().zip(sample) {
        spreads.resize_with(numbers.len(), Spread::default);
        for (spread, number) in spreads.iter_mut().zip(numbers) {
            spread.add(*number);
        }
    }
}

/// The spread of numbers about their own mean, without storing the numbers, of which there may be millions (Welford's
/// recurrence).
#[derive(Default)]
struct Spread {
    count: f64,
    mean: f64,
    squares: f64,
}

impl Spread {
    fn add(&mut self, number: f64) {
        self.count += 1.0;
        let before = number - self.mean;
        self.mean += before / self.count;
        self.squares += before * (number - self.mean);
    }

    fn deviation(&self) -> f64 {
        (self.squares / (self.count - 1.0)).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_has_the_sample_standard_deviation() {
        let numbers = [1e6, 1e6 + 1.0, 1e6 + 2.0, 1e6 + 5.0];
        let mut spread = Spread::default();
        numbers.into_iter().for_each(|number| spread.add(number));
        assert!((spread.deviation().powi(2) - 14.0 / 3.0).abs() < 1e-12);
        spread.add(f64::NAN);
        assert!(spread.deviation().is_nan());
    }
}
