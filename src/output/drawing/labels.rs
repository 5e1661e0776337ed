//! The placement of names beside their points.

mod places;
#[cfg(test)]
mod tests;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::FONT_SIZE;
use crate::output::svg::{Area, Drawn, FINE, FONT};
use places::{common, inside, places_around};

/// A placed name: the corner or the middle of its box nearest to its point, so that the name stays beside the point for any
/// font width; and the end of the line from the point to a name that is farther away.
#[derive(Clone, Copy)]
pub(super) struct Boxed {
    at: (i32, i32),
    anchor: HPos,
    leader: Option<(i32, i32)>,
    /// The place of the name: left, top, right and bottom.
    place: [i32; 4],
    point: (i32, i32),
}

impl Boxed {
    fn leader(&self) -> Option<Segment> {
        self.leader.map(|end| [self.point, end])
    }
}

/// The ends of a line on the sheet.
pub(super) type Segment = [(i32, i32); 2];

/// The placed names, and the boxes and lines that they must avoid, the outside of the sheet included.
pub(super) struct Labels {
    points: Vec<(i32, i32)>,
    names: Vec<Boxed>,
    taken: Vec<[i32; 4]>,
    sides: [[i32; 4]; 4],
    lines: Vec<Segment>,
    unit: i32,
    /// The font size in pixels.
    font_size: u32,
}

/// The font size with many points, in pixels, and the number of pixels of the sheet for each point below which it is used.
const SMALL: u32 = 10;
const ROOM: u32 = 24_000;
/// How often all names are placed again, each beside all others.
const ROUNDS: usize = 3;
/// The widths of a small letter and of a digit or capital, and the height of a line, as parts of the font size.
const LETTER: f64 = 0.5;
const DIGIT: f64 = 0.65;
const LINE: f64 = 8.0 / 7.0;
/// The distances between a point and its name, in order of preference.
const GAPS: [i32; 4] = [9, 22, 40, 62];
/// The penalties of a line of length one through a name, and of each farther distance, relative to the overlap with another
/// name.
const STRUCK: f64 = 12.0;
const AWAY: f64 = 90.0;
/// A name at the least distance from its point has no leader: the distance in pixels within which no other point may be, and the
/// penalty if one is.
const ALONE: f64 = 15.0;
const DOUBTFUL: f64 = 150.0;
/// The weight of an area outside the sheet, relative to an overlap.
const CUT: f64 = 20.0;

impl Labels {
    /// Starts the placement beside points on a sheet of a size in pixels; `unit` is the number of drawing units per pixel.
    pub(super) fn new(
        points: &[(i32, i32)],
        lines: Vec<Segment>,
        (width, height): (u32, u32),
        unit: i32,
    ) -> Self {
        let is_crowded = points.len() > (width * height / ROOM) as usize;
        let [width, height] = [width, height].map(|size| size as i32 * unit);
        let sides = [
            [-width, -height, 0, 2 * height],
            [width, -height, 2 * width, 2 * height],
            [0, -height, width, 0],
            [0, height, width, 2 * height],
        ];
        let half = 6 * unit;
        let around = |&(x, y): &(i32, i32)| [x - half, y - half, x + half, y + half];
        Self {
            points: points.to_vec(),
            names: Vec::new(),
            taken: points.iter().map(around).collect(),
            sides,
            lines,
            unit,
            font_size: if is_crowded { SMALL } else { FONT_SIZE },
        }
    }

    /// Keeps a box free of names.
    pub(super) fn avoid(&mut self, place: [i32; 4]) {
        self.taken.push(place);
    }

    /// Returns the font size in drawing units.
    pub(super) fn font_size(&self) -> i32 {
        self.font_size as i32 * self.unit
    }

    /// Finds places for names beside their points: each is moved again when all are placed.
    pub(super) fn put_all(&mut self, names: &[(String, (i32, i32))]) -> Vec<Boxed> {
        let first = self.names.len();
        for (name, point) in names {
            self.put(name, *point);
        }
        for _ in 0..ROUNDS {
            for (index, (name, point)) in names.iter().enumerate() {
                let best = self.best(name, *point, Some(first + index));
                self.names[first + index] = best;
            }
        }
        self.names[first..].to_vec()
    }

    /// Finds a place for a name beside its point, which it keeps.
    pub(super) fn put(&mut self, name: &str, point: (i32, i32)) -> Boxed {
        let best = self.best(name, point, None);
        self.names.push(best);
        best
    }

