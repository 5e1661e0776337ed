//! The first columns of each row: the place of the loads.

use crate::kinematics::Kinematics;
use crate::mechanism::{State, Unit};
use crate::number::number;
use crate::quantities::{self, Column, Quantity, value_in_file};

/// The quantities in the first columns of each row.
pub(super) struct PlaceColumns {
    columns: Vec<Column>,
    unit: Unit,
}

impl PlaceColumns {
    pub(super) fn new(mechanism: &dyn Kinematics, quantities: &[&'static Quantity]) -> Self {
        Self {
            columns: quantities::columns(quantities.iter().copied(), &mechanism.names),
            unit: mechanism.unit,
        }
    }

    pub(super) fn names(&self) -> impl Iterator<Item = String> {
        let columns = self.columns.iter();
        columns.map(|column| column.csv_name(self.unit))
    }

    /// Returns the numbers of a state in the file's units.
    pub(super) fn read(&self, state: &State) -> Vec<f64> {
        let columns = self.columns.iter();
        columns
            .map(|column| value_in_file(column, state, self.unit))
            .collect()
    }

    /// Formats those of a place's numbers that `is_chosen` selects by their positions, for example `bump = 0.3 m, steer =
    /// 0.34 m`.
    pub(super) fn in_words(&self, place: &[f64], is_chosen: impl Fn(usize) -> bool) -> String {
        let chosen = self.columns.iter().zip(place).enumerate();
        let chosen = chosen.filter(|(position, _)| is_chosen(*position));
        let in_words = chosen.map(|(_, (column, value))| {
            let symbol = column.dimension.symbol(self.unit);
            format!("{} = {} {symbol}", column.name, number(*value))
        });
        in_words.collect::<Vec<_>>().join(", ")
    }
}
