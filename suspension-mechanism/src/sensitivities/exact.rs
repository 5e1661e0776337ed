//! Quantities along a change, by the chain rule.

use crate::kinematics::Changing;
use crate::quantities::{Column, Reader};

/// Reads what a change does: `f(d) = f'' [d, d] + f' w` of the rates `d` and the second rates `w` along the change, a drive,
/// and both together gives the mixed derivative, as `(f(p + u) - f(p) - f(u)) / 2`.
pub(super) struct Exact<'a> {
    columns: &'a [Column],
    /// `f` of each column along each drive.
    of_drives: Vec<Vec<f64>>,
}

impl<'a> Exact<'a> {
    /// Of columns, where nothing is changed.
    pub(super) fn new(columns: &'a [Column], held: &Changing) -> Self {
        let of_drive = |state| {
            let reader = Reader::of(state);
            let columns = columns.iter().map(|column| column.read(&reader));
            columns.map(|along| along.second_rate).collect()
        };
        Self {
            columns,
            of_drives: held.with_drives.iter().map(of_drive).collect(),
        }
    }

    /// The derivatives of each column's value and of its derivatives with respect to each drive.
    pub(super) fn read(&self, changing: &Changing) -> Vec<Vec<f64>> {
        let change = Reader::of(&changing.alone);
        let with_drives: Vec<Reader<'_>> = changing.with_drives.iter().map(Reader::of).collect();
        let of_column = |(place, column): (usize, &Column)| {
            if !column.has_derivatives {
                return vec![f64::NAN; 1 + with_drives.len()];
            }
            let change = column.read(&change);
            let drives = with_drives.iter().zip(&self.of_drives);
            let mixed = drives.map(|(with_drive, of_drive)| {
                let together = column.read(with_drive).second_rate;
                (together - change.second_rate - of_drive[place]) / 2.0
            });
            [change.rate].into_iter().chain(mixed).collect()
        };
        self.columns.iter().enumerate().map(of_column).collect()
    }
}
