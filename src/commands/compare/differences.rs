//! What both suspensions have, beside each other.

use crate::characteristics::{Curves, Line, Parameter};
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
        let design = |parameter: &Parameter| Some((parameter.value, parameter.symbol.clone()));
        let per = |way: usize| {
            move |parameter: &Parameter| {
                let derivative = parameter.per[way].as_ref()?;
                Some((derivative.value, derivative.symbol.clone()))
            }
        };
        let mut parts = vec![Part {
            of: "design".to_owned(),
            across: None,
            differences: of_parameters(sides, [&design; 2]),
        }];
        let [a, b] = sides;
        for (of_a, way) in a.ways.iter().enumerate() {
            if let Some(of_b) = b.ways.iter().position(|other| other == way) {
                parts.push(Part {
                    of: format!("per {way}"),
                    across: None,
                    differences: of_parameters(sides, [&per(of_a), &per(of_b)]),
                });
            }
        }
        for [a, b] in same_ways(sides) {
            if a.kind != b.kind {
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

/// Whether two quantities, each with its wheel, are the same. What is of a wheel without a name is compared with that of
/// every wheel.
fn is_same((a, of_a): (&str, Option<&str>), (b, of_b): (&str, Option<&str>)) -> bool {
    a == b && (of_a == of_b || of_a.is_none() || of_b.is_none())
}

fn of_parameter(parameter: &Parameter) -> (&str, Option<&str>) {
    (&parameter.of_wheel, parameter.wheel.as_deref())
}

fn of_line(line: &Line) -> (&str, Option<&str>) {
    (&line.of_wheel, line.wheel.as_deref())
}

/// Reads a number of a parameter, with its unit.
type Read<'a> = dyn Fn(&Parameter) -> Option<(f64, String)> + 'a;

/// The numbers that parameters of the same name and unit have.
fn of_parameters([a, b]: [&Side; 2], [of_a, of_b]: [&Read<'_>; 2]) -> Vec<Difference> {
    let of_one = |parameter: &Parameter| {
        let other = b
            .parameters
            .iter()
            .find(|other| is_same(of_parameter(parameter), of_parameter(other)))?;
        let ((a, symbol), (b, of_other)) = (of_a(parameter)?, of_b(other)?);
        (symbol == of_other && a.is_finite() && b.is_finite()).then(|| Difference {
            quantity: parameter.name.clone(),
            symbol,
            at: None,
            values: [a, b],
        })
    };
    a.parameters.iter().filter_map(of_one).collect()
}

/// The curves of both along drives that do the same.
pub(super) fn same_ways<'a>([a, b]: [&'a Side; 2]) -> Vec<[&'a Curves; 2]> {
    let pair = |curves: &'a Curves| {
        let of = |other: &&Curves| other.way == curves.way;
        Some([curves, b.curves.iter().find(of)?])
    };
    a.curves.iter().filter_map(pair).collect()
}

/// The curves of a side along drives that do what none of the other does.
pub(super) fn unmatched<'a>(side: &'a Side, other: &Side) -> Vec<&'a Curves> {
    let is_alone = |curves: &&Curves| other.curves.iter().all(|theirs| theirs.way != curves.way);
    side.curves.iter().filter(is_alone).collect()
}

/// The lines of the same name and unit.
pub(super) fn pairs<'a>(a: &'a Curves, b: &'a Curves) -> Vec<[&'a Line; 2]> {
    let pair = |line: &'a Line| {
        let same =
            |other: &&Line| is_same(of_line(line), of_line(other)) && other.symbol == line.symbol;
        Some([line, b.lines.iter().find(same)?])
    };
    a.lines.iter().filter_map(pair).collect()
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
        quantity: a.title.clone(),
        symbol: a.symbol.clone(),
        at: Some(at),
        values,
    })
}
