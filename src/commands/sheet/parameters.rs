//! The quantities at the design position, with their derivatives.

use std::sync::atomic::AtomicBool;

use crate::mechanism::{From, Grid, Mechanism, Order, State, Suspension, Unit};
use crate::quantities::{
    self, CATALOGUE, Column, DRIVES, Kind, MARKERS, POSITIONS, Quantity, RESIDUAL,
};

/// A row of the table.
pub(super) struct Parameter {
    pub(super) name: String,
    pub(super) symbol: String,
    pub(super) value: f64,
    /// With respect to travel and steering; `None` where there is no such drive, or no derivative.
    pub(super) per: [Option<f64>; 2],
    pub(super) quantity: &'static Quantity,
}

/// The columns that a sheet shows.
pub(super) fn columns<L, const N: usize>(mechanism: &Mechanism<L, N>) -> Vec<Column> {
    const LEFT_OUT: [&Quantity; 4] = [&DRIVES, &POSITIONS, &MARKERS, &RESIDUAL];
    let all = quantities::columns(CATALOGUE, &mechanism.names).into_iter();
    all.filter(|column| {
        column.kind.is_of_positions() && !LEFT_OUT.iter().any(|quantity| column.is(quantity))
    })
    .collect()
}

/// All that the mechanism has where it starts: a grid without a drive is that place alone.
pub(super) fn parameters<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    interrupted: &AtomicBool,
) -> Vec<Parameter> {
    let vehicle = mechanism.names.vehicle;
    let columns = columns(mechanism);
    let mut read = |state: &State, per: &dyn Fn(usize) -> Option<State>| -> Vec<Parameter> {
        let per = [vehicle.travel, vehicle.steer].map(|drive| per(drive?));
        let parameter = |column| parameter(column, mechanism.unit, state, &per);
        columns.iter().map(parameter).collect()
    };
    let grid = Grid::new(mechanism, Vec::new(), From::Start).unwrap_or_default();
    let visited = mechanism.visit(&grid, Order::First, interrupted, &mut read);
    visited.places.into_iter().flatten().flatten().collect()
}

fn parameter(column: &Column, unit: Unit, state: &State, per: &[Option<State>; 2]) -> Parameter {
    let (scale, symbol) = column.kind.for_people(unit);
    let along = |state: &Option<State>| {
        let state = state.as_ref().filter(|_| column.has_derivatives)?;
        Some(column.along(state).rate * scale)
    };
    let axis = column
        .axis
        .map_or_else(String::new, |axis| format!(" {axis}"));
    Parameter {
        name: title(column) + &axis,
        symbol,
        value: column.value(state) * scale,
        per: per.each_ref().map(along),
        quantity: column.quantity,
    }
}

/// What a column is called on the page.
pub(super) fn title(column: &Column) -> String {
    if column.quantity.name.is_empty() {
        column.name.clone()
    } else {
        column.quantity.title.to_owned()
    }
}

/// The unit of a derivative with respect to a drive.
pub(super) fn symbol_per(symbol: &str, of_drive: Kind, unit: Unit) -> String {
    format!("{symbol}/{}", of_drive.symbol(unit))
}
