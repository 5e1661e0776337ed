//! A column of the paper beside our results.

use crate::commands::published::paper::{self, Entry, Paper};
use crate::mechanism::{State, Unit};
use crate::quantities;

/// A printed entry and our result.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<'a> {
    /// The column.
    pub(super) column: &'a str,
    /// The instant, s.
    pub(super) t: f64,
    /// The entry of the paper.
    pub(super) entry: &'a Entry,
    /// Our result.
    pub(super) ours: f64,
}

impl Pair<'_> {
    /// Returns our result minus the paper's entry, misprints corrected.
    pub(super) fn difference(&self) -> f64 {
        self.ours - self.entry.value
    }

    /// Returns the magnitude of the difference in units of the last printed digit; up to one half is rounding.
    pub(super) fn units(&self) -> f64 {
        self.difference().abs() / self.entry.unit
    }
}

/// A column of the paper and the column of our results.
pub(super) struct Compared<'a> {
    printed: &'a paper::Column,
    /// Our column.
    pub(super) ours: &'a quantities::Column,
    /// The factor of our column: angles of drives are printed in degrees.
    scale: f64,
}

impl<'a> Compared<'a> {
    /// Returns the columns of a table that our results have.
    pub(super) fn all(
        table: &'a [paper::Column],
        ours: &'a [quantities::Column],
    ) -> Vec<Compared<'a>> {
        let one = |printed: &'a paper::Column| {
            ours.iter().find_map(|ours| {
                let scale = scale(ours, &printed.name)?;
                Some(Compared {
                    printed,
                    ours,
                    scale,
                })
            })
        };
        table.iter().filter_map(one).collect()
    }

    /// Pairs the entries with our results at the same instants.
    pub(super) fn pairs(&self, paper: &Paper, states: &[State]) -> Vec<Pair<'a>> {
        let entries = self.printed.entries.iter().zip(&paper.times);
        let pair = |((entry, t), state): ((&'a Entry, &f64), &State)| Pair {
            column: &self.printed.name,
            t: *t,
            entry,
            ours: self.ours.value(state) * self.scale,
        };
        entries.zip(states).map(pair).collect()
    }
}

/// Returns the factor of our column if `name` is its name.
fn scale(ours: &quantities::Column, name: &str) -> Option<f64> {
    let unit = Unit::METRE;
    if ours.csv_name(unit) == name {
        Some(1.0)
    } else {
        let (scale, _) = ours.dimension.display_scale(unit);
        (ours.name_for_people(unit) == name).then_some(scale)
    }
}
