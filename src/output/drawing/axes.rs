//! Directions and sizes on a drawing: the axes of space, and a scale or rulers.

use nalgebra::Vector3;
use plotters::prelude::*;

use super::labels;
use super::marks::CHASSIS;
use super::view::{Seen, View};
use super::{FONT_SIZE, pixels};
use crate::number::fixed;
use crate::output::svg::{Area, Drawn, FINE, FONT};

const NAMES: [&str; 3] = ["x", "y", "z"];

/// In pixels: the length of an axis, and the distance of its origin from the lower left corner.
const AXIS: f64 = 34.0;
const CORNER: [f64; 2] = [52.0, 56.0];
/// The distance of the scale's right end from the lower right corner, and its greatest length.
const SCALE: [f64; 2] = [30.0, 24.0];
const LONGEST: f64 = 170.0;
/// What both leave free at the bottom of the sheet, at the left and at the right.
pub(super) const BESIDE: [f64; 2] = [2.0 * CORNER[0] + 16.0, SCALE[0] + LONGEST + 16.0];
/// The length at both ends of a ruler without ticks, where other text stands.
const HEAD: f64 = 60.0;
const FOOT: f64 = 30.0;
/// The least distance between the ticks of a ruler.
const TICKS: f64 = 70.0;

/// Draws the axes and the scale or rulers on a sheet of the given size in pixels, and returns the boxes of the texts.
pub(super) fn draw(
    area: &Area<'_>,
    view: &View,
    shown: (u32, u32),
    unit: &str,
) -> Result<Vec<[i32; 4]>, Box<dyn std::error::Error>> {
    let size = [f64::from(shown.0), f64::from(shown.1)];
    let mut texts = Texts {
        area,
        boxes: Vec::new(),
    };
    texts.write(view.title, [10.0, 8.0], FONT_SIZE)?;
    if view.seen == Seen::Oblique {
        draw_triad(&mut texts, view, size)?;
        draw_scale(&mut texts, view, size, unit)?;
    } else {
        draw_ruler(&mut texts, view, size, unit, Way::Across)?;
        draw_ruler(&mut texts, view, size, unit, Way::Up)?;
    }
    Ok(texts.boxes)
}

/// An area, and the boxes of the texts on it.
struct Texts<'a, 'b> {
    area: &'a Area<'b>,
    boxes: Vec<[i32; 4]>,
}

impl Texts<'_, '_> {
    /// Writes a text whose upper left corner and font size are given in pixels.
    fn write(&mut self, text: &str, [left, top]: [f64; 2], size: u32) -> Drawn {
        let font = (FONT, size * FINE).into_font().color(&CHASSIS);
        let (x, y) = pixels([left, top]);
        self.area.draw(&Text::new(text, (x, y), font))?;
        let size = f64::from(size);
        let (right, bottom) = pixels([left + labels::width(text, size), top + size]);
        self.boxes.push([x, y, right, bottom]);
        Ok(())
    }

    fn line(&self, ends: [[f64; 2]; 2], style: ShapeStyle) -> Drawn {
        Ok(self.area.draw(&PathElement::new(ends.map(pixels), style))?)
    }
}

fn draw_triad(texts: &mut Texts<'_, '_>, view: &View, [_, height]: [f64; 2]) -> Drawn {
    let origin = [CORNER[0], height - CORNER[1]];
    for (axis, name) in NAMES.iter().enumerate() {
        let [right, up] = [view.across[axis], view.up[axis]];
        let at = |part: f64| {
            [
                origin[0] + part * AXIS * right,
                origin[1] - part * AXIS * up,
            ]
        };
        texts.line([at(0.0), at(1.0)], CHASSIS.stroke_width(2 * FINE))?;
        let [x, y] = at(1.35);
        texts.write(name, [x - 4.0, y - 8.0], FONT_SIZE)?;
    }
    Ok(())
}

