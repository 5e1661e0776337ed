//! Quantities along changes, by the chain rule.

use nalgebra::DMatrix;

use crate::characteristics::columns_in;
use crate::kinematics::Kinematics;
use crate::mechanism::{
    DRIVES_AT_ONCE, DesignDerivatives, Expansion, InDesign, Names, Sensitive, State,
};
use crate::quantities::{Column, Reader};
use crate::sensitivities::Change;

/// Reads the effects of changes.
pub(super) struct Exact<'a> {
    columns: Vec<Column<Sensitive>>,
    names: &'a Names,
    design: &'a dyn DesignDerivatives,
    state: State,
}

impl<'a> Exact<'a> {
    /// Reads a mechanism that starts in this state.
    pub(super) fn new(
        mechanism: &'a dyn Kinematics,
        design: &'a dyn DesignDerivatives,
        state: State,
    ) -> Self {
        Self {
            columns: columns_in(mechanism),
            names: &mechanism.names,
            design,
            state,
        }
    }

    /// For each change the derivatives of each column's value and of its derivatives with respect to each drive, NaN
    /// if it has none; `None` if no such suspensions can be built. At most as many changes as a number has
    /// derivatives.
    pub(super) fn read(&self, changes: &[Change]) -> Vec<Option<DMatrix<f64>>> {
        let drives = self.names.drives.len();
        let along = changes.iter().map(|change| {
            self.design
                .along(&change.per_unit.points, &change.per_unit.lengths)
        });
        let along: Vec<Option<Expansion>> = along.collect();
        let unknown = DMatrix::repeat(self.columns.len(), 1 + drives, f64::NAN);
        let of_change = |along: &Option<Expansion>| along.as_ref().map(|_| unknown.clone());
        let mut found: Vec<_> = along.iter().map(of_change).collect();
        for first in (0..drives.max(1)).step_by(DRIVES_AT_ONCE) {
            let at = InDesign {
                names: self.names,
                start: self.design.start(),
                changes: &along,
                first,
            };
            let reader = Reader::with_numbers(&self.state, &at);
            let columns = self.columns.iter().enumerate();
            for (place, column) in columns.filter(|(_, column)| column.has_derivatives) {
                let number = column.read(&reader);
                for (change, found) in found.iter_mut().enumerate() {
                    let Some(found) = found else {
                        continue;
                    };
                    found[(place, 0)] = number.value.rates[change];
                    for (drive, per_drive) in (first..drives).zip(&number.rates) {
                        found[(place, 1 + drive)] = per_drive.rates[change];
                    }
                }
            }
        }
        found
    }
}
