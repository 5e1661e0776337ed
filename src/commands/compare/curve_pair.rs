//! Curves of both suspensions side by side.

use std::borrow::Cow;

use crate::characteristics::{Curves, Effect, Line};
use crate::commands::compare::differences::{Difference, Part, Place, pairs, title_of_both};
use crate::commands::compare::over_wheel_travel::{are_unlike, by_wheel};
use crate::mechanism::Unit;

/// The curves of both suspensions over the same kind of motion.
pub(super) struct CurvePair<'a> {
    /// The name in a table of comma-separated values, for example `over travel`.
    of: String,
    /// What the curves are over, for people.
    over: String,
    pub(super) curves: [Cow<'a, Curves>; 2],
}

impl<'a> CurvePair<'a> {
    /// Pairs the curves over equal changes of the drives, or over the travel of the wheel if equal changes move the wheels
    /// unequally far.
    pub(super) fn new(both: [&'a Curves; 2], unit: Unit) -> Option<Self> {
        let [a, b] = both;
        if are_unlike(both)
            && let Some(curves) = by_wheel(both, unit)
        {
            let (of, over) = match a.movement.effect {
                Effect::Roll => (
                    format!("over {} by wheel travel", a.movement),
                    format!("{} by wheel travel", a.title),
                ),
                Effect::Travel | Effect::Steer => (
                    format!("over wheel {}", a.movement),
                    curves[0].title.clone(),
                ),
            };
            let curves = curves.map(Cow::Owned);
            return Some(Self { of, over, curves });
        }
        (a.dimension == b.dimension).then(|| Self {
            of: format!("over {}", a.movement),
            over: a.title.clone(),
            curves: both.map(Cow::Borrowed),
        })
    }

    /// Returns the differences, each at the place where the curves differ most.
    pub(super) fn part(&self, unit: Unit) -> Part {
        let [a, b] = self.curves.each_ref().map(|curves| &**curves);
        let differences = pairs(a, b).into_iter();
        let differences = differences.filter_map(|pair| largest(a, pair));
        let across = a.axis_label(unit);
        Part {
            of: self.of.clone(),
            heading: format!("Largest difference over {}, at a {across}", self.over),
            across: Some(across),
            differences: differences.collect(),
        }
    }
}

/// Returns the largest difference of two lines, over the places where both have values.
fn largest(curves: &Curves, [a, b]: [&Line; 2]) -> Option<Difference> {
    let places = curves.changes.iter().zip(a.values.iter().zip(&b.values));
    let place = |(at, (a, b)): (&f64, (&Option<f64>, &Option<f64>))| {
        Some(Place {
            at: *at,
            from_design: *at,
            values: [(*a)?, (*b)?],
        })
    };
    let places = places.filter_map(place);
    let title = title_of_both([&a.title, &b.title]).clone();
    Difference::largest((title, a.symbol.clone()), &places.collect::<Vec<_>>())
}
