//! Quantities that both suspensions have, side by side.

use crate::characteristics::{Curves, Line, Title};
use crate::commands::compare::suspension::Suspension;
use crate::mechanism::{ends, listed};

/// A number of both suspensions.
#[derive(Clone)]
pub(super) struct Difference {
    pub(super) title: Title,
    pub(super) symbol: String,
    /// The drive's change where two curves differ most; `None` if they are equal, or equally far apart everywhere. The values are
    /// then those nearest to the design position.
    pub(super) at: Option<f64>,
    pub(super) values: [f64; 2],
    /// For curves: the root of the mean square of the difference over all places.
    pub(super) rms: Option<f64>,
}

/// A place where both have values.
#[derive(Clone, Copy)]
pub(super) struct Place {
    /// What people find it by: the change of the drive, for one.
    pub(super) at: f64,
    /// How far it is from the design position.
    pub(super) from_design: f64,
    pub(super) values: [f64; 2],
}

impl Place {
    pub(super) fn difference(&self) -> f64 {
        let [a, b] = self.values;
        b - a
    }
}

impl Difference {
    /// Returns the difference of a quantity, named with its unit, where it is largest; `None` without places.
    pub(super) fn largest((title, symbol): (Title, String), places: &[Place]) -> Option<Self> {
        let offs = || places.iter().map(Place::difference);
        let [least, greatest] = ends(offs())?;
        let by = |size: &dyn Fn(&Place) -> f64| {
            let places = places.iter().copied();
            places.max_by(|a, b| size(a).total_cmp(&size(b)))
        };
        let Place { at, values, .. } = by(&|place| place.difference().abs())?;
        let squares: f64 = offs().map(|off| off * off).sum();
        let mut difference = Self {
            title,
            symbol,
            at: Some(at),
            values,
            rms: Some((squares / places.len() as f64).sqrt()),
        };
        // Where the largest difference is rounding, all are.
        if difference.value() == 0.0 {
            difference.rms = Some(0.0);
        }
        if difference.is_rounding_of(greatest - least) {
            difference.at = None;
            difference.values = by(&|place| -place.from_design.abs())?.values;
        }
        Some(difference)
    }

    /// Returns the second number minus the first; zero if they differ by rounding only.
    pub(super) fn value(&self) -> f64 {
        let [a, b] = self.values;
        if self.is_rounding_of(b - a) {
            0.0
        } else {
            b - a
        }
    }

    /// Returns whether a difference of `off` between these numbers is rounding.
    fn is_rounding_of(&self, off: f64) -> bool {
        is_rounding(off, self.values)
    }

    /// Returns whether another wheel has the same numbers of this quantity.
    fn is_same_of_another_wheel(&self, other: &Self) -> bool {
        let is_near = |[a, b]: [f64; 2]| is_rounding(b - a, [a, b]);
        let is_same_rms = match (self.rms, other.rms) {
            (Some(a), Some(b)) => is_near([a, b]),
            (a, b) => a == b,
        };
        let numbers = self.values.into_iter().zip(other.values);
        self.title.wheel.is_some()
            && other.title.wheel.is_some()
            && self.title.of_wheel == other.title.of_wheel
            && self.symbol == other.symbol
            && self.at == other.at
            && is_same_rms
            && numbers.into_iter().all(|(a, b)| is_near([a, b]))
    }
}

/// Returns whether a difference of `off` between numbers is rounding.
fn is_rounding(off: f64, [a, b]: [f64; 2]) -> bool {
    /// The limit, relative for numbers above one. The largest that rounding made is 7e-14.
    const ROUNDING: f64 = 1e-11;
    off.abs() <= ROUNDING * a.abs().max(b.abs()).max(1.0)
}

/// The text at the place of a difference that is equal all along the curves.
pub(super) const EVERYWHERE: &str = "everywhere";

/// A table of differences, of values, derivatives or curves.
pub(super) struct Part {
    /// The name in a table of comma-separated values, for example `per travel`.
    pub(super) of: String,
    /// The heading for people.
    pub(super) heading: String,
    /// For curves: the quantity and unit of `at`.
    pub(super) across: Option<String>,
    pub(super) differences: Vec<Difference>,
}

