//! The map: one line per method, one column per axis, and in each cell the shares of outcomes.

use maud::{Markup, html};

use super::rows::{Axis, Row};
use crate::chart::axis::power;
use crate::chart::figure::tenth;
use crate::chart::style::INK;
use suspension::number::rounded;

/// Width of a map.
pub const WIDTH: f64 = 800.0;
const LEFT: f64 = 150.0;
const COLUMN: f64 = 200.0;
const GAP: f64 = 16.0;
const TOP: f64 = 58.0;
const LINE: f64 = 32.0;
const BAR: f64 = 26.0;
const BELOW: f64 = 46.0;

/// Shares from the bottom of a cell upwards, in colours for colour-blind readers.
const SHARES: [(&str, &str); 3] = [
    ("right", "#56b4e9"),
    ("no root, and it says so", "#dddddd"),
    ("wrong, given out as a result", "#d55e00"),
];

/// A method with a closure: a line of the map.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// The method.
    pub method: String,
    /// The formulation of bodies.
    pub closure: String,
}

impl Line {
    /// Returns the line of a row.
    pub fn of(row: &Row) -> Self {
        Self {
            method: row.method.clone(),
            closure: row.closure.clone(),
        }
    }
}

/// Returns the height of a map with this number of lines.
pub fn height(lines: usize) -> f64 {
    TOP + LINE * lines as f64 + BELOW
}

/// Returns the map of some lines, from rows of one number type, as a group of SVG elements.
pub fn draw(title: &str, lines: &[Line], rows: &[&Row]) -> Markup {
    let bottom = TOP + LINE * lines.len() as f64;
    html! {
        g font-size="12" fill=(INK) {
            text x="12" y="20" font-size="15" font-weight="bold" { (title) }
            (legend())
            @for (index, line) in lines.iter().enumerate() {
                @let y = TOP + LINE * index as f64;
                text x="12" y=(y + 13.0) { (line.method) }
                text x="12" y=(y + 25.0) font-size="10" fill="#666666" { (line.closure) }
            }
            @for (index, axis) in Axis::ALL.into_iter().enumerate() {
                @let of_axis: Vec<&Row> = rows.iter().copied().filter(|row| row.axis == axis).collect();
                @let column = Column::new(axis, &of_axis, LEFT + (COLUMN + GAP) * index as f64);
                @for (index, line) in lines.iter().enumerate() {
                    (column.cell(line, &of_axis, TOP + LINE * index as f64))
                }
                (column.scale(bottom))
            }
        }
    }
}

fn legend() -> Markup {
    html! {
        @for ((name, colour), x) in SHARES.into_iter().zip([LEFT, LEFT + 70.0, LEFT + 240.0]) {
            rect x=(x) y="32" width="12" height="12" fill=(colour) {}
            text x=(x + 17.0) y="42" { (name) }
        }
    }
}

/// A logarithmic axis whose difficulty grows to the right.
struct Column {
    axis: Axis,
    /// The table's unit.
    unit: String,
    left: f64,
    /// Exponents of ten at the left end and at the right end.
    ends: [f64; 2],
    /// The points, from the left, each with the exponents between which its bar is drawn.
    bars: Vec<(f64, [f64; 2])>,
}

impl Column {
    fn new(axis: Axis, rows: &[&Row], left: f64) -> Self {
        let mut values: Vec<f64> = rows.iter().map(|row| row.value).collect();
        values.sort_unstable_by(f64::total_cmp);
        values.dedup();
        if axis == Axis::TurningPoint {
            values.reverse();
        }
        let exponents: Vec<f64> = values.iter().map(|value| value.log10()).collect();
        let bars = between(&exponents);
        let first = bars.first().map_or(0.0, |ends| ends[0]);
        let last = bars.last().map_or(1.0, |ends| ends[1]);
        Self {
            axis,
            unit: rows
                .first()
                .map_or_else(String::new, |row| row.unit.clone()),
            left,
            ends: [first, last],
            bars: values.into_iter().zip(bars).collect(),
        }
    }

    fn place(&self, exponent: f64) -> f64 {
        let [first, last] = self.ends;
        self.left + (exponent - first) / (last - first) * COLUMN
    }

