//! Curves of both suspensions side by side.

use std::borrow::Cow;

use crate::characteristics::{Curves, Does, Line};
use crate::commands::compare::by_wheel::{are_unlike, by_wheel};
use crate::commands::compare::differences::{Difference, Part, pairs, title_of_both};
use crate::mechanism::Unit;

/// Curves of both along what does the same.
pub(super) struct Over<'a> {
    /// As `over travel`.
    of: String,
    pub(super) curves: [Cow<'a, Curves>; 2],
}

impl<'a> Over<'a> {
    /// Over equal changes of the drives or, where these are not alike, over the travel of the wheel.
    pub(super) fn of(both: [&'a Curves; 2], unit: Unit) -> Option<Self> {
        let [a, b] = both;
        if are_unlike(both)
            && let Some(curves) = by_wheel(both, unit)
        {
            let of = match a.way.does {
                Does::Roll => format!("over {} by wheel travel", a.way),
                Does::Travel | Does::Steer => format!("over wheel {}", a.way),
            };
            let curves = curves.map(Cow::Owned);
            return Some(Self { of, curves });
        }
        (a.dimension == b.dimension).then(|| Self {
            of: format!("over {}", a.way),
            curves: both.map(Cow::Borrowed),
        })
    }

    /// Where the curves differ most.
    pub(super) fn part(&self, unit: Unit) -> Part {
        let [a, b] = self.curves.each_ref().map(|curves| &**curves);
        let differences = pairs(a, b).into_iter();
        let differences = differences.filter_map(|pair| largest(a, pair));
        Part {
            of: self.of.clone(),
            moved: None,
            across: Some(a.across(unit)),
            differences: differences.collect(),
        }
    }
}

/// A change, and the values of both there.
type Place = (f64, [f64; 2]);

/// Where two lines differ most, of the places where both are.
fn largest(curves: &Curves, [a, b]: [&Line; 2]) -> Option<Difference> {
    let places = curves.changes.iter().zip(a.values.iter().zip(&b.values));
    let both = places.filter_map(|(at, (a, b))| Some((*at, [(*a)?, (*b)?])));
    let apart = |[a, b]: [f64; 2]| (b - a).abs();
    let differences = both.clone().map(|(_, [a, b])| b - a);
    let [least, greatest] = [f64::min, f64::max].map(|end| differences.clone().reduce(end));
    let by = |size: &dyn Fn(&Place) -> f64| both.clone().max_by(|a, b| size(a).total_cmp(&size(b)));
    let (at, values) = by(&|(_, values)| apart(*values))?;
    let mut difference = Difference {
        quantity: title_of_both([&a.title, &b.title]),
        symbol: a.symbol.clone(),
        at: Some(at),
        values,
    };
    if difference.is_rounding_of(greatest? - least?) {
        difference.at = None;
        (_, difference.values) = by(&|(at, _)| -at.abs())?;
    }
    Some(difference)
}