fn draw_scale(
    texts: &mut Texts<'_, '_>,
    view: &View,
    [width, height]: [f64; 2],
    unit: &str,
) -> Drawn {
    let length = round_below(LONGEST / view.scale);
    let [right, y] = [width - SCALE[0], height - SCALE[1]];
    let left = right - length * view.scale;
    let stroke = CHASSIS.stroke_width(2 * FINE);
    for line in [
        [[left, y], [right, y]],
        [[left, y - 5.0], [left, y + 5.0]],
        [[right, y - 5.0], [right, y + 5.0]],
    ] {
        texts.line(line, stroke)?;
    }
    let text = format!("{} {unit}", label(length, length));
    texts.write(&text, [left, y - 20.0], FONT_SIZE)
}

/// The lower or the left side of the sheet.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Across,
    Up,
}

/// Draws a ruler with lines over the sheet, for the coordinate to the right or upwards.
fn draw_ruler(
    texts: &mut Texts<'_, '_>,
    view: &View,
    size: [f64; 2],
    unit: &str,
    way: Way,
) -> Drawn {
    let (direction, sheet, length) = match way {
        Way::Across => (view.across, 0, size[0]),
        Way::Up => (view.up, 1, size[1]),
    };
    let axis = direction.iter().position(|part| *part != 0.0).unwrap_or(0);
    let at = |value: f64| {
        let mut place = Vector3::zeros();
        place[axis] = value;
        view.project(&place)[sheet]
    };
    // Compute the coordinate from two places that are far apart on the sheet, whatever the scale.
    let apart = 1.0 / view.scale;
    let [zero, one] = [at(0.0), at(apart)];
    let value = |place: f64| (place - zero) / (one - zero) * apart;
    let step = round_above(TICKS / view.scale);
    let ends = [value(0.0), value(length)];
    let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    let ticks = (low / step).ceil() as i64..=(high / step).floor() as i64;
    for tick in ticks {
        let value = tick as f64 * step;
        let place = at(value);
        if !(HEAD..length - FOOT).contains(&place) {
            continue;
        }
        let (line, text) = match way {
            Way::Across => (
                [[place, 0.0], [place, size[1]]],
                [place + 3.0, size[1] - 18.0],
            ),
            Way::Up => ([[0.0, place], [size[0], place]], [4.0, place - 16.0]),
        };
        texts.line(line, BLACK.mix(0.1).stroke_width(FINE))?;
        texts.write(&label(value, step), text, SMALL)?;
    }
    let name = format!("{} ({unit})", NAMES[axis]);
    let place = match way {
        Way::Across => [size[0] - 44.0, size[1] - 36.0],
        Way::Up => [4.0, 28.0],
    };
    texts.write(&name, place, FONT_SIZE)
}

const SMALL: u32 = 12;

/// Formats a value with as many decimals as its step has.
fn label(value: f64, step: f64) -> String {
    let decimals = (-step.log10().floor()).clamp(0.0, 9.0);
    fixed(value, decimals as usize)
}

/// Returns the largest of the numbers 1, 2 and 5 times a power of ten up to a number.
fn round_below(number: f64) -> f64 {
    let power = 10_f64.powf(number.log10().floor());
    let parts = [5.0, 2.0, 1.0].map(|part| part * power);
    parts
        .into_iter()
        .find(|part| *part <= number)
        .unwrap_or(power)
}

/// Returns the smallest of these numbers that is not below a number.
fn round_above(number: f64) -> f64 {
    let power = 10_f64.powf(number.log10().floor());
    let parts = [1.0, 2.0, 5.0].map(|part| part * power);
    parts
        .into_iter()
        .find(|part| *part >= number)
        .unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_numbers_below_and_above_bracket_the_number() {
        for (number, below, above) in [(0.07, 0.05, 0.1), (3.0, 2.0, 5.0), (120.0, 100.0, 200.0)] {
            assert!((round_below(number) - below).abs() < 1e-12 * below);
            assert!((round_above(number) - above).abs() < 1e-12 * above);
        }
    }

    #[test]
    fn axis_labels_have_the_decimals_of_their_step() {
        for (value, step, expected) in [
            (0.2, 0.05, "0.20"),
            (-0.0, 0.1, "0.0"),
            (250.0, 50.0, "250"),
        ] {
            assert_eq!(label(value, step), expected);
        }
    }
}