    fn cell(&self, line: &Line, rows: &[&Row], top: f64) -> Markup {
        let own: Vec<&Row> = rows
            .iter()
            .copied()
            .filter(|row| Line::of(row) == *line)
            .collect();
        html! {
            @if own.is_empty() && !rows.is_empty() {
                text x=(self.left + COLUMN / 2.0) y=(top + 17.0) text-anchor="middle" font-size="10" fill="#888888" {
                    "takes no guesses"
                }
            }
            @for (value, ends) in &self.bars {
                @for row in own.iter().filter(|row| row.value == *value) {
                    (self.bar(row, ends.map(|end| self.place(end)), top))
                }
            }
        }
    }

    fn bar(&self, row: &Row, [left, right]: [f64; 2], top: f64) -> Markup {
        let counts = [row.right, row.no_root, row.wrong_branch];
        let mut above = top + BAR;
        let parts = counts.map(|count| {
            let height = BAR * count as f64 / row.trials.max(1) as f64;
            above -= height;
            (above, height)
        });
        let drawn = parts.into_iter().zip(SHARES);
        html! {
            g {
                title { (self.details(row)) }
                @for ((above, height), (_, colour)) in drawn.filter(|((_, height), _)| *height > 0.0) {
                    rect x=(tenth(left)) y=(tenth(above)) width=(tenth(right - left - 0.6)) height=(tenth(height)) fill=(colour) {}
                }
            }
        }
    }

    fn details(&self, row: &Row) -> String {
        let (unit, exponent) = self.scale_unit();
        let value = format!("{} {unit}", rounded(row.value * 10_f64.powi(exponent), 3));
        let residual = rounded(row.residual_m, 2);
        format!(
            "{}, {}, {}\n{} {value}\nright {} of {}, wrong {} (mirrored {}), no root {}\nlargest residual {residual} m",
            row.method,
            row.closure,
            row.scalar,
            self.axis.in_words(),
            row.right,
            row.trials,
            row.wrong_branch,
            row.mirrored,
            row.no_root
        )
    }

    fn scale(&self, bottom: f64) -> Markup {
        let [low, high] = [
            self.ends[0].min(self.ends[1]),
            self.ends[0].max(self.ends[1]),
        ];
        let apart = if high - low > 6.0 { 3 } else { 1 };
        let decades =
            (low.ceil() as i32..=high.floor() as i32).filter(|d| d.rem_euclid(apart) == 0);
        html! {
            @if !self.bars.is_empty() {
                line x1=(self.left) x2=(self.left + COLUMN) y1=(bottom) y2=(bottom) stroke=(INK) {}
                @for decade in decades {
                    @let x = tenth(self.place(f64::from(decade)));
                    line x1=(x) x2=(x) y1=(bottom) y2=(bottom + 4.0) stroke=(INK) {}
                    text x=(x) y=(bottom + 16.0) text-anchor="middle" font-size="11" { (self.tick(decade)) }
                }
                text x=(self.left + COLUMN / 2.0) y=(bottom + 34.0) text-anchor="middle" {
                    (self.axis.in_words()) ", " (self.scale_unit().0)
                }
            }
        }
    }

    /// The unit of the scale, a power of ten of the table's.
    fn scale_unit(&self) -> (String, i32) {
        match self.axis {
            Axis::TurningPoint => (self.unit.clone(), 0),
            _ => (format!("m{}", self.unit), 3),
        }
    }

    fn tick(&self, decade: i32) -> String {
        match self.axis {
            Axis::TurningPoint => power(decade),
            _ => rounded(10_f64.powi(decade + self.scale_unit().1), 4),
        }
    }
}

/// Intervals around points, which meet half-way between neighbours.
fn between(points: &[f64]) -> Vec<[f64; 2]> {
    let half = |index: usize| -> f64 {
        let pair = points.get(index..index + 2);
        pair.map_or(0.25, |pair| (pair[1] - pair[0]) / 2.0)
    };
    let count = points.len();
    (0..count)
        .map(|index| {
            let before = half(index.saturating_sub(1));
            let after = half(index.min(count.saturating_sub(2)));
            [points[index] - before, points[index] + after]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::between;

    #[test]
    fn bars_of_the_failure_map_meet_half_way_between_values() {
        let expected = [[-3.5, -2.5], [-2.5, -1.5], [-1.5, -0.5]];
        assert_eq!(between(&[-3.0, -2.0, -1.0]), expected);
        assert_eq!(between(&[-3.0]), [[-3.25, -2.75]]);
        assert!(between(&[]).is_empty());
    }
}
