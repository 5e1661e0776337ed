//! Quantities along a change, by the chain rule.

use crate::kinematics::Changing;
use crate::quantities::{Column, Reader};

/// Reads what a change does: `f(d) = f'' [d, d] + f' w` of the rates `d` and the second rates `w` along the change, a drive,
/// and both together gives the mixed derivative, as `(f(p + u) - f(p) - f(u)) / 2`.
pub(super) struct Exact<'a> {
    change: Reader<'a>,
    drives: Vec<[Reader<'a>; 2]>,
}

impl<'a> Exact<'a> {
    /// Of a change, beside that of nothing.
    pub(super) fn of(changing: &'a Changing, held: &'a Changing) -> Self {
        let drives = changing.with_drives.iter().zip(&held.with_drives);
        Self {
            change: Reader::of(&changing.alone),
            drives: drives
                .map(|(with, alone)| [with, alone].map(Reader::of))
                .collect(),
        }
    }

    /// The derivatives of a column's value and of its derivatives with respect to each drive.
    pub(super) fn read(&self, column: &Column) -> Vec<f64> {
        if !column.has_derivatives {
            return vec![f64::NAN; 1 + self.drives.len()];
        }
        let change = column.read(&self.change);
        let mixed = self.drives.iter().map(|readers| {
            let [together, drive] = readers.each_ref().map(|reader| column.read(reader));
            (together.second_rate - change.second_rate - drive.second_rate) / 2.0
        });
        [change.rate].into_iter().chain(mixed).collect()
    }
}
