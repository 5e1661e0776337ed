//! The quantities at the design position, with their derivatives.

use crate::mechanism::{Mechanism, State, Suspension, Unit};
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

/// All that the mechanism has where it starts.
pub(super) fn parameters<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
) -> Vec<Parameter> {
    let [first, _] = mechanism.instants.ends();
    let drives = mechanism.drives.inputs::<L::Drives>(first).drives.value;
    let position = &mechanism.start.position;
    let inputs = suspension_core::Inputs::still(suspension_core::Signal::still(drives));
    let points = mechanism.start.points(&mechanism.model, &inputs).value;
    let state = mechanism.at_rest(first, &drives, points);
    let per = |drive| mechanism.per(drive, &drives, position);
    let state = mechanism.with_directions(state, per);
    let vehicle = mechanism.names.vehicle;
    let per = [vehicle.travel, vehicle.steer]
        .map(|drive| Some(mechanism.state(first, &drives, &per(drive?)?)));
    let parameter = |column: Column| parameter(&column, mechanism.unit, &state, &per);
    columns(mechanism).into_iter().map(parameter).collect()
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
