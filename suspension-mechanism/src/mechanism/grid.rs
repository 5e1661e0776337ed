//! The places of a grid of drives.

pub(super) mod axis;
pub(super) mod place;
pub(super) mod visited;
mod visitor;

use crate::mechanism::description::Description;
use crate::mechanism::grid::axis::GridAxis;
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
    /// The drives' own zeros, if values are counted from these; otherwise they are changes from the start.
    zeros: Option<Vec<f64>>,
}

/// The drives that an axis moves, by number, with what it adds to them at one of its places.
pub(super) type AxisPlace = Vec<(usize, f64)>;

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
        let offsets = mechanism.drive_offsets.iter();
        let places = |GridAxis { drives, values }: GridAxis| -> Vec<AxisPlace> {
            let place = |value: f64| {
                let moved = drives.iter();
                moved.map(|(drive, part)| (*drive, part * value)).collect()
            };
            values.into_iter().map(place).collect()
        };
        let grid = Self {
            axes: axes.into_iter().map(places).collect(),
            start: mechanism.first_drives(),
            zeros: (from == CountedFrom::Zero).then(|| offsets.map(|offset| -offset).collect()),
        };
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
            for (drive, value) in self.moved(&axis[at.number], &drives) {
                drives[drive] = value;
            }
        }
        drives
    }

    /// The drives that an axis moves, by number, with their values at one of its places. `before` are those of all drives as
    /// the axes before it leave them.
    pub(super) fn moved(&self, place: &AxisPlace, before: &[f64]) -> Vec<(usize, f64)> {
        let from = self.zeros.as_deref().unwrap_or(before);
        let moved = place.iter();
        moved
            .map(|(drive, change)| (*drive, from[*drive] + change))
            .collect()
    }

    /// The places of an axis above the drives' values `before` it moves, by number, and those below, each in the order away
    /// from them.
    pub(super) fn outwards(&self, axis: &[AxisPlace], before: &[f64]) -> [Vec<usize>; 2] {
        let from = self.zeros.as_deref().unwrap_or(before);
        // The drives of an axis move together, so the first tells the direction.
        let height = |place: &AxisPlace| {
            let first = place.first();
            first.map_or(0.0, |(drive, change)| {
                from[*drive] + change - before[*drive]
            })
        };
        let heights: Vec<f64> = axis.iter().map(height).collect();
        let mut order: Vec<usize> = (0..axis.len()).collect();
        order.sort_by(|a, b| heights[*a].total_cmp(&heights[*b]));
        let is_below = |index: &usize| heights[*index] < 0.0;
        let (mut below, above): (Vec<usize>, Vec<usize>) = order.into_iter().partition(is_below);
        below.reverse();
        [above, below]
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
