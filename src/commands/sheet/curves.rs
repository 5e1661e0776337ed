//! The curves on the page.

use maud::{Markup, html};

use crate::characteristics::{Curves, Does, Line, Title};
use crate::commands::sheet::grouped::grouped;
use crate::mechanism::Unit;
use crate::output::page::charts;
use crate::output::plot::{Chart, Curve};
use crate::quantities::{CAMBER, TOE};

/// The charts along what moves, under their heading.
pub(super) fn over(curves: &Curves, unit: Unit) -> Markup {
    html! {
        h2 { "Over " (curves.title) }
        @for note in near_infinity(curves) { p { (note) } }
        (charts(&each(curves, unit)))
    }
}

/// A chart of each quantity, with the curves of all wheels.
fn each(curves: &Curves, unit: Unit) -> Vec<Chart> {
    let groups = grouped(&curves.lines, |line| &line.title.of_wheel);
    let curve = |line: &&Line| Curve {
        name: line.title.wheel.clone().unwrap_or_default(),
        line: curves.points(line),
        marks: Vec::new(),
    };
    let chart = |lines: Vec<&Line>| Chart {
        title: title_over(curves.way.does, &lines[0].title.of_wheel),
        across: curves.axis_label(unit),
        quantity: lines[0].symbol.clone(),
        curves: lines.iter().map(curve).collect(),
    };
    groups.into_iter().map(chart).collect()
}

/// The title of a chart, with the name that the curve has over wheel travel.
fn title_over(does: Does, quantity: &str) -> String {
    let curves = [(TOE.title, "bump steer"), (CAMBER.title, "bump camber")];
    let mut curves = curves.into_iter();
    match curves.find(|(title, _)| does == Does::Travel && *title == quantity) {
        Some((title, curve)) => format!("{title} ({curve})"),
        None => quantity.to_owned(),
    }
}

/// Which curves are cut or left out, as they pass through infinity or come near it, a sentence for either.
fn near_infinity(curves: &Curves) -> Vec<String> {
    let cut = curves.lines.iter().filter(|line| line.is_cut);
    let cut: Vec<&Title> = cut.map(|line| &line.title).collect();
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
        let names = groups.iter().map(|group| group[0].of_wheel.as_str());
        let names: Vec<&str> = names.collect();
        format!(
            "{what}: {}. suspension sweep writes all values.",
            names.join(", ")
        )
    };
    what.map(sentence).collect()
}
