//! The page of HTML: a chart for each quantity, with a curve for each value.

use maud::{Markup, html};

use crate::characteristics::{Curves, Line};
use crate::commands::vary::report::{DESIGN, Report};
use crate::commands::vary::study::{ROUNDING, Variant};
use crate::commands::vary::varied::label;
use crate::mechanism::ends;
use crate::output::colour::Colour;
use crate::output::page::{charts, cut_short, page};
use crate::output::plot::{Chart, Curve};

/// Returns the page, with charts of all quantities or of those whose numbers the report has.
pub(super) fn html(report: &Report<'_>, draws_all: bool) -> String {
    let study = report.study;
    // An interrupt may come before the design.
    let drawn = study.drawn();
    let first = study.design().or_else(|| drawn.first().copied());
    let sections = first.map_or(&[][..], |variant| &variant.curves);
    let body = html! {
        p { (report.heading()) }
        @if let Some(interrupt) = study.describe_interrupt() {
            p { strong { "The study is not complete: " } (interrupt) }
        }
        @if let Some(unbuilt) = study.describe_unbuilt(report.varied) {
            p { strong { "Values are left out: " } (unbuilt) }
        }
        @if study.stride > 1 {
            p { "The charts have the curves of 1 of " (study.stride) " values; the table of --csv has the numbers of all." }
        }
        (folded(&study.cut_short))
        @for curves in sections { (section(report, curves, draws_all)) }
    };
    let title = format!("Variation of {}", report.varied.change.name);
    page(&title, &body)
}

/// The sentences on curves that end early; several are folded, so that the charts are not pages below.
fn folded(sentences: &[String]) -> Markup {
    match sentences {
        [] | [_] => cut_short(sentences),
        _ => html! {
            details {
                summary { (sentences.len()) " sweeps end before the range does, and their curves too." }
                (cut_short(sentences))
            }
        },
    }
}

/// The charts along what moves, under their heading.
fn section(report: &Report<'_>, curves: &Curves, draws_all: bool) -> Markup {
    let is_shown = |line: &&Line| {
        let mut numbers = report.numbers.iter();
        draws_all || numbers.any(|number| number.quantity == line.quantity)
    };
    let lines = curves.lines.iter().filter(is_shown);
    let charts_of_all = lines.map(|line| chart(report, curves, line));
    let (differ, same): (Vec<Chart>, Vec<Chart>) = charts_of_all.partition(differ);
    let same: Vec<&str> = same.iter().map(|chart| chart.title.as_str()).collect();
    let left_out: Vec<String> = curves.left_out.iter().map(ToString::to_string).collect();
    html! {
        h2 { "Over " (curves.title) }
        @if !same.is_empty() {
            p { "Alike for all values to the eye, without a chart: " (same.join(", ")) "." }
        }
        @if draws_all && !left_out.is_empty() {
            p { "Left out, as they are at infinity or pass through it: " (left_out.join(", ")) "." }
        }
        @if draws_all && let Some(note) = curves.without_small_steer() { p { (note) "." } }
        @if !differ.is_empty() { (legend(report)) }
        (charts(&differ))
    }
}

/// The chart of a quantity; the curve of the design is drawn over the others.
fn chart(report: &Report<'_>, curves: &Curves, line: &Line) -> Chart {
    let of_variant = |(variant, colour): (&Variant, Colour)| {
        let mut sections = variant.curves.iter();
        let section = sections.find(|section| section.title == curves.title)?;
        let mut lines = section.lines.iter();
        let line = lines.find(|other| other.title == line.title)?;
        Some(Curve {
            line: section.points(line),
            colour,
            is_dashed: is_dashed(variant),
            ..Curve::default()
        })
    };
    let mut drawn: Vec<Curve> = coloured(report).filter_map(of_variant).collect();
    drawn.sort_by_key(|curve| curve.colour == Colour::Black);
    Chart {
        title: line.title.to_string(),
        across: curves.axis_label(report.varied.mechanism.unit),
        quantity: line.symbol.clone(),
        curves: drawn,
    }
}

/// Returns whether the curves of a chart are beside each other, as far as a reader sees. That one of them ends before another
/// is said in words.
fn differ(chart: &Chart) -> bool {
    /// A part of the height of all curves.
    const VISIBLE: f64 = 1.0 / 200.0;
    let heights = chart.curves.iter().flat_map(|curve| &curve.line);
    let [low, high] = ends(
        heights
            .map(|point| point.1)
            .filter(|height| height.is_finite()),
    )
    .unwrap_or_default();
    let near = VISIBLE * (high - low);
    let is_same = |(a, b): (&(f64, f64), &(f64, f64))| match [a.1, b.1].map(f64::is_finite) {
        [true, true] => (a.1 - b.1).abs() <= near.max(ROUNDING * a.1.abs().max(1.0)),
        [a, b] => a == b,
    };
    let Some((design, others)) = chart.curves.split_last() else {
        return false;
    };
    let lies_on_design = |other: &Curve| {
        let pairs: Vec<_> = other.line.iter().zip(&design.line).collect();
        let is_of_both = |(a, b): &(&(f64, f64), &(f64, f64))| a.1.is_finite() && b.1.is_finite();
        let [first, last] = [
            pairs.iter().position(is_of_both),
            pairs.iter().rposition(is_of_both),
        ];
        let of_both = first.zip(last).map(|(first, last)| &pairs[first..=last]);
        of_both.unwrap_or(&pairs).iter().copied().all(is_same)
    };
    !others.iter().all(lies_on_design)
}

/// The variants that are drawn, with their colours.
fn coloured<'a>(report: &Report<'a>) -> impl Iterator<Item = (&'a Variant, Colour)> {
    let variants = report.study.drawn();
    let last = variants.len().saturating_sub(1).max(1) as f64;
    let is_falling = variants.first().map(|variant| variant.value)
        > variants.last().map(|variant| variant.value);
    variants
        .into_iter()
        .enumerate()
        .map(move |(place, variant)| {
            let part = place as f64 / last;
            let colour = match variant.value {
                0.0 => Colour::Black,
                _ => Colour::OfScale(if is_falling { 1.0 - part } else { part }),
            };
            (variant, colour)
        })
}

/// Returns whether the curve of a variant is dashed: those below the design are, so that black and white tells them from those
/// above it.
fn is_dashed(variant: &Variant) -> bool {
    variant.value < 0.0
}

/// The names of the curves of all charts.
fn legend(report: &Report<'_>) -> Markup {
    let unit = report.varied.mechanism.unit.symbol();
    let name = |variant: &Variant| match variant.value {
        0.0 => DESIGN.to_owned(),
        value => {
            let plus = if value > 0.0 { "+" } else { "" };
            format!("{plus}{} {unit}", label(value))
        }
    };
    let style = |(variant, colour): (&Variant, Colour)| {
        let dashes = if is_dashed(variant) {
            "dashed"
        } else {
            "solid"
        };
        format!(
            "border-color: {}; border-top-style: {dashes}",
            colour.in_css()
        )
    };
    html! {
        p.legend {
            @for (variant, colour) in coloured(report) {
                span {
                    span.line style=(style((variant, colour))) {}
                    (name(variant))
                }
            }
        }
    }
}
