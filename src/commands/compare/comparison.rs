//! The comparison: the design positions, derivatives there, and curves.

use crate::characteristics::{Curves, Line, Parameter};
use crate::commands::compare::curve_pair::CurvePair;
use crate::commands::compare::differences::{
    ALIKE, Difference, Part, pair_by_title, pairs, same_ways, title_of_both,
};
use crate::commands::compare::notes::{legend, notes};
use crate::commands::compare::report::Report;
use crate::commands::compare::short_name::short_names;
use crate::commands::compare::suspension::Suspension;
use crate::output::plot::{Chart, Curve};

/// Compares the quantities and curves that both suspensions have.
pub(super) fn compare(sides: [&Suspension; 2]) -> Report {
    let design = |parameter: &Parameter, _: bool| Some((parameter.value, parameter.symbol.clone()));
    let mut parts = vec![Part {
        of: "design".to_owned(),
        heading: AT_DESIGN.to_owned(),
        across: None,
        differences: of_parameters(sides, [&design; 2]),
    }];
    parts.extend(
        (0..sides[0].movements.len()).filter_map(|movement| of_derivatives(sides, movement)),
    );
    let unit = sides[0].unit;
    let over = same_ways(sides).into_iter();
    let over: Vec<CurvePair<'_>> = over.filter_map(|both| CurvePair::new(both, unit)).collect();
    parts.extend(over.iter().map(|over| over.part(unit)));
    parts.retain(|part| !part.differences.is_empty());
    let charts = over.iter().map(|CurvePair { curves: [a, b], .. }| {
        let heading = format!("Over {}", a.title);
        (heading, drawn(sides, a, b))
    });
    let missing = sides.iter().flat_map(|side| side.missing.clone());
    Report {
        title: "Two suspensions compared",
        files: sides.map(|side| side.file.clone()),
        legend: legend(sides),
        notes: notes(sides),
        missing: missing.collect(),
        parts,
        charts: charts.collect(),
    }
}

fn drawn(sides: [&Suspension; 2], a: &Curves, b: &Curves) -> Vec<Chart> {
    let [name_a, name_b] = short_names(sides.map(|side| side.file.as_str()));
    let curve = |name: &str, curves: &Curves, line: &Line| Curve {
        name: name.to_owned(),
        line: curves.points(line),
        ..Curve::default()
    };
    let chart = |[of_a, of_b]: [&Line; 2]| Chart {
        title: title_of_both([&of_a.title, &of_b.title]).to_string(),
        across: a.axis_label(sides[0].unit),
        quantity: of_a.symbol.clone(),
        curves: vec![curve(&name_a, a, of_a), curve(&name_b, b, of_b)],
    };
    pairs(a, b).into_iter().map(chart).collect()
}

/// Compares the derivatives with respect to a drive of the first and the drive of the second with the same purpose.
fn of_derivatives(sides: [&Suspension; 2], of_a: usize) -> Option<Part> {
    let movements = [of_a, sides[0].same_movement(sides[1], of_a)?];
    let by_wheel = are_unlike_travels(sides, movements);
    let [a, b] = [0, 1].map(|number| {
        let (side, movement) = (sides[number], movements[number]);
        move |parameter: &Parameter, is_alone| {
            derivative(side, (movement, by_wheel), parameter, is_alone)
        }
    });
    let movement = sides[0].movements[of_a];
    let of = if by_wheel {
        format!("per wheel {movement}")
    } else {
        format!("per {movement}")
    };
    Some(Part {
        of,
        heading: format!("{AT_DESIGN}, per {}", moved(sides, movements, by_wheel)),
        across: None,
        differences: of_parameters(sides, [&a, &b]),
    })
}

/// The heading of values, and the beginning of those of derivatives.
const AT_DESIGN: &str = "At the design position";

/// Names the movements with respect to which there are derivatives.
fn moved([a, b]: [&Suspension; 2], [of_a, of_b]: [usize; 2], by_wheel: bool) -> String {
    let [of_a, of_b] = [a.moved(of_a, b, by_wheel), b.moved(of_b, a, by_wheel)];
    if of_a == of_b {
        of_a
    } else {
        format!("{of_a} in A, {of_b} in B")
    }
}

/// Returns whether equal changes of two drives of travel move the same wheels unequally far.
fn are_unlike_travels([a, b]: [&Suspension; 2], [of_a, of_b]: [usize; 2]) -> bool {
    let (Some(in_a), Some(in_b)) = (&a.rises, &b.rises) else {
        return false;
    };
    if of_a >= in_a.count() || of_b >= in_b.count() {
        return false;
    }
    let own = in_a.rise(of_a, of_a).abs();
    let is_unlike = |[of_wheel, of_other]: [Option<usize>; 2]| {
        let rise = of_wheel.map_or(0.0, |wheel| in_a.rise(wheel, of_a));
        let other = of_other.map_or(0.0, |wheel| in_b.rise(wheel, of_b));
        (other - rise).abs() > ALIKE * own
    };
    in_a.symbol(of_a) != in_b.symbol(of_b) || a.pair_wheels(b).into_iter().any(is_unlike)
}

/// Returns the derivative of a parameter with respect to a drive, or to the height of its wheel with the other wheels held.
/// A wheel or axle that is compared with one without a name takes its own drive of travel.
fn derivative(
    side: &Suspension,
    (movement, by_wheel): (usize, bool),
    parameter: &Parameter,
    is_alone: bool,
) -> Option<(f64, String)> {
    let movement = match &parameter.title.wheel {
        Some(wheel) if is_alone => side.own_movement(movement, wheel),
        _ => movement,
    };
    let derivative = if by_wheel {
        parameter.per_wheel(movement, side.rises.as_ref()?, side.unit)
    } else {
        parameter.per[movement].clone()
    };
    derivative.map(|derivative| (derivative.value, derivative.symbol))
}

/// Reads a number of a parameter, with its unit. The flag says that only one of the two suspensions names its wheel.
type Read<'a> = dyn Fn(&Parameter, bool) -> Option<(f64, String)> + 'a;

/// Pairs the numbers of parameters of the same name and unit.
fn of_parameters([a, b]: [&Suspension; 2], [of_a, of_b]: [&Read<'_>; 2]) -> Vec<Difference> {
    let difference = |[a, b]: [&Parameter; 2]| {
        let is_alone = a.title.wheel != b.title.wheel;
        let ((value, symbol), (other, of_other)) = (of_a(a, is_alone)?, of_b(b, is_alone)?);
        (symbol == of_other && value.is_finite() && other.is_finite()).then(|| Difference {
            title: title_of_both([&a.title, &b.title]).clone(),
            symbol,
            at: None,
            values: [value, other],
            rms: None,
        })
    };
    let pairs = pair_by_title([&a.parameters, &b.parameters], |parameter| &parameter.title);
    pairs.into_iter().filter_map(difference).collect()
}
