//! The catalogue: each quantity is one row. Signs and formulas are those of [`suspension_core::wheel`] and
//! [`suspension_core::body`].

use crate::file::Dimension;
use crate::mechanism::{State, Unit};
use crate::quantities::quantity::{Column, Quantity};

/// Makes a `static` of each row and the list of a file's rows. A formula is compiled for each number type.
macro_rules! catalogue {
    (@option) => { None };
    (@option $value:expr) => { Some($value) };
    ($($row:ident: $title:literal {
        name: $name:literal,
        sign: $sign:literal,
        definition: $definition:literal,
        source: $source:literal,
        $(vehicle: $vehicle:literal,)?
        $(zero_at_design: $changes_as:expr,)?
        shown: $shown:expr,
        read: $read:expr,
    })+) => {
        $(
            #[doc = concat!("The row \"", $title, "\".")]
            pub static $row: Quantity = Quantity {
                title: $title,
                name: $name,
                sign: $sign,
                definition: $definition,
                source: $source,
                vehicle: concat!($($vehicle)?),
                zero_at_design: catalogue!(@option $($changes_as)?),
                shown: $shown,
                read: crate::quantities::formulas::Formulas {
                    along: $read,
                    gradient: $read,
                    sensitive: $read,
                },
            };
        )+

        /// The rows of this file.
        pub(super) static ROWS: &[&Quantity] = &[$(&$row),+];
    };
}

mod axle;
mod from_design;
mod masses;
mod motion;
mod results;
mod springs;
mod steering;
mod travel;
mod wheel;

pub use axle::*;
pub use from_design::*;
pub use masses::*;
pub use motion::*;
pub use results::*;
pub use springs::*;
pub use steering::*;
pub use travel::*;
pub use wheel::*;

/// Whether a column belongs to a drive that is an angle, whose values files state.
pub(crate) fn is_driven_angle(column: &Column) -> bool {
    column.is(&DRIVES) && column.dimension == Dimension::Angle
}

/// The value of a column in a state, in the file's units; that of a driven angle is as the file states it.
pub fn value_in_file(column: &Column, state: &State, unit: Unit) -> f64 {
    let value = column.value(state) * unit.file_factor(column.dimension);
    if is_driven_angle(column) {
        unit.angle.as_stated(value)
    } else {
        value
    }
}

/// The rows of an axle, for a linkage with two wheels.
pub fn of_axles() -> impl Iterator<Item = &'static Quantity> {
    axle::ROWS.iter().copied()
}

/// The rows of quantities that are zero at the design position.
pub fn from_design() -> impl Iterator<Item = &'static Quantity> {
    catalogue().filter(|quantity| quantity.zero_at_design.is_some())
}

/// The rows that a reader of curves looks for first.
static FIRST_IN_CURVES: [&Quantity; 14] = [
    &CAMBER,
    &TOE,
    &ACKERMANN,
    &ROLL_CENTRE,
    &AXLE_ROLL_CENTRE,
    &MEASURES,
    &ANTI_DIVE,
    &ANTI_LIFT,
    &ANTI_SQUAT,
    &ANTI_LIFT_IN_DRIVE,
    &TRACK_CHANGE,
    &HALF_TRACK_CHANGE,
    &CASTER,
    &KINGPIN,
];

/// The place of a row among curves, for sorting: all that have no place of their own keep the order of tables.
pub(crate) fn place_in_curves(quantity: &Quantity) -> usize {
    let mut first = FIRST_IN_CURVES.iter();
    let place = first.position(|other| *other == quantity);
    place.unwrap_or(FIRST_IN_CURVES.len())
}

/// Whether a row is among those that a reader looks for first.
pub fn is_first_in_curves(quantity: &Quantity) -> bool {
    place_in_curves(quantity) < FIRST_IN_CURVES.len()
}

/// All rows, in the order of tables.
pub fn catalogue() -> impl Iterator<Item = &'static Quantity> + Clone {
    let files = [
        motion::ROWS,
        wheel::ROWS,
        steering::ROWS,
        travel::ROWS,
        springs::ROWS,
        masses::ROWS,
        from_design::ROWS,
        axle::ROWS,
        results::ROWS,
    ];
    files.into_iter().flatten().copied()
}
