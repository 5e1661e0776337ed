//! Quantities that both suspensions have, side by side.

use crate::characteristics::{Curves, Line, Title};
use crate::commands::compare::side::Side;

/// A number of both.
pub(super) struct Difference {
    pub(super) quantity: String,
    pub(super) symbol: String,
    /// Of a curve: the drive's change; `None` where the curves are the same, or as far apart everywhere. The values are then those
    /// nearest to the design position.
    pub(super) at: Option<f64>,
    pub(super) values: [f64; 2],
}

impl Difference {
    /// What the second has more.
    pub(super) fn value(&self) -> f64 {
        let [a, b] = self.values;
        b - a
    }

    /// Whether such numbers differ so by rounding alone.
    pub(super) fn is_rounding_of(&self, off: f64) -> bool {
        /// Relative where above one. Rounding made 7e-14 at most.
        const ROUNDING: f64 = 1e-11;
        let [a, b] = self.values;
        off.abs() <= ROUNDING * a.abs().max(b.abs()).max(1.0)
    }
}

/// What stands at the place of a difference that is the same all along the curves.
pub(super) const EVERYWHERE: &str = "everywhere";

/// Numbers of one sort.
pub(super) struct Part {
    /// As `per travel`.
    pub(super) of: String,
    /// Of derivatives: the drives or the wheels that they move, in words.
    pub(super) moved: Option<String>,
    /// Of curves: what `at` is, with its unit.
    pub(super) across: Option<String>,
    pub(super) differences: Vec<Difference>,
}

/// What both sides have, each with its wheel: of a wheel without a name, that of every wheel of the other side.
pub(super) fn both<T>([a, b]: [&[T]; 2], title: fn(&T) -> &Title) -> Vec<[&T; 2]> {
    let pairs = a.iter().flat_map(|a| b.iter().map(move |b| [a, b]));
    pairs.filter(|pair| is_same(pair.map(title))).collect()
}

/// Whether two are called alike, of the same wheel or one of them of a wheel without a name.
pub(super) fn is_same([a, b]: [&Title; 2]) -> bool {
    let is_of_all = a.wheel.is_none() || b.wheel.is_none();
    a.of_wheel == b.of_wheel && (is_of_all || a.wheel == b.wheel)
}

/// What is the same of both; with the wheel's name, where one has it.
pub(super) fn title_of_both([a, b]: [&Title; 2]) -> String {
    if a.wheel.is_none() { b } else { a }.to_string()
}

/// Wheels that rise further than others by this part, for equal changes of their drives, are compared by their own travel.
pub(super) const ALIKE: f64 = 0.1;

/// The curves of both along what is called alike, or, where nothing that does the same is, along drives that do the same.
pub(super) fn same_ways<'a>([a, b]: [&'a Side; 2]) -> Vec<[&'a Curves; 2]> {
    let pair = |curves: &'a Curves| Some([curves, counterpart(curves, a, b)?]);
    a.curves.iter().filter_map(pair).collect()
}

/// The curves of a side that have no counterpart in the other.
pub(super) fn unmatched<'a>(side: &'a Side, other: &Side) -> Vec<&'a Curves> {
    let is_alone = |curves: &&Curves| counterpart(curves, side, other).is_none();
    side.curves.iter().filter(is_alone).collect()
}

fn counterpart<'b>(curves: &Curves, own: &Side, other: &'b Side) -> Option<&'b Curves> {
    let does = curves.way.does;
    let theirs = || {
        other
            .curves
            .iter()
            .filter(move |theirs| theirs.way.does == does)
    };
    let called = |title: &str| theirs().find(|theirs| theirs.title == title);
    let mut ours = own.curves.iter().filter(|ours| ours.way.does == does);
    if ours.any(|ours| called(&ours.title).is_some()) {
        called(&curves.title)
    } else {
        theirs().find(|theirs| theirs.way == curves.way)
    }
}

/// The lines of the same name and unit, of which none is cut near infinity.
pub(super) fn pairs<'a>(a: &'a Curves, b: &'a Curves) -> Vec<[&'a Line; 2]> {
    let mut pairs = both([&a.lines, &b.lines], |line| &line.title);
    pairs.retain(|[a, b]| a.symbol == b.symbol && !a.is_cut && !b.is_cut);
    pairs
}
