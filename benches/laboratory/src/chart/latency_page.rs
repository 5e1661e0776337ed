//! Latencies as a figure and a table.

use maud::{Markup, html};

use super::axis::{Axis, nanoseconds};
use super::figure::{SIZE, tenth};
use super::latency::{Latencies, PARTS};
use super::style::{INK, Style};

const LEFT: f64 = 78.0;
const RIGHT: f64 = SIZE.0 - 26.0;
const TOP: f64 = 40.0;
const BOTTOM: f64 = SIZE.1 - 56.0;

/// Returns pairs of a time in nanoseconds and the part of all steps that take longer, from all to the worst one.
fn tail(latencies: &Latencies) -> Vec<(f64, f64)> {
    let times = &latencies.times;
    let count = times.len() as f64;
    let seen = times.iter_recorded().scan(0, |before, bucket| {
        let slower = (count - *before as f64) / count;
        *before += bucket.count_since_last_iteration();
        Some((slower, bucket.value_iterated_to() as f64))
    });
    seen.filter(|(_, time)| *time > 0.0).collect()
}

/// The part of steps that take longer, over time, as a group of SVG elements.
pub fn draw(title: &str, all: &[Latencies]) -> Markup {
    let tails: Vec<Vec<(f64, f64)>> = all.iter().map(tail).collect();
    let points = || tails.iter().flatten();
    let x = Axis::around(points().map(|point| point.1), [LEFT, RIGHT]);
    let rarest = points().fold(1.0, |rarest, point| point.0.min(rarest));
    let y = Axis::between([rarest.log10().floor() as i32, 0], [BOTTOM, TOP]);
    let turned = format!("translate(18 {}) rotate(-90)", (TOP + BOTTOM) / 2.0);
    html! {
        g font-size="12" fill=(INK) {
            text x=(LEFT) y=(TOP - 16.0) font-size="15" font-weight="bold" { (title) }
            g stroke="#e4e4e4" {
                @for (_, at) in x.decades() { line x1=(tenth(at)) x2=(tenth(at)) y1=(TOP) y2=(BOTTOM) {} }
                @for (_, at) in y.decades() { line x1=(LEFT) x2=(RIGHT) y1=(tenth(at)) y2=(tenth(at)) {} }
            }
            rect x=(LEFT) y=(TOP) width=(RIGHT - LEFT) height=(BOTTOM - TOP) fill="none" stroke=(INK) {}
            @for (exponent, at) in x.decades() {
                text x=(tenth(at)) y=(BOTTOM + 18.0) text-anchor="middle" { (nanoseconds(exponent)) }
            }
            @for (exponent, at) in y.decades() {
                text x=(LEFT - 8.0) y=(tenth(at + 4.0)) text-anchor="end" { (percent(exponent)) }
            }
            text x=((LEFT + RIGHT) / 2.0) y=(BOTTOM + 42.0) text-anchor="middle" font-size="13" { "time of a step" }
            text transform=(turned) text-anchor="middle" font-size="13" { "steps that take longer" }
            @for (index, (latencies, tail)) in all.iter().zip(&tails).enumerate() {
                (curve(latencies, tail, &x, &y, index))
            }
        }
    }
}

fn curve(latencies: &Latencies, tail: &[(f64, f64)], x: &Axis, y: &Axis, index: usize) -> Markup {
    let path: Vec<String> = tail
        .iter()
        .map(|(slower, time)| format!("{},{}", tenth(x.place(*time)), tenth(y.place(*slower))))
        .collect();
    let colour = Style::new(&latencies.method, "f64", 1).colour;
    let dashes = if latencies.load > 0 { "6 3" } else { "none" };
    let row = TOP + 20.0 + 18.0 * index as f64;
    html! {
        polyline points=(path.join(" ")) fill="none" stroke=(colour) stroke-width="1.8" stroke-dasharray=(dashes) {
            title { (name(latencies)) }
        }
        line x1=(RIGHT - 250.0) x2=(RIGHT - 216.0) y1=(row) y2=(row) stroke=(colour) stroke-width="1.8" stroke-dasharray=(dashes) {}
        text x=(RIGHT - 208.0) y=(row + 4.0) { (name(latencies)) }
    }
}

fn name(latencies: &Latencies) -> String {
    match latencies.load {
        0 => latencies.method.clone(),
        threads => format!("{}, {threads} threads of load", latencies.method),
    }
}

fn percent(exponent: i32) -> String {
    let decimals = usize::try_from(-2 - exponent).unwrap_or_default();
    format!("{:.decimals$} %", 10_f64.powi(exponent + 2))
}

/// Median to worst, ns.
pub fn table(all: &[Latencies], clock: u64) -> Markup {
    html! {
        table {
            tr {
                th { "method" } th { "steps" }
                @for (name, _) in PARTS { th { (name) ", ns" } }
            }
            @for latencies in all {
                tr {
                    td { (name(latencies)) }
                    td.number { (latencies.times.len()) }
                    @for (_, part) in PARTS { td.number { (latencies.times.value_at_quantile(part)) } }
                }
            }
        }
        p {
            "Each step to position, velocity and acceleration is timed by itself with the monotonic "
            "clock of the standard library, whose own " (clock) " ns (median) are part of the times. "
            "The load are threads of the same process, one a core, that compute and copy memory."
        }
    }
}
