//! The legend: the meaning of the marks that appear in a drawing, between the axes and the scale.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::axes::BESIDE;
use super::labels;
use super::marks::{self, CHASSIS, Place};
use super::{Drawing, middle, pixels};
use crate::output::svg::{Area, Drawn, FINE, FONT};

/// In pixels: the font size, the width of a mark, the distance from it to its name and to the next mark, the height of a row,
/// and the distance of the last row from the lower edge.
const FONT_SIZE: f64 = 10.0;
const MARK: f64 = 22.0;
const TO_NAME: f64 = 6.0;
const TO_NEXT: f64 = 9.0;
const ROW: f64 = 14.0;
const FOOT: f64 = 12.0;

/// A mark, by what it is drawn at.
#[derive(Clone, Copy)]
enum Mark {
    Point(fn(&Area<'_>, Place) -> Drawn),
    Line(fn(&Area<'_>, Vec<Place>, f64) -> Drawn),
    Polygon(fn(&Area<'_>, Vec<Place>, f64) -> Drawn),
    Arrow(fn(&Area<'_>, [Place; 2]) -> Drawn),
}

impl Mark {
    /// Draws it along a line, or in the middle of this.
    fn draw(self, area: &Area<'_>, line: [Place; 2]) -> Drawn {
        const OPACITY: f64 = 1.0;
        match self {
            Self::Point(mark) => mark(area, middle(line)),
            Self::Line(mark) => mark(area, line.into(), OPACITY),
            Self::Polygon(mark) => mark(area, around(line).into(), OPACITY),
            Self::Arrow(mark) => mark(area, line),
        }
    }
}

impl Drawing {
    /// Draws the legend and returns its box: left, top, right and bottom.
    pub(super) fn draw_legend(
        &self,
        area: &Area<'_>,
        (width, height): (u32, u32),
    ) -> Result<[i32; 4], Box<dyn std::error::Error>> {
        let ends = [BESIDE[0], f64::from(width) - BESIDE[1]];
        let rows = rows(self.marks(), ends[1] - ends[0]);
        let top = f64::from(height) - FOOT - ROW * rows.len() as f64;
        for (number, row) in rows.iter().enumerate() {
            let y = top + ROW * (number as f64 + 0.5);
            let mut x = ends[0];
            for (name, mark) in row {
                mark.draw(area, [pixels([x, y]), pixels([x + MARK, y])])?;
                let font = (FONT, FONT_SIZE * f64::from(FINE)).into_font();
                let style = font.color(&CHASSIS).pos(Pos::new(HPos::Left, VPos::Center));
                area.draw(&Text::new(*name, pixels([x + MARK + TO_NAME, y]), style))?;
                x += across(name);
            }
        }
        let [low, high] = [pixels([ends[0], top]), pixels([ends[1], f64::from(height)])];
        Ok([low.0, low.1, high.0, high.1])
    }

    /// Returns the marks that appear, with their meanings.
    fn marks(&self) -> Vec<(&'static str, Mark)> {
        use Mark::{Arrow, Line, Point, Polygon};
        let any_without_force = |lines: &[[usize; 2]]| self.without_force(lines).next().is_some();
        // The title of a drawing with forces has the colours of links and lengths with a force.
        let [links, lengths] = [&self.links, &self.lengths].map(|lines| any_without_force(lines));
        let [racks, bars] = [!self.racks.is_empty(), !self.bars.is_empty()];
        let [fixed, moving] = [self.chassis > 0, self.points.len() > self.chassis];
        let wheels = !self.wheels.is_empty();
        let marks = [
            (fixed, "chassis point", Point(marks::chassis_point)),
            (moving, "moving point", Point(marks::moving_point)),
            (links, "link", Line(marks::link)),
            (racks, "steering rack", Line(marks::rack)),
            (!self.slides.is_empty(), "slide", Line(marks::slide)),
            (!self.bodies.is_empty(), "body", Polygon(marks::body)),
            (lengths, "measured or driven length", Line(marks::length)),
            (bars, "bar or measured angle", Line(marks::bar)),
            (wheels, "kingpin or spin axis", Line(marks::axis)),
            (!self.arrows().is_empty(), "load", Arrow(marks::load)),
        ];
        let appear = marks.into_iter().filter(|(appears, ..)| *appears);
        appear.map(|(_, name, mark)| (name, mark)).collect()
    }
}

/// Puts marks into rows of at most a width.
fn rows(marks: Vec<(&'static str, Mark)>, width: f64) -> Vec<Vec<(&'static str, Mark)>> {
    let mut rows: Vec<Vec<_>> = Vec::new();
    let mut used = 0.0;
    for mark in marks {
        let across = across(mark.0);
        match rows.last_mut() {
            Some(row) if used + across <= width => row.push(mark),
            _ => {
                rows.push(vec![mark]);
                used = 0.0;
            }
        }
        used += across;
    }
    rows
}

/// Returns the width of a mark with its name.
fn across(name: &str) -> f64 {
    MARK + TO_NAME + labels::width(name, FONT_SIZE) + TO_NEXT
}

/// Returns the corners of a box about a line.
fn around([from, to]: [Place; 2]) -> [Place; 4] {
    let half = (ROW / 3.0 * f64::from(FINE)) as i32;
    [
        (from.0, from.1 - half),
        (to.0, to.1 - half),
        (to.0, to.1 + half),
        (from.0, from.1 + half),
    ]
}
