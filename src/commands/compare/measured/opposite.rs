//! Measured quantities that change the opposite way to those of the model, as where a rig has the other sign.

use std::collections::BTreeSet;

use super::course::Course;
use super::measured_quantity::MeasuredQuantity;

/// Squares of the differences that remain under the other sign, or the other way of counting, as a part of those as the table
/// is: below this part it fits much better, and beyond its inverse much worse.
const MUCH: f64 = 0.1;

/// How the changes of a quantity from the design position fit those of the model otherwise than as the table states them.
struct Fit<'a> {
    quantity: &'a MeasuredQuantity,
    /// With the other sign: the squares of the differences, as a part of those as stated.
    by_sign: f64,
    /// With the places counted the other way; infinite if the model's curve has too few of these places.
    by_way: f64,
}

/// Returns sentences on quantities that fit the model with the other sign alone, or on the places if these seem to be counted
/// the other way.
pub(super) fn opposite(quantities: &[MeasuredQuantity], course: &Course) -> Vec<String> {
    let fits: Vec<Fit<'_>> = quantities.iter().filter_map(Fit::new).collect();
    let along = &course.wide;
    if is_other_way(&fits) {
        return vec![format!(
            "B seems to count {along} the other way: its quantities change as those of A do at the opposite places"
        )];
    }
    let or_way = match fits.iter().all(|fit| fit.by_sign.max(fit.by_way) < MUCH) {
        true => format!(", or that of {along},"),
        false => String::new(),
    };
    let others = fits.iter().filter(|fit| fit.by_sign < MUCH);
    let note = |fit: &Fit<'_>| {
        format!(
            "{} of B changes the opposite way to that of A: is its sign{or_way} the other one?",
            fit.quantity.title
        )
    };
    others.map(note).collect()
}

/// Whether the other way of counting fits quantities of two kinds, and none much worse: one kind alone may have another sign.
fn is_other_way(fits: &[Fit<'_>]) -> bool {
    let better = fits.iter().filter(|fit| fit.by_way < MUCH);
    let kinds: BTreeSet<&str> = better.map(|fit| fit.quantity.kind).collect();
    kinds.len() > 1 && fits.iter().all(|fit| fit.by_way < 1.0 / MUCH)
}

impl<'a> Fit<'a> {
    /// Returns the fit of a quantity; `None` if it changes too little, or at too few places, to tell.
    fn new(quantity: &'a MeasuredQuantity) -> Option<Self> {
        const FEWEST: usize = 5;
        let [model, measured] = quantity.offset()?.values;
        let places = quantity.places.iter();
        let changes = places.map(|place| {
            let [a, b] = place.values;
            (place.at, [a - model, b - measured])
        });
        let changes: Vec<(f64, [f64; 2])> = changes.collect();
        let tells = |of: usize| {
            let mut changes = changes.iter();
            changes.any(|(_, change)| change[of].abs() >= quantity.least_change)
        };
        if changes.len() < FEWEST || !tells(0) || !tells(1) {
            return None;
        }
        let opposite = changes.iter().map(|(_, [a, b])| [*a, *b, -a]);
        let zero = quantity.on_curve(0.0).unwrap_or(f64::NAN);
        let turned = changes.iter().filter_map(|(at, [a, b])| {
            let there = quantity.on_curve(-at)? - zero;
            there.is_finite().then_some([*a, *b, there])
        });
        let turned: Vec<[f64; 3]> = turned.collect();
        let is_enough = 2 * turned.len() > changes.len() && turned.len() >= FEWEST;
        Some(Self {
            quantity,
            by_sign: part(opposite),
            by_way: match is_enough {
                true => part(turned.into_iter()),
                false => f64::INFINITY,
            },
        })
    }
}

/// Returns the squares of the differences of measured changes from other ones of the model, as a part of those from its own;
/// each item has the model's own change, the measured one, and the model's other one.
fn part(changes: impl Iterator<Item = [f64; 3]>) -> f64 {
    let sums = changes.fold([0.0, 0.0], |[own, other], [a, b, of_other]| {
        [own + (b - a).powi(2), other + (b - of_other).powi(2)]
    });
    let [own, other] = sums;
    other / own
}
