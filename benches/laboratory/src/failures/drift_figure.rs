//! Long runs: drift against steps.

use maud::{Markup, html};

use super::rows::LongRow;
use crate::chart::axis::{Axis, power};
use crate::chart::figure::tenth;
use crate::chart::style::INK;
use suspension::number::rounded;

/// Width and height of the figure.
pub const SIZE: (f64, f64) = (800.0, 340.0);
const LEFT: f64 = 78.0;
const RIGHT: f64 = SIZE.0 - 230.0;
const TOP: f64 = 40.0;
const BOTTOM: f64 = SIZE.1 - 56.0;

/// Colours for colour-blind readers, one per run.
const COLOURS: [&str; 4] = ["#0072b2", "#d55e00", "#56b4e9", "#e69f00"];

/// The figure as a group of SVG elements; a drift of zero cannot be drawn.
pub fn draw(rows: &[LongRow]) -> Markup {
    let drawn: Vec<&LongRow> = rows.iter().filter(|row| row.drift_m > 0.0).collect();
    let x = Axis::around(drawn.iter().map(|row| row.steps as f64), [LEFT, RIGHT]);
    let y = Axis::around(drawn.iter().map(|row| row.drift_m), [BOTTOM, TOP]);
    html! {
        g font-size="12" fill=(INK) {
            text x=(LEFT) y=(TOP - 16.0) font-size="15" font-weight="bold" { "Steps of 1 ms back and forth" }
            (grid(&x, &y))
            @for (run, colour) in runs(&drawn).into_iter().zip(COLOURS) { (line(&run, colour, &x, &y)) }
        }
    }
}

fn runs<'a>(rows: &[&'a LongRow]) -> Vec<Vec<&'a LongRow>> {
    let same = |a: &&LongRow, b: &&LongRow| a.method == b.method && a.scalar == b.scalar;
    rows.chunk_by(same).map(<[_]>::to_vec).collect()
}

fn grid(x: &Axis, y: &Axis) -> Markup {
    let turned = format!("translate(18 {}) rotate(-90)", (TOP + BOTTOM) / 2.0);
    html! {
        g stroke="#e4e4e4" {
            @for (_, at) in x.decades() { line x1=(tenth(at)) x2=(tenth(at)) y1=(TOP) y2=(BOTTOM) {} }
            @for (_, at) in y.decades() { line x1=(LEFT) x2=(RIGHT) y1=(tenth(at)) y2=(tenth(at)) {} }
        }
        rect x=(LEFT) y=(TOP) width=(RIGHT - LEFT) height=(BOTTOM - TOP) fill="none" stroke=(INK) {}
        @for (exponent, at) in x.decades() {
            text x=(tenth(at)) y=(BOTTOM + 18.0) text-anchor="middle" { (power(exponent)) }
        }
        @for (exponent, at) in y.decades().filter(|(exponent, _)| exponent % 2 == 0) {
            text x=(LEFT - 8.0) y=(tenth(at + 4.0)) text-anchor="end" { (power(exponent)) }
        }
        text x=((LEFT + RIGHT) / 2.0) y=(BOTTOM + 42.0) text-anchor="middle" font-size="13" { "steps" }
        text transform=(turned) text-anchor="middle" font-size="13" { "largest residual, m" }
    }
}

fn line(run: &[&LongRow], colour: &str, x: &Axis, y: &Axis) -> Markup {
    let place = |row: &LongRow| {
        (
            tenth(x.place(row.steps as f64)),
            tenth(y.place(row.drift_m)),
        )
    };
    let points: Vec<String> = run
        .iter()
        .map(|row| place(row))
        .map(|(x, y)| format!("{x},{y}"))
        .collect();
    html! {
        polyline points=(points.join(" ")) fill="none" stroke=(colour) stroke-width="1.5" {}
        @for row in run {
            @let (x, y) = place(row);
            circle cx=(x) cy=(y) r="3" fill=(colour) {
                title { (details(row)) }
            }
        }
        @if let Some(last) = run.last() {
            text x=(RIGHT + 10.0) y=(place(last).1 + 4.0) fill=(colour) {
                (last.method) ", " (last.scalar) ": " (rounded(last.drift_m, 2)) " m"
            }
        }
    }
}

fn details(row: &LongRow) -> String {
    let LongRow {
        method,
        closure,
        scalar,
        steps,
        drift_m,
        iterations_a_step,
        ended: _,
    } = row;
    let (drift, iterations) = (rounded(*drift_m, 2), rounded(*iterations_a_step, 4));
    format!(
        "{method}, {closure}, {scalar}\n{steps} steps: off by {drift} m at most, {iterations} iterations a step"
    )
}
