//! The places of a grid of drives.

pub(super) mod place;
pub(super) mod visited;
mod visitor;

use crate::file::Dimension;
use crate::mechanism::description::Description;
use crate::number::unsigned_zero;

/// The largest number of places of a grid.
pub const MOST_PLACES: usize = 1_000_000;

/// Drives and the values that they take, in local coordinates.
#[derive(Clone, Debug, Default)]
pub struct Grid {
    /// The places along each axis; the last changes fastest.
    pub(super) axes: Vec<Vec<AxisPlace>>,
    /// All drives at the start of the mechanism.
    pub(super) start: Vec<f64>,
}

/// The drives that an axis moves, by number, with their values at one of its places.
pub(super) type AxisPlace = Vec<(usize, f64)>;

/// The places of an axis above the drives' values, by number, and those below, each in the order away from them.
pub(super) fn outwards(axis: &[AxisPlace], drives: &[f64]) -> [Vec<usize>; 2] {
    // The drives of an axis move together, so the first tells the direction.
    let above_here = |index: &usize| {
        let first = axis[*index].first();
        first.map_or(0.0, |(drive, value)| value - drives[*drive])
    };
    let mut order: Vec<usize> = (0..axis.len()).collect();
    order.sort_by(|a, b| above_here(a).total_cmp(&above_here(b)));
    let is_below = |index: &usize| above_here(index) < 0.0;
    let (mut below, above): (Vec<usize>, Vec<usize>) = order.into_iter().partition(is_below);
    below.reverse();
    [above, below]
}

/// An axis of a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct GridAxis {
    /// The drives that move together, by number, each with its change per unit along the axis.
    pub drives: Vec<(usize, f64)>,
    /// The values along the axis.
    pub values: Vec<f64>,
}

impl GridAxis {
    /// An axis of one drive.
    pub fn for_drive(drive: usize, values: Vec<f64>) -> Self {
        Self {
            drives: vec![(drive, 1.0)],
            values,
        }
    }

    /// The axis of the drives in `words`, beside other axes, with `values` in the file's unit. Drives joined by commas move
    /// together, one with a minus the opposite way: `left_bump,-right_bump` is roll.
    ///
    /// # Errors
    ///
    /// A sentence about a name that is not a drive, about a drive that is already there, and about a length and an angle.
    pub fn named(
        mechanism: &Description,
        words: &str,
        values: &[f64],
        others: &[Self],
    ) -> Result<Self, String> {
        let mut drives = Vec::new();
        for (name, part) in moved_together(words) {
            let drive = mechanism.names.chosen_drive(Some(name))?;
            let mut given = others.iter().flat_map(|axis| &axis.drives).chain(&drives);
            if given.any(|(other, _)| *other == drive) {
                return Err(format!("the drive `{name}` is given twice"));
            }
            drives.push((drive, part));
        }
        check_kinds(mechanism, &drives)?;
        let first = drives.first();
        let scale = first.map_or(1.0, |(drive, _)| {
            let kind = mechanism.names.drives[*drive].kind;
            Dimension::from(kind).file_factor(mechanism.unit)
        });
        Ok(Self {
            drives,
            values: values.iter().map(|value| value / scale).collect(),
        })
    }

    /// The drives in words, as [`named`](Self::named) takes them.
    pub fn drives_in_words(&self, mechanism: &Description) -> String {
        let each = self.drives.iter().map(|(drive, part)| {
            let minus = if *part < 0.0 { "-" } else { "" };
            format!("{minus}{}", mechanism.names.drives[*drive].name)
        });
        each.collect::<Vec<_>>().join(",")
    }
}

/// The names that commas join, each with the sign of its change: -1 behind a minus, otherwise 1.
pub fn moved_together(words: &str) -> impl Iterator<Item = (&str, f64)> {
    let names = words.split(',').map(str::trim);
    names.map(|name| match name.strip_prefix('-') {
        Some(name) => (name.trim(), -1.0),
        None => (name, 1.0),
    })
}

