//! Forces in a drawing: forces along links, and arrows for loads.

use nalgebra::Vector3;
use plotters::prelude::*;

use super::labels::Labels;
use super::marks::{self, ACTING, CHASSIS, LINK};
use super::view::View;
use super::{Drawing, middle};
use crate::mechanism::extent;
use crate::output::svg::{Area, Drawn, FINE, FONT};

/// The force in a link, or along a measured length.
#[derive(Clone, Debug)]
pub struct InLink {
    /// The indices of its end points.
    pub ends: [usize; 2],
    /// The force in N, positive in tension.
    pub tension: f64,
}

/// An external force, not zero.
#[derive(Clone, Copy, Debug)]
pub struct Acting {
    /// The point of application.
    pub at: Vector3<f64>,
    /// The force in N.
    pub force: Vector3<f64>,
}

/// All forces of a drawing.
#[derive(Clone, Debug, Default)]
pub struct Forces {
    /// The lines of the title above the drawing.
    pub title: [String; 2],
    /// Forces along links and measured lengths.
    pub links: Vec<InLink>,
    /// External forces.
    pub acting: Vec<Acting>,
}

const PRESSED: RGBColor = RGBColor(190, 40, 40);

/// The line widths of links without force and with the largest force, in pixels.
const THIN: f64 = 2.0;
const THICK: f64 = 10.0;

/// The length of the longest arrow, as a part of the mechanism's extent.
const LONGEST: f64 = 0.3;

impl Drawing {
    /// Returns tail and tip of each arrow.
    pub(super) fn arrows(&self) -> Vec<[Vector3<f64>; 2]> {
        let Some(forces) = &self.forces else {
            return Vec::new();
        };
        let sizes = forces.acting.iter().map(|acting| acting.force.norm());
        let largest = sizes.fold(0.0, f64::max);
        let scale = LONGEST * extent(self.points.iter().copied()).max() / largest;
        let arrow = |Acting { at, force }: &Acting| [*at, at + force * scale];
        forces.acting.iter().map(arrow).collect()
    }

    /// Returns the lines with marks of their own: a line with a force is drawn by the force.
    pub(super) fn without_force<'a>(
        &self,
        lines: &'a [[usize; 2]],
    ) -> impl Iterator<Item = &'a [usize; 2]> {
        let has_force = |ends: &[usize; 2]| {
            let mut links = self.forces.iter().flat_map(|forces| &forces.links);
            links.any(|link| link.ends == *ends)
        };
        lines.iter().filter(move |ends| !has_force(ends))
    }

    /// Draws links with width and colour by their force, and the arrows.
    pub(super) fn draw_forces(&self, area: &Area<'_>, view: &View) -> Drawn {
        let Some(forces) = &self.forces else {
            return Ok(());
        };
        let largest = forces.links.iter().map(|link| link.tension.abs());
        let largest = largest.fold(f64::MIN_POSITIVE, f64::max);
        for link in &forces.links {
            let ends = link.ends.map(|end| view.pixels(&self.points[end]));
            let width = THIN + (THICK - THIN) * link.tension.abs() / largest;
            let stroke = colour(link.tension).stroke_width((width * f64::from(FINE)) as u32);
            area.draw(&PathElement::new(ends.to_vec(), stroke))?;
        }
        for arrow in self.arrows() {
            let ends = arrow.map(|at| view.pixels(&at));
            marks::load(area, ends)?;
        }
        Ok(())
    }

    /// Draws the sizes of the forces and the title.
    pub(super) fn draw_numbers(&self, area: &Area<'_>, view: &View, labels: &mut Labels) -> Drawn {
        let Some(forces) = &self.forces else {
            return Ok(());
        };
        for link in &forces.links {
            let ends = link.ends.map(|end| view.pixels(&self.points[end]));
            let text = format!("{:.0} N", link.tension.round() + 0.0); // no -0
            let colours = shades(colour(link.tension));
            draw_label(area, labels, (&text, middle(ends)), colours)?;
        }
        for (acting, [_, tip]) in forces.acting.iter().zip(self.arrows()) {
            let text = format!("{:.0} N", acting.force.norm());
            draw_label(area, labels, (&text, view.pixels(&tip)), shades(ACTING))?;
        }
        let font = (FONT, labels.font_size()).into_font();
        let style = font.color(&CHASSIS);
        for (line, y) in forces.title.iter().zip([12, 32]) {
            let corner = (12 * FINE as i32, y * FINE as i32);
            area.draw(&Text::new(line.as_str(), corner, style.clone()))?;
        }
        Ok(())
    }
}

fn colour(tension: f64) -> RGBColor {
    if tension < 0.0 { PRESSED } else { LINK }
}

/// Returns a colour and a darker shade, which is legible on the colour and on white.
fn shades(colour: RGBColor) -> [RGBColor; 2] {
    let RGBColor(red, green, blue) = colour;
    [colour, RGBColor(red / 2, green / 2, blue / 2)]
}

/// Draws a text beside a place; the colours are those of leader and text.
fn draw_label(
    area: &Area<'_>,
    labels: &mut Labels,
    (text, place): (&str, (i32, i32)),
    colours: [RGBColor; 2],
) -> Drawn {
    let boxed = labels.put(text, place);
    labels.draw(area, text, &boxed, colours)
}
