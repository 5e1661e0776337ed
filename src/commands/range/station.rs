//! A place on the curve of a freed drive, and the columns of its table.

use crate::mechanism::{Names, State, Unit};
use crate::output::table::Column;
use crate::quantities::{self, CATALOGUE, DRIVES, Shown};

/// A place on the curve of a freed drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Station {
    /// The number of the free drive, from 0.
    pub freed: usize,
    /// Whether the drive turns here.
    pub turns: bool,
    /// How far the free points move, the root of the sum of their squares, for a unit of the
    /// drive: in the unit for a radian, or for one of its own. Infinite where the drive turns.
    pub speed: f64,
    /// The mechanism at rest.
    pub state: State,
}

impl Station {
    /// The drive's value, in rad or the unit.
    pub fn value(&self) -> f64 {
        self.state.drives[self.freed]
    }
}

/// The table's columns: the drives, and all quantities of the catalogue that positions determine.
pub(super) fn columns(names: &Names, unit: Unit) -> Vec<Column<Station>> {
    let of_state = |column| Column::of_state(column, unit, |station: &Station| &station.state);
    let of_positions = quantities::columns(CATALOGUE, names)
        .into_iter()
        .filter(|column| {
            column.kind.is_of_positions() && column.quantity.shown != Shown::InSummaries
        });
    let (drives, others): (Vec<_>, Vec<_>) = of_positions.partition(|column| column.is(&DRIVES));
    let mut columns = vec![
        Column::new("freed", |station: &Station| station.freed as f64 + 1.0),
        Column::new("turns", |station| f64::from(u8::from(station.turns))),
    ];
    columns.extend(drives.into_iter().map(of_state));
    let speed = format!("speed_{}", unit.symbol());
    columns.push(Column::new(speed, |station| station.speed));
    columns.extend(others.into_iter().map(of_state));
    columns
}
