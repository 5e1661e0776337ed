//! The sizes in which models are made: arrays on the stack, with room to spare in all but the largest
//! listings.

use crate::table::{Masked, Table, Value};

/// Room for `N` unknowns: see [`Size`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Room<const N: usize>;

/// The unknowns of the largest size.
pub(crate) const LARGEST: usize = 60;

/// The room in a model of a size. There are three sizes: `Room<15>`, `Room<30>`, `Room<60>`.
///
/// | unknowns | chassis points, drives, measures, markers, bodies, carried points, each | lengths | numbers of the factored Jacobian |
/// | --- | --- | --- | --- |
/// | 15 | 8 | 64 | 126 |
/// | 30 | 16 | 128 | 254 |
/// | 60 | 32 | 256 | 1022 |
pub trait Size: Value {
    /// A few values: chassis points, drives and the like.
    type Few<V: Value>: Table<V>;
    /// A value for each unknown, and one more.
    type Unknowns<V: Value>: Table<V>;
    /// A value for each point: chassis points, free points, markers.
    type Points<V: Value>: Table<V>;
    /// A value for each length.
    type Lengths<V: Value>: Table<V>;
    /// Numbers of the factored Jacobian.
    type Numbers<V: Value>: Table<V>;
}

macro_rules! sizes {
    ($($unknowns:literal: $few:literal, $places:literal, $points:literal, $lengths:literal, $numbers:literal;)*) => {
        $(impl Size for Room<$unknowns> {
            type Few<V: Value> = Masked<V, $few>;
            type Unknowns<V: Value> = Masked<V, $places>;
            type Points<V: Value> = Masked<V, $points>;
            type Lengths<V: Value> = Masked<V, $lengths>;
            type Numbers<V: Value> = Masked<V, $numbers>;
        })*
    };
}

sizes! {
    15: 8, 16, 32, 64, 128;
    30: 16, 32, 64, 128, 256;
    60: 32, 64, 128, 256, 1024;
}

/// A few values in a model of `N` unknowns.
pub(crate) type Few<V, const N: usize> = <Room<N> as Size>::Few<V>;

/// A value for each unknown of a model of `N`, and one more.
pub(crate) type Unknowns<V, const N: usize> = <Room<N> as Size>::Unknowns<V>;

/// A value for each point of a model of `N` unknowns.
pub(crate) type Points<V, const N: usize> = <Room<N> as Size>::Points<V>;

/// A value for each length of a model of `N` unknowns.
pub(crate) type Lengths<V, const N: usize> = <Room<N> as Size>::Lengths<V>;
