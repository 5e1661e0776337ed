//! The marks of a drawing: how it shows points, parts and lines. `part` is the opacity.

use plotters::element::DashedPathElement;
use plotters::prelude::*;

use super::hull;
use crate::output::svg::{Area, Drawn, FINE};

type Place = (i32, i32);

pub(super) const CHASSIS: RGBColor = RGBColor(60, 60, 60);
pub(super) const LINK: RGBColor = RGBColor(31, 90, 160);
const BODY: RGBColor = RGBColor(200, 80, 20);
const LENGTH: RGBColor = RGBColor(40, 130, 70);
const AXIS: RGBColor = RGBColor(160, 40, 110);
pub(super) const ACTING: RGBColor = RGBColor(110, 60, 150);

/// Half of the width of a point, in pixels.
const HALF: u32 = 5;

pub(super) fn chassis_point(area: &Area<'_>, (x, y): Place) -> Drawn {
    let half = (HALF * FINE) as i32;
    let corners = [(x - half, y - half), (x + half, y + half)];
    Ok(area.draw(&Rectangle::new(corners, CHASSIS.filled()))?)
}

pub(super) fn moving_point(area: &Area<'_>, at: Place) -> Drawn {
    area.draw(&Circle::new(at, HALF * FINE, WHITE.filled()))?;
    Ok(area.draw(&Circle::new(at, HALF * FINE, LINK.stroke_width(2 * FINE)))?)
}

pub(super) fn link(area: &Area<'_>, line: Vec<Place>, part: f64) -> Drawn {
    Ok(area.draw(&PathElement::new(
        line,
        LINK.mix(part).stroke_width(4 * FINE),
    ))?)
}

pub(super) fn slide(area: &Area<'_>, line: Vec<Place>, part: f64) -> Drawn {
    Ok(area.draw(&PathElement::new(
        line,
        LINK.mix(part).stroke_width(2 * FINE),
    ))?)
}

pub(super) fn body(area: &Area<'_>, corners: Vec<Place>, part: f64) -> Drawn {
    let hull = hull::hull(corners);
    area.draw(&Polygon::new(hull.clone(), BODY.mix(0.22 * part).filled()))?;
    let closed = hull.iter().chain(hull.first()).copied();
    Ok(area.draw(&PathElement::new(
        closed.collect::<Vec<_>>(),
        BODY.mix(part).stroke_width(FINE),
    ))?)
}

/// Draws a measured or driven length.
pub(super) fn length(area: &Area<'_>, line: Vec<Place>, part: f64) -> Drawn {
    let (dash, gap) = (9 * FINE, 5 * FINE);
    let stroke = LENGTH.mix(part).stroke_width(2 * FINE);
    Ok(area.draw(&DashedPathElement::new(line, dash, gap, stroke))?)
}

/// Draws a kingpin or a spin axis.
pub(super) fn axis(area: &Area<'_>, line: Vec<Place>, part: f64) -> Drawn {
    let (dash, gap) = (14 * FINE, 4 * FINE);
    let stroke = AXIS.mix(part).stroke_width(FINE);
    Ok(area.draw(&DashedPathElement::new(line, dash, gap, stroke))?)
}

/// Draws the arrow of a load.
pub(super) fn load(area: &Area<'_>, ends: [Place; 2]) -> Drawn {
    let stroke = ACTING.stroke_width(3 * FINE);
    area.draw(&PathElement::new(ends.to_vec(), stroke))?;
    Ok(area.draw(&Polygon::new(head(ends), ACTING.filled()))?)
}

/// Returns the triangle at the tip of an arrow.
fn head([from, to]: [(i32, i32); 2]) -> Vec<(i32, i32)> {
    const LENGTH: f64 = 14.0;
    const HALF_WIDTH: f64 = 5.0;
    let [dx, dy] = [to.0 - from.0, to.1 - from.1].map(f64::from);
    let length = dx.hypot(dy).max(1.0) / f64::from(FINE);
    let [ux, uy] = [dx / length, dy / length];
    let at = |along: f64, across: f64| {
        let x = f64::from(to.0) - along * ux - across * uy;
        let y = f64::from(to.1) - along * uy + across * ux;
        (x.round() as i32, y.round() as i32)
    };
    vec![
        at(-2.0, 0.0),
        at(LENGTH, HALF_WIDTH),
        at(LENGTH, -HALF_WIDTH),
    ]
}
