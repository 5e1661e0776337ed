//! The axes of a grid, as users name them.

use nalgebra::DMatrix;

use crate::mechanism::description::Description;

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
    /// A sentence about a name that is not a drive, about a drive that is already there, unless the axes are such as heave and
    /// roll, and about a length and an angle.
    pub fn named(
        mechanism: &Description,
        words: &str,
        values: &[f64],
        others: &[Self],
    ) -> Result<Self, String> {
        let mut drives = Vec::new();
        for (name, part) in moved_together(words) {
            let drive = mechanism.names.chosen_drive(Some(name))?;
            if drives.iter().any(|(other, _)| *other == drive) {
                return Err(format!("the drive `{name}` is given twice"));
            }
            drives.push((drive, part));
        }
        check_kinds(mechanism, &drives)?;
        let moved = others.iter().map(|axis| &axis.drives).chain([&drives]);
        if let (false, Some((drive, _))) = (are_independent(moved), drives.first()) {
            let name = &mechanism.names.drives[*drive].name;
            return Err(format!(
                "the drive `{name}` is given twice: `{words}` adds no motion to those of the others"
            ));
        }
        let first = drives.first();
        let scale = first.map_or(1.0, |(drive, _)| {
            let kind = mechanism.names.drives[*drive].kind;
            mechanism.unit.file_factor(kind)
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

/// Whether no axis moves its drives as the others together do. Each states its drives with their parts.
fn are_independent<'a>(axes: impl Iterator<Item = &'a Vec<(usize, f64)>> + Clone) -> bool {
    let count = axes.clone().count();
    let drives = axes.clone().flatten().map(|(drive, _)| drive + 1).max();
    let mut parts = DMatrix::zeros(count, drives.unwrap_or_default());
    for (row, axis) in axes.enumerate() {
        for (drive, part) in axis {
            parts[(row, *drive)] = *part;
        }
    }
    parts.rank(1e-9) == count
}

/// The names that commas join, each with the sign of its change: -1 behind a minus, otherwise 1.
pub(crate) fn moved_together(words: &str) -> impl Iterator<Item = (&str, f64)> {
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