    /// Returns the first place with the smallest penalty for a name beside its point; `own` is the index of its present one.
    fn best(&self, name: &str, (x, y): (i32, i32), own: Option<usize>) -> Boxed {
        let size = f64::from(self.font_size());
        let width = width(name, size) as i32;
        let height = (LINE * size) as i32;
        let around = |away: usize| places_around((x, y), [width, height], GAPS[away], self.unit);
        let mut best = (f64::INFINITY, 0, (HPos::Left, [x, y, x, y]));
        for away in 0..GAPS.len() {
            // No place farther away costs less than its distance.
            if best.0 <= AWAY * away as f64 {
                break;
            }
            for place in around(away) {
                let cost = self.cost(&place.1, away, (x, y), own);
                if cost < best.0 {
                    best = (cost, away, place);
                }
            }
        }
        let (_, away, (anchor, place)) = best;
        let [left, top, right, bottom] = place;
        let across = match anchor {
            HPos::Left => left,
            HPos::Right => right,
            HPos::Center => x,
        };
        Boxed {
            at: (across, top),
            anchor,
            leader: (away > 0).then(|| (x.clamp(left, right), y.clamp(top, bottom))),
            place,
            point: (x, y),
        }
    }

    /// Returns the penalty of a place at a distance from its point; `own` is the index of the name's present place.
    fn cost(&self, place: &[i32; 4], away: usize, point: (i32, i32), own: Option<usize>) -> f64 {
        let names = self.names.iter().enumerate();
        let others = names.filter_map(|(index, name)| (Some(index) != own).then_some(name));
        let doubt = match (self.is_beside_another(place, point), away) {
            (false, _) => 0.0,
            (true, 0) => DOUBTFUL,
            // A leader says whose name it is.
            (true, _) => AWAY / 2.0,
        };
        self.collisions(place, others) + AWAY * away as f64 + doubt
    }

    /// Draws a text where it was put, with a leader from its point where it is farther away; the colours are those of leader
    /// and text.
    pub(super) fn draw(
        &self,
        area: &Area<'_>,
        text: &str,
        boxed: &Boxed,
        [leader_colour, colour]: [RGBColor; 2],
    ) -> Drawn {
        if let Some(leader) = boxed.leader() {
            let stroke = leader_colour.mix(0.5).stroke_width(FINE);
            area.draw(&PathElement::new(leader, stroke))?;
        }
        let font = (FONT, self.font_size()).into_font();
        let style = font.color(&colour).pos(Pos::new(boxed.anchor, VPos::Top));
        area.draw(&Text::new(text, boxed.at, style))?;
        Ok(())
    }

    /// Whether a place is so near to another point than its own that it could be the name of either.
    fn is_beside_another(&self, [left, top, right, bottom]: &[i32; 4], own: (i32, i32)) -> bool {
        let mut others = self.points.iter().filter(|point| **point != own);
        others.any(|&(x, y)| {
            let off = [x - x.clamp(*left, *right), y - y.clamp(*top, *bottom)];
            let [across, along] = off.map(f64::from);
            across.hypot(along) < ALONE * f64::from(self.unit)
        })
    }

    /// Returns the penalty of a place among other names, in pixels.
    fn collisions<'a>(&self, place: &[i32; 4], others: impl Iterator<Item = &'a Boxed>) -> f64 {
        let unit = f64::from(self.unit);
        let overlap = |other: &[i32; 4]| common(place, other) as f64 / (unit * unit);
        let struck = |line: &Segment| STRUCK * inside(line, place) / unit;
        let of_name = |name: &Boxed| {
            let leader = name.leader();
            overlap(&name.place) + leader.as_ref().map_or(0.0, struck)
        };
        others.map(of_name).sum::<f64>()
            + self.taken.iter().map(overlap).sum::<f64>()
            + self.sides.iter().map(overlap).sum::<f64>() * CUT
            + self.lines.iter().map(struck).sum::<f64>()
    }
}

/// Returns the width of a text in a font of a size, about that of usual fonts.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let is_wide = |letter: char| letter.is_ascii_digit() || letter.is_uppercase();
    let widths = text
        .chars()
        .map(|letter| if is_wide(letter) { DIGIT } else { LETTER });
    size * widths.sum::<f64>()
}
