//! The marks of a drawing: how it shows points, parts and lines.

use plotters::element::DashedPathElement;
use plotters::prelude::*;

use super::hull;
use crate::output::svg::{Area, Drawn, FINE};

/// A place on the sheet, in drawing units.
pub(super) type Place = (i32, i32);

pub(super) const CHASSIS: RGBColor = RGBColor(60, 60, 60);
pub(super) const LINK: RGBColor = RGBColor(31, 90, 160);
const TYRE: RGBColor = RGBColor(120, 120, 120);
const RACK: RGBColor = RGBColor(120, 90, 20);
const BAR: RGBColor = RGBColor(0, 140, 160);
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

pub(super) fn link(area: &Area<'_>, ends: Vec<Place>, opacity: f64) -> Drawn {
    line(area, ends, LINK.mix(opacity).stroke_width(4 * FINE))
}

/// Draws a steering rack, over the link between its ends if the listing has one.
pub(super) fn rack(area: &Area<'_>, ends: Vec<Place>, opacity: f64) -> Drawn {
    line(area, ends, RACK.mix(opacity).stroke_width(6 * FINE))
}

/// Draws an anti-roll bar or one of its arms.
pub(super) fn bar(area: &Area<'_>, ends: Vec<Place>, opacity: f64) -> Drawn {
    line(area, ends, BAR.mix(opacity).stroke_width(4 * FINE))
}

pub(super) fn slide(area: &Area<'_>, ends: Vec<Place>, opacity: f64) -> Drawn {
    line(area, ends, LINK.mix(opacity).stroke_width(2 * FINE))
}

pub(super) fn body(area: &Area<'_>, corners: Vec<Place>, opacity: f64) -> Drawn {
    let hull = hull::hull(corners);
    let inside = BODY.mix(0.22 * opacity).filled();
    area.draw(&Polygon::new(hull.clone(), inside))?;
    let closed = hull.iter().chain(hull.first()).copied().collect();
    line(area, closed, BODY.mix(opacity).stroke_width(FINE))
}

/// Draws the circumference of a wheel's tyre.
pub(super) fn tyre(area: &Area<'_>, rim: Vec<Place>, opacity: f64) -> Drawn {
    let inside = TYRE.mix(0.12 * opacity).filled();
    area.draw(&Polygon::new(rim.clone(), inside))?;
    line(area, rim, TYRE.mix(opacity).stroke_width(2 * FINE))
}

/// Draws a measured or driven length.
pub(super) fn length(area: &Area<'_>, ends: Vec<Place>, opacity: f64) -> Drawn {
    let stroke = LENGTH.mix(opacity).stroke_width(2 * FINE);
    dashes(area, ends, [9, 5], stroke)
}

/// Draws a kingpin or a spin axis.
pub(super) fn axis(area: &Area<'_>, ends: Vec<Place>, opacity: f64) -> Drawn {
    dashes(area, ends, [14, 4], AXIS.mix(opacity).stroke_width(FINE))
}

fn line(area: &Area<'_>, places: Vec<Place>, stroke: ShapeStyle) -> Drawn {
    Ok(area.draw(&PathElement::new(places, stroke))?)
}

/// Draws a line of dashes with gaps between them, whose lengths are in pixels.
fn dashes(area: &Area<'_>, ends: Vec<Place>, lengths: [u32; 2], stroke: ShapeStyle) -> Drawn {
    let [dash, gap] = lengths.map(|length| length * FINE);
    Ok(area.draw(&DashedPathElement::new(ends, dash, gap, stroke))?)
}

/// Draws the arrow of a load.
pub(super) fn load(area: &Area<'_>, ends: [Place; 2]) -> Drawn {
    line(area, ends.into(), ACTING.stroke_width(3 * FINE))?;
    Ok(area.draw(&Polygon::new(head(ends), ACTING.filled()))?)
}

/// Returns the triangle at the tip of an arrow.
fn head([from, to]: [Place; 2]) -> Vec<Place> {
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
