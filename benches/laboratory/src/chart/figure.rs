//! One figure: time against error, the Pareto front drawn.

use maud::{Markup, html};

use super::axis::{Axis, nanoseconds, power};
use super::labels::{Area, LINE, place};
use super::pareto::front;
use super::style::{INK, Style};

/// A point of a figure.
#[derive(Clone, Debug)]
pub struct Mark {
    /// The name, shown at the Pareto front and on hover.
    pub name: String,
    /// The text on hover.
    pub details: String,
    /// Time of a step, ns.
    pub time: f64,
    /// The range of the middle half of the times, ns.
    pub spread: f64,
    /// Worst error.
    pub error: f64,
    /// The style.
    pub style: Style,
}

/// Time against error.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The title.
    pub title: String,
    /// The vertical axis, with its unit.
    pub quantity: String,
    /// The points; those that are not positive and finite are omitted.
    pub marks: Vec<Mark>,
}

/// Width and height of a figure.
pub const SIZE: (f64, f64) = (720.0, 480.0);
const LEFT: f64 = 78.0;
const RIGHT: f64 = SIZE.0 - 26.0;
const TOP: f64 = 40.0;
const BOTTOM: f64 = SIZE.1 - 56.0;

/// Numbers of a drawing, to a tenth.
pub fn tenth(place: f64) -> f64 {
    (place * 10.0).round() / 10.0
}

impl Figure {
    /// The figure as a group of SVG elements of the size [`SIZE`].
    pub fn draw(&self) -> Markup {
        let shown = |mark: &&Mark| {
            [mark.time, mark.error]
                .iter()
                .all(|x| *x > 0.0 && x.is_finite())
        };
        let marks: Vec<&Mark> = self.marks.iter().filter(shown).collect();
        let x = Axis::around(marks.iter().map(|mark| mark.time), [LEFT, RIGHT]);
        let y = Axis::around(marks.iter().map(|mark| mark.error), [BOTTOM, TOP]);
        let places: Vec<(f64, f64)> = marks
            .iter()
            .map(|mark| (x.place(mark.time), y.place(mark.error)))
            .collect();
        let values: Vec<(f64, f64)> = marks.iter().map(|mark| (mark.time, mark.error)).collect();
        let front = front(&values);
        let corners = staircase(front.iter().map(|index| places[*index]));
        let drawn = drawn(&places, &corners);
        html! {
            g font-size="12" fill=(INK) {
                text x=(LEFT) y=(TOP - 16.0) font-size="15" font-weight="bold" { (self.title) }
                (self.grid(&x, &y))
                (draw_staircase(&corners))
                @for (mark, at) in marks.iter().zip(&places) { (draw_mark(mark, *at, &x)) }
                (names(&marks, &places, &front, &drawn))
            }
        }
    }

    fn grid(&self, x: &Axis, y: &Axis) -> Markup {
        let middle = (LEFT + RIGHT) / 2.0;
        let turned = format!("translate(18 {}) rotate(-90)", (TOP + BOTTOM) / 2.0);
        html! {
            g stroke="#e4e4e4" {
                @for at in x.minor().map(tenth) { line x1=(at) x2=(at) y1=(TOP) y2=(BOTTOM) stroke="#f3f3f3" {} }
                @for (_, at) in x.decades() { line x1=(tenth(at)) x2=(tenth(at)) y1=(TOP) y2=(BOTTOM) {} }
                @for (_, at) in y.decades() { line x1=(LEFT) x2=(RIGHT) y1=(tenth(at)) y2=(tenth(at)) {} }
            }
            rect x=(LEFT) y=(TOP) width=(RIGHT - LEFT) height=(BOTTOM - TOP) fill="none" stroke=(INK) {}
            @for (exponent, at) in x.decades() {
                text x=(tenth(at)) y=(BOTTOM + 18.0) text-anchor="middle" { (nanoseconds(exponent)) }
            }
            @for (exponent, at) in y.decades() {
                text x=(LEFT - 8.0) y=(tenth(at + 4.0)) text-anchor="end" { (power(exponent)) }
            }
            text x=(middle) y=(BOTTOM + 42.0) text-anchor="middle" font-size="13" { "time of a step, one suspension" }
            text transform=(turned) text-anchor="middle" font-size="13" { (self.quantity) }
        }
    }
}

/// Returns the front's staircase, corner by corner: points above and right of it are beaten.
fn staircase(front: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut corners = Vec::new();
    let mut level = TOP;
    for (x, y) in front {
        corners.extend([(x, level), (x, y)]);
        level = y;
    }
    corners.extend((!corners.is_empty()).then_some((RIGHT, level)));
    corners
}

fn draw_staircase(corners: &[(f64, f64)]) -> Markup {
    let points: Vec<String> = corners
        .iter()
        .map(|(x, y)| format!("{},{}", tenth(*x), tenth(*y)))
        .collect();
    html! {
        polyline points=(points.join(" ")) fill="none" stroke=(INK) stroke-width="1.2" stroke-dasharray="5 3" {}
    }
}

/// Returns the areas that a name must not cover: points, and the staircase's lines.
fn drawn(places: &[(f64, f64)], corners: &[(f64, f64)]) -> Vec<Area> {
    const POINT: f64 = 5.0;
    let points = places
        .iter()
        .map(|place| Area::around(*place, POINT, POINT));
    let lines = corners.windows(2).map(|ends| {
        let ((x, y), (to_x, to_y)) = (ends[0], ends[1]);
        let middle = ((x + to_x) / 2.0, (y + to_y) / 2.0);
        Area::around(
            middle,
            (to_x - x).abs() / 2.0 + 1.0,
            (to_y - y).abs() / 2.0 + 1.0,
        )
    });
    points.chain(lines).collect()
}

fn draw_mark(mark: &Mark, (x, y): (f64, f64), axis: &Axis) -> Markup {
    let half = mark.spread / 2.0;
    let low = axis
        .place((mark.time - half).max(mark.time * 0.1))
        .max(LEFT);
    let high = axis.place(mark.time + half).min(RIGHT);
    html! {
        g {
            title { (mark.name) "\n" (mark.details) }
            line x1=(tenth(low)) x2=(tenth(high)) y1=(tenth(y)) y2=(tenth(y)) stroke=(mark.style.colour) stroke-width="1.5" {}
            (mark.style.draw(tenth(x), tenth(y)))
        }
    }
}

/// Names of the points on the front.
fn names(marks: &[&Mark], places: &[(f64, f64)], front: &[usize], drawn: &[Area]) -> Markup {
    let texts: Vec<(String, (f64, f64))> = front
        .iter()
        .map(|index| (marks[*index].name.clone(), places[*index]))
        .collect();
    let frame = Area([LEFT + 2.0, TOP + 2.0, RIGHT - 2.0, BOTTOM - 2.0]);
    let areas = place(&texts, drawn, frame);
    html! {
        @for ((text, point), Area([left, top, right, bottom])) in texts.iter().zip(areas) {
            @let end = (point.0.clamp(left, right), point.1.clamp(top, bottom));
            line x1=(tenth(point.0)) y1=(tenth(point.1)) x2=(tenth(end.0)) y2=(tenth(end.1)) stroke=(INK) stroke-width="0.6" {}
            text x=(tenth((left + right) / 2.0)) y=(tenth(top + LINE - 3.0)) text-anchor="middle"
                stroke="white" stroke-width="3" paint-order="stroke" { (text) }
        }
    }
}
