//! A drive or a measure over its range, with names and units.

use crate::bake::source::{Ranged, Replaced};
use crate::characteristics::Span;
use crate::commands::bake::baking::Baking;
use crate::file::Dimension;
use crate::mechanism::Unit;
use crate::number::number;

/// A drive, or a measure that leads in place of it, over its range.
pub(super) struct Variable {
    pub(super) drive: usize,
    /// The measure, which takes the drive's place.
    pub(super) measure: Option<usize>,
    /// The range in the file's coordinates, angles in radians.
    pub(super) range: [f64; 2],
    /// The range in local coordinates.
    pub(super) local: [f64; 2],
}

impl Baking<'_> {
    /// Describes a drive or a measure and its range; `unit` is that of the baked functions.
    pub(super) fn ranged(&self, along: &Variable, unit: Unit) -> Ranged {
        let replaced = || Replaced {
            drive: self.mechanism.names.drives[along.drive].name.clone(),
            start: self.at_first_instant(along.drive, unit),
        };
        Ranged {
            name: self.name(along).to_owned(),
            unit: self.dimension(along).symbol(unit),
            range: along.range,
            in_place_of: along.measure.map(|_| replaced()),
        }
    }

    pub(super) fn name(&self, along: &Variable) -> &str {
        let names = &self.mechanism.names;
        match along.measure {
            Some(measure) => &names.measures[measure].name,
            None => &names.drives[along.drive].name,
        }
    }

    pub(super) fn dimension(&self, along: &Variable) -> Dimension {
        let names = &self.mechanism.names;
        match along.measure {
            Some(measure) => names.measures[measure].kind.into(),
            None => names.drives[along.drive].kind.into(),
        }
    }

    /// Converts a local value to the file's coordinates and units.
    pub(super) fn in_file(&self, along: &Variable, local: f64) -> f64 {
        let offset = match along.measure {
            Some(measure) => self.mechanism.measure_offsets[measure],
            None => self.mechanism.drive_offsets[along.drive],
        };
        (local + offset) * self.mechanism.unit.file_factor(self.dimension(along))
    }

    /// Formats a local value with its unit.
    pub(super) fn in_words(&self, along: &Variable, local: f64) -> String {
        let (name, value) = (self.name(along), number(self.in_file(along, local)));
        let symbol = self.dimension(along).symbol(self.mechanism.unit);
        format!("{name} = {value} {symbol}")
    }
}

/// Parses a range of the drive's own values, which do not count from the design position as those of other commands do.
pub(super) fn own_values(range: &str) -> Result<[f64; 2], String> {
    let Span(range) = range
        .parse()
        .map_err(|wrong: String| format!("{wrong}, in the drive's or measure's own values"))?;
    Ok(range)
}
