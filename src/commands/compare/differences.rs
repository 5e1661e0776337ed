//! What both suspensions have, beside each other.

use crate::characteristics::{Curves, Line, Parameter, Title};
use crate::commands::compare::side::Side;

/// A number of both.
pub(super) struct Difference {
    pub(super) quantity: String,
    pub(super) symbol: String,
    /// Of a curve: the drive's change.
    pub(super) at: Option<f64>,
    pub(super) values: [f64; 2],
}

impl Difference {
    /// What the second has more.
    pub(super) fn value(&self) -> f64 {
        let [a, b] = self.values;
        b - a
    }
}

/// Numbers of one sort.
pub(super) struct Part {
    /// As `per travel`.
    pub(super) of: String,
    /// Of curves: what `at` is, with its unit.
    pub(super) across: Option<String>,
    pub(super) differences: Vec<Difference>,
}

/// All that both have.
pub(super) struct Comparison {
    pub(super) parts: Vec<Part>,
}

impl Comparison {
    /// Of both sides.
    pub(super) fn of(sides: [&Side; 2]) -> Self {
        let design =
            |parameter: &Parameter, _: bool| Some((parameter.value, parameter.symbol.clone()));
        let mut parts = vec![Part {
            of: "design".to_owned(),
            across: None,
            differences: of_parameters(sides, [&design; 2]),
        }];
        for (of_a, way) in sides[0].ways.iter().enumerate() {
            if let Some(of_b) = sides[0].same_way(sides[1], of_a) {
                let ways = [(sides[0], of_a), (sides[1], of_b)];
                let by_wheel = are_unlike_travels(ways);
                let [a, b] = ways.map(|(side, way)| {
                    move |parameter: &Parameter, is_alone| {
                        let derivative = derivative(side, way, parameter, is_alone);
                        if by_wheel {
                            derivative?.per_rise(side)
                        } else {
                            derivative.map(|per| (per.value, per.symbol.clone()))
                        }
                    }
                });
                parts.push(Part {
                    of: if by_wheel {
                        format!("per wheel {way}")
                    } else {
                        format!("per {way}")
                    },
                    across: None,
                    differences: of_parameters(sides, [&a, &b]),
                });
            }
        }
        for [a, b] in same_ways(sides) {
            if a.dimension != b.dimension {
                continue;
            }
            let lines = pairs(a, b).into_iter();
            let differences = lines.filter_map(|pair| largest(a, pair)).collect();
            parts.push(Part {
                of: format!("over {}", a.way),
                across: Some(a.across(sides[0].unit)),
                differences,
            });
        }
        parts.retain(|part| !part.differences.is_empty());
        Self { parts }
    }
}

/// What both sides have, each with its wheel: of a wheel without a name, that of every wheel of the other side.
fn both<T>([a, b]: [&[T]; 2], title: fn(&T) -> &Title) -> Vec<[&T; 2]> {
    let is_same = |[a, b]: [&Title; 2]| {
        let is_of_all = a.wheel.is_none() || b.wheel.is_none();
        a.of_wheel == b.of_wheel && (is_of_all || a.wheel == b.wheel)
    };
    let pairs = a.iter().flat_map(|a| b.iter().map(move |b| [a, b]));
    pairs.filter(|pair| is_same(pair.map(title))).collect()
}

/// What is the same of both; with the wheel's name, where one has it.
pub(super) fn title_of_both([a, b]: [&Title; 2]) -> String {
    if a.wheel.is_none() { b } else { a }.to_string()
}

/// Wheels that rise further than others by this part, for equal changes of their drives, are compared by their own travel.
pub(super) const ALIKE: f64 = 0.1;

/// Whether equal changes of two drives of travel are not equal travels of the wheels.
fn are_unlike_travels(ways: [(&Side, usize); 2]) -> bool {
    let [a, b] = ways.map(|(side, way)| side.rise(way));
    let (Some((a, of_a)), Some((b, of_b))) = (a, b) else {
        return false;
    };
    of_a != of_b || (b - a).abs() > ALIKE * a.abs()
}

/// A derivative of a parameter along a drive.
struct PerDrive<'a> {
    parameter: &'a Parameter,
    way: usize,
    value: f64,
    symbol: &'a String,
}

impl PerDrive<'_> {
    /// The same with respect to the height of the wheel that the drive moves.
    fn per_rise(&self, side: &Side) -> Option<(f64, String)> {
        let (rise, _) = side.rise(self.way)?;
        let symbol = format!("{}/{}", self.parameter.symbol, side.unit.symbol());
        Some((self.value / rise, symbol))
    }
}

/// The derivative of a parameter along a drive; of a wheel or an axle that is compared with one without a name, along its own drive of
/// travel.
fn derivative<'a>(
    side: &Side,
    way: usize,
    parameter: &'a Parameter,
    is_alone: bool,
) -> Option<PerDrive<'a>> {
    let way = match &parameter.title.wheel {
        Some(wheel) if is_alone => side.own_way(way, wheel),
        _ => way,
    };
    let derivative = parameter.per[way].as_ref()?;
    Some(PerDrive {
        parameter,
        way,
        value: derivative.value,
        symbol: &derivative.symbol,
    })
}

/// Reads a number of a parameter, with its unit; with whether only one of the two that are compared names its wheel.
type Read<'a> = dyn Fn(&Parameter, bool) -> Option<(f64, String)> + 'a;

/// The numbers that parameters of the same name and unit have.
fn of_parameters([a, b]: [&Side; 2], [of_a, of_b]: [&Read<'_>; 2]) -> Vec<Difference> {
    let difference = |[a, b]: [&Parameter; 2]| {
        let is_alone = a.title.wheel != b.title.wheel;
        let ((value, symbol), (other, of_other)) = (of_a(a, is_alone)?, of_b(b, is_alone)?);
        (symbol == of_other && value.is_finite() && other.is_finite()).then(|| Difference {
            quantity: title_of_both([&a.title, &b.title]),
            symbol,
            at: None,
            values: [value, other],
        })
    };
    let both = both([&a.parameters, &b.parameters], |parameter| &parameter.title);
    both.into_iter().filter_map(difference).collect()
}

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

/// The lines of the same name and unit.
pub(super) fn pairs<'a>(a: &'a Curves, b: &'a Curves) -> Vec<[&'a Line; 2]> {
    let mut pairs = both([&a.lines, &b.lines], |line| &line.title);
    pairs.retain(|[a, b]| a.symbol == b.symbol);
    pairs
}

/// Where two lines differ most, of the places where both are.
fn largest(curves: &Curves, [a, b]: [&Line; 2]) -> Option<Difference> {
    let places = curves.changes.iter().zip(a.values.iter().zip(&b.values));
    let both = places.filter_map(|(at, (a, b))| Some((*at, [(*a)?, (*b)?])));
    let apart = |[a, b]: [f64; 2]| (b - a).abs();
    let (at, values) = both.reduce(|most, next| {
        if apart(next.1) > apart(most.1) {
            next
        } else {
            most
        }
    })?;
    Some(Difference {
        quantity: title_of_both([&a.title, &b.title]),
        symbol: a.symbol.clone(),
        at: Some(at),
        values,
    })
}
