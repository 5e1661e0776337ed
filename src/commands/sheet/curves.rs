//! The curves on the page.

use maud::{Markup, html};

use crate::characteristics::{Curves, Effect, Line, Parameter, Title};
use crate::commands::sheet::by_quantity::grouped;
use crate::commands::sheet::far_apart::{are_far_apart, changes_from};
use crate::mechanism::{Description, Wheel};
use crate::output::colour::Colour;
use crate::output::page::charts;
use crate::output::plot::{Chart, Curve};
use crate::quantities::{CAMBER, TOE};

/// The charts along what moves, under their heading. The parameters have the values at the design position.
pub(super) fn section(curves: &Curves, parameters: &[Parameter], of: &Description) -> Markup {
    let groups = grouped(&curves.lines, |line| &line.title.of_wheel);
    let varies = |lines: &Vec<&Line>| lines.iter().any(|line| line.varies());
    let (drawn, flat): (Vec<_>, Vec<_>) = groups.into_iter().partition(varies);
    let (zero, constant): (Vec<_>, Vec<_>) = flat.into_iter().partition(|lines| are_zero(lines));
    let chart = |lines: Vec<&Line>| chart(curves, parameters, (lines, of));
    let drawn: Vec<Chart> = drawn.into_iter().map(chart).collect();
    html! {
        h2 { "Over " (curves.title) }
        @for note in near_infinity(curves) { p { (note) } }
        @if let Some(note) = curves.without_small_steer() { p { (note) "." } }
        @for (how, flat) in [("Zero", zero), ("Constant", constant)] {
            @if !flat.is_empty() { p { (how) " throughout, without a chart: " (names(&flat)) "." } }
        }
        (charts(&drawn))
    }
}

/// The chart of a quantity, with the curves of all wheels.
fn chart(
    curves: &Curves,
    parameters: &[Parameter],
    (lines, of): (Vec<&Line>, &Description),
) -> Chart {
    let title = title_over(curves.movement.effect, &lines[0].title.of_wheel);
    let points: Vec<_> = lines.iter().map(|line| curves.points(line)).collect();
    let designs = are_far_apart(&points).then(|| designs(&lines, parameters));
    let (title, points) = match designs.flatten() {
        Some(designs) => (
            format!("{title}, change from design"),
            changes_from(points, &designs),
        ),
        None => (title, points),
    };
    let curve = |(line, points): (&&Line, _)| Curve {
        name: line.title.wheel.clone().unwrap_or_default(),
        line: points,
        colour: colour(line.title.wheel.as_deref(), &of.names.wheels),
        ..Curve::default()
    };
    Chart {
        title,
        across: curves.axis_label(of.unit),
        quantity: lines[0].symbol.clone(),
        curves: lines.iter().zip(points).map(curve).collect(),
    }
}

/// The colour of a wheel, the same in each chart; another curve has that of its place.
fn colour(wheel: Option<&str>, wheels: &[Wheel]) -> Colour {
    let mut names = wheels.iter().map(|wheel| wheel.name.as_str());
    let number = wheel.and_then(|wheel| names.position(|name| name == wheel));
    number.map_or(Colour::OfPlace, Colour::Own)
}

/// The coordinates of lines at the design position; `None` if one is unknown, or for other quantities, whose values matter.
fn designs(lines: &[&Line], parameters: &[Parameter]) -> Option<Vec<f64>> {
    let design = |line: &&Line| {
        let mut parameters = parameters.iter();
        let parameter = parameters.find(|parameter| parameter.title == line.title)?;
        parameter.axis?;
        Some(parameter.value).filter(|value| value.is_finite())
    };
    lines.iter().map(design).collect()
}

fn are_zero(lines: &[&Line]) -> bool {
    /// In units for people.
    const ROUNDING: f64 = 1e-9;
    let mut values = lines.iter().flat_map(|line| line.values.iter().flatten());
    values.all(|value| value.abs() < ROUNDING)
}

/// The title of a chart, with the name that the curve has over wheel travel.
fn title_over(effect: Effect, quantity: &str) -> String {
    let curves = [(TOE.title, "bump steer"), (CAMBER.title, "bump camber")];
    let mut curves = curves.into_iter();
    match curves.find(|(title, _)| effect == Effect::Travel && *title == quantity) {
        Some((title, curve)) => format!("{title} ({curve})"),
        None => quantity.to_owned(),
    }
}

/// Which curves are cut or left out, as they pass through infinity or come near it, a sentence for either.
fn near_infinity(curves: &Curves) -> Vec<String> {
    let cut = curves.lines.iter().filter(|line| line.is_cut);
    let cut: Vec<&Title> = cut.map(|line| &line.title).collect();
    let drawn = curves.lines.iter().map(|line| &line.title);
    let all: Vec<&Title> = drawn.chain(&curves.left_out).collect();
    let left_out: Vec<&Title> = curves.left_out.iter().collect();
    let what = [
        ("Cut where they are near infinity", cut),
        (
            "Left out, as they are at infinity or pass through it",
            left_out,
        ),
    ];
    let what = what.into_iter().filter(|(_, titles)| !titles.is_empty());
    let sentence = |(what, titles): (&str, Vec<&Title>)| {
        let groups = grouped(&titles, |title| &title.of_wheel);
        let names = groups.iter().flat_map(|group| of_wheels(group, &all));
        let names: Vec<String> = names.collect();
        format!(
            "{what}: {}. suspension sweep writes all values.",
            names.join(", ")
        )
    };
    what.map(sentence).collect()
}

/// The name of a quantity of all wheels, or those of the wheels that some of its titles have.
fn of_wheels(some: &[&&Title], all: &[&Title]) -> Vec<String> {
    let of_wheel = &some[0].of_wheel;
    let all = all.iter().filter(|title| title.of_wheel == *of_wheel);
    if some.len() == all.count() {
        return vec![of_wheel.clone()];
    }
    some.iter().map(ToString::to_string).collect()
}

/// The names of groups of lines.
fn names(groups: &[Vec<&Line>]) -> String {
    let names = groups.iter().map(|group| group[0].title.of_wheel.as_str());
    names.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wheel_keeps_its_colour_in_charts_without_the_other() {
        let wheels = ["left", "right"].map(|name| Wheel {
            name: name.to_owned(),
            ..Wheel::default()
        });
        assert_eq!(colour(Some("right"), &wheels), Colour::Own(1));
        assert_eq!(colour(Some("rear"), &wheels), Colour::OfPlace);
        assert_eq!(colour(None, &wheels), Colour::OfPlace);
    }
}
