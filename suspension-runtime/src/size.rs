//! The sizes that models are made in.

use crate::table::{Masked, Table, Value};

/// Room for a model of `N` unknowns; see [`Size`] for those that there are.
#[derive(Clone, Copy, Debug)]
pub struct Room<const N: usize>;

/// What a model of a size has room for.
pub trait Size: Value {
    /// Chassis points, drives, measures, markers, bodies, points that bodies carry: each of them.
    type Few<V: Value>: Table<V>;
    /// Free and chassis points together, or unknowns.
    type Sites<V: Value>: Table<V>;
    /// Numbers of the factored Jacobian.
    type Entries<V: Value>: Table<V>;
}

macro_rules! sizes {
    ($($unknowns:literal: few $few:literal, sites $sites:literal, entries $entries:literal;)*) => {
        $(impl Size for Room<$unknowns> {
            type Few<V: Value> = Masked<V, $few>;
            type Sites<V: Value> = Masked<V, $sites>;
            type Entries<V: Value> = Masked<V, $entries>;
        })*
    };
}

sizes! {
    15: few 8, sites 16, entries 128;
    30: few 16, sites 32, entries 256;
    60: few 32, sites 64, entries 512;
}