impl Part {
    /// Returns whether it has the rms of differences.
    pub(super) fn has_rms(&self) -> bool {
        let mut each = self.differences.iter();
        each.any(|difference| difference.rms.is_some())
    }

    /// Returns the differences for people: one for all wheels of which it is the same, with the names of these wheels.
    pub(super) fn rows(&self) -> Vec<Difference> {
        let mut groups: Vec<Vec<&Difference>> = Vec::new();
        for difference in &self.differences {
            let mut known = groups.iter_mut();
            match known.find(|group| group[0].is_same_of_another_wheel(difference)) {
                Some(group) => group.push(difference),
                None => groups.push(vec![difference]),
            }
        }
        let row = |group: Vec<&Difference>| {
            let mut row = group[0].clone();
            let wheels = group.iter().map(|same| same.title.wheel.clone());
            row.title.wheel = wheels.collect::<Option<Vec<_>>>().map(listed);
            row
        };
        groups.into_iter().map(row).collect()
    }
}

/// Pairs what both sides have, wheel by wheel. A wheel without a name is paired with every wheel of the other side.
pub(super) fn pair_by_title<T>([a, b]: [&[T]; 2], title: fn(&T) -> &Title) -> Vec<[&T; 2]> {
    let pairs = a.iter().flat_map(|a| b.iter().map(move |b| [a, b]));
    pairs.filter(|pair| is_same(pair.map(title))).collect()
}

/// Returns whether two titles are equal and of the same wheel, or one of them of a wheel without a name.
pub(super) fn is_same([a, b]: [&Title; 2]) -> bool {
    let is_of_all = a.wheel.is_none() || b.wheel.is_none();
    a.of_wheel == b.of_wheel && (is_of_all || a.wheel == b.wheel)
}

/// Returns the common title, with the wheel's name if one has it.
pub(super) fn title_of_both([a, b]: [&Title; 2]) -> &Title {
    if a.wheel.is_none() { b } else { a }
}

/// Two wheels are compared by their own travel if equal changes of their drives move them differently by more than this
/// part.
pub(super) const ALIKE: f64 = 0.1;

/// Pairs curves by their titles, or else by the purpose of their drives.
pub(super) fn same_ways<'a>([a, b]: [&'a Suspension; 2]) -> Vec<[&'a Curves; 2]> {
    let pair = |curves: &'a Curves| Some([curves, counterpart(curves, a, b)?]);
    a.curves.iter().filter_map(pair).collect()
}

/// Returns the curves of a side that have no counterpart in the other.
pub(super) fn unmatched<'a>(side: &'a Suspension, other: &Suspension) -> Vec<&'a Curves> {
    let is_alone = |curves: &&Curves| counterpart(curves, side, other).is_none();
    side.curves.iter().filter(is_alone).collect()
}

fn counterpart<'b>(curves: &Curves, own: &Suspension, other: &'b Suspension) -> Option<&'b Curves> {
    let effect = curves.movement.effect;
    let theirs = || {
        other
            .curves
            .iter()
            .filter(move |theirs| theirs.movement.effect == effect)
    };
    let called = |title: &str| theirs().find(|theirs| theirs.title == title);
    let mut ours = own
        .curves
        .iter()
        .filter(|ours| ours.movement.effect == effect);
    if ours.any(|ours| called(&ours.title).is_some()) {
        called(&curves.title)
    } else {
        theirs().find(|theirs| theirs.movement == curves.movement)
    }
}

/// Pairs the lines of the same name and unit, of which neither is cut near infinity.
pub(super) fn pairs<'a>(a: &'a Curves, b: &'a Curves) -> Vec<[&'a Line; 2]> {
    let mut pairs = pair_by_title([&a.lines, &b.lines], |line| &line.title);
    pairs.retain(|[a, b]| a.symbol == b.symbol && !a.is_cut && !b.is_cut);
    pairs
}
