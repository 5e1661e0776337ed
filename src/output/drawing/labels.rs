//! The placement of names beside their points.

#[cfg(test)]
mod tests;

use plotters::style::text_anchor::HPos;

use super::FONT_SIZE;

/// A placed name: the corner or the middle of its box nearest to its point, so that the name stays beside the point for any
/// font width; and the end of the line from the point to a name that is farther away.
pub(super) struct Boxed {
    pub(super) at: (i32, i32),
    pub(super) anchor: HPos,
    pub(super) leader: Option<(i32, i32)>,
}

/// The ends of a line on the sheet.
pub(super) type Segment = [(i32, i32); 2];

/// The placed names, and the boxes and lines that they must avoid, the outside of the sheet included.
pub(super) struct Labels {
    points: Vec<(i32, i32)>,
    taken: Vec<[i32; 4]>,
    sides: [[i32; 4]; 4],
    lines: Vec<Segment>,
    unit: i32,
    /// The font size in pixels.
    font_size: u32,
}

/// The font size with many points, in pixels.
const SMALL: u32 = 10;
const MANY: usize = 24;
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
            taken: points.iter().map(around).collect(),
            sides,
            lines,
            unit,
            font_size: if points.len() > MANY {
                SMALL
            } else {
                FONT_SIZE
            },
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

    /// Finds a place for a name beside its point: the first one with the smallest penalty.
    pub(super) fn put(&mut self, name: &str, (x, y): (i32, i32)) -> Boxed {
        let unit = self.unit;
        let size = f64::from(self.font_size());
        let width = width(name, size) as i32;
        let height = (LINE * size) as i32;
        let around = |away: usize| {
            let gap = GAPS[away] * unit;
            let columns = [x + gap, x - gap - width, x - width / 2];
            let rows = [y - height / 2, y - gap - height, y + gap];
            let places = [
                (0, 0),
                (1, 0),
                (0, 1),
                (0, 2),
                (1, 1),
                (1, 2),
                (2, 1),
                (2, 2),
            ];
            places.map(|(column, row): (usize, usize)| {
                let (left, top) = (columns[column], rows[row]);
                (away, column, [left, top, left + width, top + height])
            })
        };
        let places = (0..GAPS.len()).flat_map(around);
        let cost = |(away, _, place): &(usize, usize, [i32; 4])| {
            let doubt = match (self.is_beside_another(place, (x, y)), away) {
                (false, _) => 0.0,
                (true, 0) => DOUBTFUL,
                // A leader says whose name it is.
                (true, _) => AWAY / 2.0,
            };
            self.collisions(place) + AWAY * *away as f64 + doubt
        };
        let best = places.min_by(|a, b| cost(a).total_cmp(&cost(b)));
        let (away, column, place) = best.unwrap_or((0, 0, [x, y, x, y]));
        self.taken.push(place);
        let [left, top, right, bottom] = place;
        let leader = (away > 0).then(|| (x.clamp(left, right), y.clamp(top, bottom)));
        self.lines.extend(leader.map(|end| [(x, y), end]));
        let (anchor, across) = match column {
            0 => (HPos::Left, left),
            1 => (HPos::Right, right),
            _ => (HPos::Center, x),
        };
        Boxed {
            at: (across, top),
            anchor,
            leader,
        }
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

    /// Returns the penalty of a place, in pixels.
    fn collisions(&self, place: &[i32; 4]) -> f64 {
        let unit = f64::from(self.unit);
        let overlap = |other: &[i32; 4]| common(place, other) as f64 / (unit * unit);
        let struck = |line: &Segment| STRUCK * inside(line, place) / unit;
        self.taken.iter().map(overlap).sum::<f64>()
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

/// Returns the area that two boxes have in common.
fn common(a: &[i32; 4], b: &[i32; 4]) -> i64 {
    let along =
        |low: usize, high: usize| i64::from((a[high].min(b[high]) - a[low].max(b[low])).max(0));
    along(0, 2) * along(1, 3)
}

/// Returns the length of a line within a box (Liang and Barsky 1984).
fn inside([from, to]: &Segment, [left, top, right, bottom]: &[i32; 4]) -> f64 {
    let [dx, dy] = [to.0 - from.0, to.1 - from.1].map(f64::from);
    let sides = [
        (-dx, from.0 - left),
        (dx, right - from.0),
        (-dy, from.1 - top),
        (dy, bottom - from.1),
    ];
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for (outwards, room) in sides {
        let room = f64::from(room);
        if outwards < 0.0 {
            enters = enters.max(room / outwards);
        } else if outwards > 0.0 {
            leaves = leaves.min(room / outwards);
        } else if room < 0.0 {
            return 0.0;
        }
    }
    (leaves - enters).max(0.0) * dx.hypot(dy)
}
