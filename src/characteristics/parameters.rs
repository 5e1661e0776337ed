//! The quantities at the design position, with their derivatives.

use std::sync::atomic::AtomicBool;

use crate::kinematics::Kinematics;
use crate::mechanism::{Description, From, Grid, Order, State, Unit};
use crate::quantities::{
    self, Column, DRIVES, Kind, MARKERS, POSITIONS, Quantity, RESIDUAL, catalogue,
};

/// A quantity at the design position, for people.
pub struct Parameter {
    /// What it is called.
    pub name: String,
    /// Its unit.
    pub symbol: String,
    /// Its value.
    pub value: f64,
    /// Its derivatives with respect to travel and steering; `None` where there is no such drive, or no derivative.
    pub per: [Option<Derivative>; 2],
    /// The row of the catalogue.
    pub quantity: &'static Quantity,
}

/// A derivative with respect to a drive.
pub struct Derivative {
    /// Its value.
    pub value: f64,
    /// Its unit.
    pub symbol: String,
}

/// The columns of a sheet.
pub(super) fn columns(mechanism: &Description) -> Vec<Column> {
    const LEFT_OUT: [&Quantity; 4] = [&DRIVES, &POSITIONS, &MARKERS, &RESIDUAL];
    let all = quantities::columns(catalogue(), &mechanism.names).into_iter();
    all.filter(|column| {
        column.kind.is_of_positions() && !LEFT_OUT.iter().any(|quantity| column.is(quantity))
    })
    .collect()
}

/// All that the mechanism has where it starts, with lengths in `unit`: a grid without a drive is that place alone.
pub fn parameters(
    mechanism: &dyn Kinematics,
    unit: Unit,
    interrupted: &AtomicBool,
) -> Vec<Parameter> {
    let vehicle = mechanism.names.vehicle;
    let drives = [vehicle.travel, vehicle.steer];
    let columns = columns(mechanism);
    let mut read = |state: &State, per: &dyn Fn(usize) -> Option<State>| -> Vec<Parameter> {
        let per = drives.map(|drive| {
            Some((
                Kind::from(mechanism.names.drives[drive?].kind),
                per(drive?)?,
            ))
        });
        let parameter = |column| parameter(column, [mechanism.unit, unit], state, &per);
        columns.iter().map(parameter).collect()
    };
    let grid = Grid::new(mechanism, Vec::new(), From::Start).unwrap_or_default();
    let visited = mechanism.visit(&grid, Order::First, interrupted, &mut read);
    visited.places.into_iter().flatten().flatten().collect()
}

fn parameter(
    column: &Column,
    [from, unit]: [Unit; 2],
    state: &State,
    per: &[Option<(Kind, State)>; 2],
) -> Parameter {
    let (scale, symbol) = column.kind.for_people(unit);
    let scale = scale * column.kind.conversion(from, unit);
    let along = |per: &Option<(Kind, State)>| {
        let (drive, state) = per.as_ref().filter(|_| column.has_derivatives)?;
        let value = column.along(state).rate * scale / drive.conversion(from, unit);
        Some(Derivative {
            value,
            symbol: symbol_per(&symbol, *drive, unit),
        })
    };
    Parameter {
        name: name(column),
        value: column.value(state) * scale,
        per: per.each_ref().map(along),
        symbol,
        quantity: column.quantity,
    }
}

/// What a column is called, with its axis.
pub(super) fn name(column: &Column) -> String {
    let axis = column
        .axis
        .map_or_else(String::new, |axis| format!(" {axis}"));
    let title = if column.quantity.name.is_empty() {
        &column.name
    } else {
        column.quantity.title
    };
    format!("{title}{axis}")
}

/// The unit of a derivative with respect to a drive.
pub(super) fn symbol_per(symbol: &str, of_drive: Kind, unit: Unit) -> String {
    format!("{symbol}/{}", of_drive.symbol(unit))
}
