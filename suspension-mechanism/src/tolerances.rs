//! How much quantities scatter where hardpoints and lengths do.

use std::sync::atomic::{AtomicBool, Ordering};

use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

use crate::characteristics::columns;
use crate::kinematics::{Changes, Kinematics};
use crate::sensitivities::{Change, Sensitivities, read};

/// Something that scatters, independent of all else.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// What.
    pub change: Change,
    /// Its standard deviation, in the unit of lengths.
    pub deviation: f64,
}

/// Standard deviations, of each column those of its value and of its derivatives with respect to each drive.
pub type Deviations = Vec<Vec<f64>>;

/// Those that follow from sensitivities, to first order: `sqrt(sum (s d)^2)`. What no suspension could be built with counts as
/// not known.
pub fn first_order(found: &Sensitivities, tolerances: &[Tolerance]) -> Deviations {
    let of = |column: usize, number: usize| {
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
                .map(|number| of(column, number))
                .collect()
        })
        .collect()
}

/// Those of suspensions built with random changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// The standard deviations; NaN where a sample has no such number.
    pub deviations: Deviations,
    /// How many suspensions could be built.
    pub built: usize,
}

/// Builds so many suspensions with normally distributed changes, the same for the same seed; `None` where the user interrupts, or
/// fewer than two can be built.
pub fn sampled(
    mechanism: &dyn Kinematics,
    tolerances: &[Tolerance],
    (count, seed): (usize, u64),
    interrupted: &AtomicBool,
    mut on_sample: impl FnMut(),
) -> Option<Sampled> {
    let columns = columns(mechanism);
    let mut random = Pcg64::seed_from_u64(seed);
    let mut samples = Vec::new();
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
        let changes = Changes::together(each);
        let changed = mechanism.changed(&changes);
        samples.extend(changed.and_then(|changed| read(&*changed, &columns)));
    }
    let first = samples.first().filter(|_| samples.len() > 1)?;
    let of = |column: usize, number: usize| {
        deviation(samples.iter().map(|sample| sample[column][number]))
    };
    let deviations = first.iter().enumerate();
    let deviations = deviations.map(|(column, numbers)| {
        (0..numbers.len())
            .map(|number| of(column, number))
            .collect()
    });
    Some(Sampled {
        deviations: deviations.collect(),
        built: samples.len(),
    })
}

/// The standard deviation of numbers, from their own mean.
fn deviation(numbers: impl Iterator<Item = f64> + Clone) -> f64 {
    let count = numbers.clone().count() as f64;
    let mean = numbers.clone().sum::<f64>() / count;
    let squares = numbers.map(|number| (number - mean).powi(2));
    (squares.sum::<f64>() / (count - 1.0)).sqrt()
}
