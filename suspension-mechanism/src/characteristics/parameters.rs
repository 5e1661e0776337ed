//! The quantities at the design position, with their derivatives.

use crate::characteristics::movement::Movement;
use crate::characteristics::title::Title;
use crate::file::Dimension;
use crate::kinematics::Kinematics;
use crate::mechanism::{Description, Place, State, Unit};
use crate::quantities::{
    self, ACCELERATIONS, Axis, Column, Compiled, DRIVES, MARKERS, POSITIONS, Quantity, RESIDUAL,
    VELOCITIES, catalogue,
};

/// A quantity at the design position, in units for people.
pub struct Parameter {
    /// Its name, and the wheel to which it belongs.
    pub title: Title,
    /// Its unit.
    pub symbol: String,
    /// Its value.
    pub value: f64,
    /// Its derivatives with respect to the drives of [`Movement::of_drives`]; `None` for a missing one.
    pub per: Vec<Option<Derivative>>,
    /// The row of the catalogue.
    pub quantity: &'static Quantity,
    /// The axis, for a coordinate.
    pub axis: Option<Axis>,
}

impl Parameter {
    /// Whether it is the coordinate of a quantity along an axis.
    pub fn is(&self, quantity: &Quantity, axis: Axis) -> bool {
        self.quantity == quantity && self.axis == Some(axis)
    }
}

/// A derivative with respect to a drive.
#[derive(Clone, Debug)]
pub struct Derivative {
    /// Its value.
    pub value: f64,
    /// Its unit.
    pub symbol: String,
}

/// The columns of a design.
pub fn columns(mechanism: &Description) -> Vec<Column> {
    columns_in(mechanism)
}

/// The same columns, read in another number type.
pub(crate) fn columns_in<N: Compiled>(mechanism: &Description) -> Vec<Column<N>> {
    let mut columns = columns_of_curves(mechanism);
    columns.retain(|column| !quantities::from_design().any(|quantity| column.is(quantity)));
    columns
}

/// The same columns with those that are zero at the design position.
pub(super) fn columns_of_curves<N: Compiled>(mechanism: &Description) -> Vec<Column<N>> {
    const LEFT_OUT: [&Quantity; 6] = [
        &DRIVES,
        &POSITIONS,
        &MARKERS,
        &VELOCITIES,
        &ACCELERATIONS,
        &RESIDUAL,
    ];
    let is_shown = |quantity: &&Quantity| !LEFT_OUT.contains(quantity);
    let mut columns = quantities::columns_in(catalogue().filter(is_shown), &mechanism.names);
    columns.retain(|column: &Column<N>| column.dimension.is_of_positions());
    columns
}

/// All quantities of the mechanism at its start, with lengths in `unit`.
pub fn parameters(mechanism: &dyn Kinematics, unit: Unit) -> Vec<Parameter> {
    let movements = Movement::of_drives(&mechanism.names);
    let columns = columns(mechanism);
    let mut read = |place: &dyn Place| -> Vec<Parameter> {
        let state = place.state();
        let per: Vec<PerDrive> = movements
            .iter()
            .map(|(_, drive)| {
                let kind = Dimension::from(mechanism.names.drives[*drive].kind);
                Some((kind, place.per(*drive)?))
            })
            .collect();
        let parameter = |column| parameter(column, (mechanism, unit), &state, &per);
        columns.iter().map(parameter).collect()
    };
    mechanism.at_start(&mut read).unwrap_or_default()
}

/// The dimension of a drive, and the state with derivatives with respect to it; `None` if the mechanism locks.
type PerDrive = Option<(Dimension, State)>;

fn parameter(
    column: &Column,
    (mechanism, unit): (&Description, Unit),
    state: &State,
    per: &[PerDrive],
) -> Parameter {
    let from = mechanism.unit;
    let (scale, symbol) = column.dimension.display_scale(unit);
    let scale = scale * column.dimension.conversion(from, unit);
    let along = |per: &PerDrive| {
        let (drive, state) = per.as_ref().filter(|_| column.has_derivatives)?;
        let value = column.along(state).rate * scale
            / (drive.conversion(from, unit) * unit.file_factor(*drive));
        Some(Derivative {
            value,
            symbol: symbol_per(&symbol, *drive, unit),
        })
    };
    Parameter {
        title: Title::new(column, &mechanism.names.wheels),
        value: column.value(state) * scale,
        per: per.iter().map(along).collect(),
        symbol,
        quantity: column.quantity,
        axis: column.axis,
    }
}

/// Whether a unit is that of a height per height.
pub(super) fn is_height_per_height(symbol: &str, unit: Unit) -> bool {
    symbol == symbol_per(unit.symbol(), Dimension::Length, unit)
}

/// The unit of a derivative with respect to a drive.
pub(super) fn symbol_per(symbol: &str, of_drive: Dimension, unit: Unit) -> String {
    format!("{symbol}/{}", of_drive.symbol(unit))
}
