//! The columns of the table with the places of a curve.

use crate::mechanism::{Names, Unit};
use crate::output::table::Column;
use crate::quantities::{self, DRIVES, Shown, catalogue};
use crate::reach::Station;

/// Returns the columns: the drives, and all quantities of the catalogue that positions determine.
pub(super) fn columns(names: &Names, unit: Unit) -> Vec<Column<Station>> {
    let of_state = |column| Column::of_state(column, unit, |station: &Station| &station.state);
    let of_positions = quantities::columns(catalogue(), names)
        .into_iter()
        .filter(|column| {
            column.dimension.is_of_positions() && column.quantity.shown != Shown::InSummaries
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