/// Refuses a length and an angle that move together: no number is in the units of both.
fn check_kinds(mechanism: &Description, drives: &[(usize, f64)]) -> Result<(), String> {
    let drives = drives
        .iter()
        .map(|(drive, _)| &mechanism.names.drives[*drive]);
    let (angles, lengths): (Vec<_>, Vec<_>) = drives.partition(|drive| drive.kind.is_angle());
    match (lengths.first(), angles.first()) {
        (Some(length), Some(angle)) => Err(format!(
            "the drive `{}` is a length and `{}` an angle, so that they cannot move by the same number; state each by itself",
            length.name, angle.name
        )),
        _ => Ok(()),
    }
}

/// `count` values, evenly spaced from the first to the last: exact at both ends. Those between are rounded to 15 digits of the
/// larger end, so that a place is 0.003 or 0 where spacing alone gives 0.0030000000000000005 or 3e-17.
pub fn evenly_spaced([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    /// The decimals of the smallest number.
    const MOST: f64 = 340.0;
    let last = count.saturating_sub(1).max(1);
    let decimals = 14.0 - from.abs().max(to.abs()).log10().floor();
    let decimals = decimals.clamp(0.0, MOST) as usize;
    let value = |index: usize| match index {
        0 => from,
        _ if index == last => to,
        _ => {
            let part = index as f64 / last as f64;
            let value = from * (1.0 - part) + to * part;
            let rounded = format!("{value:.decimals$}").parse().unwrap_or(value);
            unsigned_zero(rounded)
        }
    };
    (0..count).map(value).collect()
}

/// The origin from which the values of a grid are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CountedFrom {
    /// The value of each drive at the mechanism's start.
    Start,
    /// The drive's own zero.
    Zero,
}

impl Grid {
    /// The grid of a mechanism.
    ///
    /// # Errors
    ///
    /// A sentence, if there are too many places.
    pub fn new(
        mechanism: &Description,
        axes: Vec<GridAxis>,
        from: CountedFrom,
    ) -> Result<Self, String> {
        let start = mechanism.first_drives();
        let from = |drive: usize| match from {
            CountedFrom::Start => start[drive],
            CountedFrom::Zero => -mechanism.drive_offsets[drive],
        };
        let places = |GridAxis { drives, values }: GridAxis| -> Vec<AxisPlace> {
            let place = |value: f64| {
                let moved = drives.iter();
                moved
                    .map(|(drive, part)| (*drive, from(*drive) + part * value))
                    .collect()
            };
            values.into_iter().map(place).collect()
        };
        let axes = axes.into_iter().map(places).collect();
        let grid = Self { axes, start };
        match grid.places() {
            Some(1..=MOST_PLACES) => Ok(grid),
            _ => Err(format!(
                "a grid may have {MOST_PLACES} places at most; take fewer values"
            )),
        }
    }

    /// The number of places; `None` if there are too many to count.
    pub fn places(&self) -> Option<usize> {
        let mut counts = self.axes.iter().map(Vec::len);
        counts.try_fold(1_usize, usize::checked_mul)
    }

    pub(crate) fn drives_at(&self, place: usize) -> Vec<f64> {
        let mut drives = self.start.clone();
        for (axis, at) in self.axes.iter().zip(self.axis_positions(place)) {
            for (drive, value) in &axis[at.number] {
                drives[*drive] = *value;
            }
        }
        drives
    }

    /// The places beside a place, along each axis.
    pub(super) fn neighbours(&self, place: usize) -> impl Iterator<Item = usize> {
        let along = self.axis_positions(place).into_iter();
        along.flat_map(move |at| {
            let below = (at.number > 0).then(|| place - at.stride);
            let above = (at.number + 1 < at.count).then(|| place + at.stride);
            below.into_iter().chain(above)
        })
    }

    /// The position of a place along each axis.
    fn axis_positions(&self, place: usize) -> Vec<At> {
        let mut stride = 1;
        let mut along: Vec<At> = Vec::new();
        for axis in self.axes.iter().rev() {
            let count = axis.len();
            let number = place / stride % count;
            along.push(At {
                number,
                count,
                stride,
            });
            stride *= count;
        }
        along.reverse();
        along
    }
}

/// The position of a place along an axis.
struct At {
    number: usize,
    /// The number of places on the axis.
    count: usize,
    /// The difference in number of places that are neighbours along the axis.
    stride: usize,
}
