//! What the places of a table are counted along.

use super::columns::KnownColumn;
use super::smoothing::smoothed;
use crate::measured_table::MeasuredTable;
use crate::mechanism::{Description, ends, evenly_spaced, listed};
use crate::number::number;

/// The way of the model through the places of a table.
pub(super) struct Course {
    /// What places are counted along: that of a column, or the lines of the table.
    pub(super) title: String,
    /// The columns that change about as far as any, as those of travel of both wheels in roll.
    pub(super) wide: String,
    /// The same as the title with what is counted, and its unit.
    pub(super) label: String,
    /// Where each measured place is along it.
    pub(super) at: Vec<f64>,
    /// How far along it the places around one tell of its noise; zero for lines of the table, whose neighbours may be elsewhere.
    pub(super) around: f64,
    /// The distance of each from the design position, with the sign of its number in the axis column.
    pub(super) from_design: Vec<f64>,
    /// How many lines of the table are between those that charts show.
    pub(super) stride: usize,
    /// The places of the model's curve, each with the numbers of all columns that lead.
    pub(super) curve: Vec<(f64, Vec<f64>)>,
}

/// Returns the columns that change, or else the first one.
fn moving(leads: &[KnownColumn]) -> Vec<&KnownColumn> {
    let moving: Vec<&KnownColumn> = leads.iter().filter(|lead| lead.changes()).collect();
    match moving[..] {
        [] => leads.iter().take(1).collect(),
        _ => moving,
    }
}

/// Says which columns take the model away from the design position, and where, if these are several.
pub(super) fn followed(leads: &[KnownColumn]) -> Option<String> {
    let away = leads.iter().filter(|lead| lead.departs());
    let each = away.map(|lead| {
        let title = &lead.stated.named.title;
        let [least, greatest] = ends(lead.numbers.iter().copied()).unwrap_or_default();
        let symbol = &lead.stated.symbol;
        match lead.changes() {
            true => format!(
                "{title} ({} to {} {symbol})",
                number(least),
                number(greatest)
            ),
            false => format!("{title} ({} {symbol})", number(least)),
        }
    });
    let each: Vec<String> = each.collect();
    (each.len() > 1).then(|| format!("A follows {} of B in each line", listed(each)))
}

impl Course {
    /// Returns the course of a table with numbers, whose columns `leads` say where the model is.
    pub(super) fn new(
        table: &MeasuredTable,
        mechanism: &Description,
        leads: &[KnownColumn],
    ) -> Self {
        let moving = moving(leads);
        let shares: Vec<Vec<f64>> = moving.iter().map(|lead| lead.shares(mechanism)).collect();
        let from_design = from_design(&shares);
        let axis = widest(&shares);
        let wide = are_wide(&shares).into_iter().zip(&moving);
        let wide = wide.filter(|(is_wide, _)| *is_wide);
        let wide = listed(wide.map(|(_, lead)| lead.stated.named.title.clone()));
        let stride = table.lines().div_ceil(MOST_DRAWN).max(1);
        if is_ambiguous(&shares, axis) {
            let at: Vec<f64> = (0..table.lines())
                .map(|line| table.line_in_file(line) as f64)
                .collect();
            let places = at.iter().copied().enumerate().step_by(stride);
            return Self {
                title: "the lines of the table".to_owned(),
                label: "line of the table".to_owned(),
                curve: places
                    .map(|(line, at)| (at, numbers(leads, line)))
                    .collect(),
                at,
                around: 0.0,
                wide,
                stride,
                from_design,
            };
        }
        let axis = moving[axis];
        let around = AROUND * span(&axis.numbers);
        Self {
            title: axis.stated.named.title.clone(),
            label: axis.label(),
            at: axis.numbers.clone(),
            around,
            wide,
            stride,
            from_design,
            curve: curve(leads, axis, around),
        }
    }
}

/// Returns the numbers of the columns that lead in a line.
pub(super) fn numbers(leads: &[KnownColumn], line: usize) -> Vec<f64> {
    leads.iter().map(|lead| lead.numbers[line]).collect()
}

fn span(shares: &[f64]) -> f64 {
    ends(shares.iter().copied()).map_or(0.0, |[least, greatest]| greatest - least)
}

/// The most measured places that a chart shows: more are no clearer, and make the page slow.
const MOST_DRAWN: usize = 2000;

/// The part of the range whose places tell of the noise of one.
const AROUND: f64 = 0.05;

/// How much more than the axis another column may change.
const STEEPEST: f64 = 2.0;

/// Returns which columns change about as far as any.
fn are_wide(shares: &[Vec<f64>]) -> Vec<bool> {
    let spans = shares.iter().map(|column| span(column));
    let widest = spans.clone().fold(0.0, f64::max);
    spans.map(|span| STEEPEST * span >= widest).collect()
}

/// Returns the first column that changes about as far as any.
fn widest(shares: &[Vec<f64>]) -> usize {
    let is_wide = are_wide(shares).into_iter();
    is_wide.take_while(|is_wide| !is_wide).count()
}

/// Returns whether places near each other on the axis are apart in another column, as on a grid of bump and steering.
fn is_ambiguous(shares: &[Vec<f64>], axis: usize) -> bool {
    /// What noise and the way back of a rig may make, as a part of the range.
    const NOISE: f64 = 0.1;
    let mut lines: Vec<usize> = (0..shares[axis].len()).collect();
    lines.sort_by(|a, b| shares[axis][*a].total_cmp(&shares[axis][*b]));
    let noise = NOISE * span(&shares[axis]);
    lines.windows(2).any(|pair| {
        let step = |column: &Vec<f64>| (column[pair[1]] - column[pair[0]]).abs();
        let most = STEEPEST * step(&shares[axis]) + noise;
        shares.iter().any(|column| step(column) > most)
    })
}

fn from_design(shares: &[Vec<f64>]) -> Vec<f64> {
    let axis = &shares[widest(shares)];
    let of_line = |(line, at): (usize, &f64)| {
        let squares: f64 = shares.iter().map(|column| column[line].powi(2)).sum();
        squares.sqrt().copysign(*at)
    };
    axis.iter().enumerate().map(of_line).collect()
}

/// Returns places evenly spaced along the axis, with the other columns as in the lines around them, at least in the two beside.
fn curve(leads: &[KnownColumn], axis: &KnownColumn, around: f64) -> Vec<(f64, Vec<f64>)> {
    /// The number of places along the model's curves.
    const ALONG: usize = 61;
    let mut sorted = axis.numbers.clone();
    sorted.sort_by(f64::total_cmp);
    let gap = |at: f64| {
        let above = sorted.partition_point(|place| *place <= at);
        let above = above.min(sorted.len() - 1);
        sorted[above] - sorted[above.saturating_sub(1)]
    };
    let place = |at: f64| {
        let reach = around.max(gap(at));
        let smooth = |lead: &KnownColumn| {
            let numbers = axis.numbers.iter().zip(&lead.numbers);
            smoothed(numbers.map(|(at, number)| (*at, *number)), at, reach)
        };
        (at, leads.iter().map(smooth).collect())
    };
    let [from, to] = ends(axis.numbers.iter().copied()).unwrap_or_default();
    let count = if from < to { ALONG } else { 1 };
    evenly_spaced([from, to], count)
        .into_iter()
        .map(place)
        .collect()
}
