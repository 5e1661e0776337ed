//! The sizes in which models are made: arrays on the stack, with room to spare in all but the largest
//! listings.

use nalgebra::Vector3;
use suspension_listing::text::MOST_UNKNOWNS;

use crate::table::{Masked, Table, Value};

/// Room for `N` unknowns: see [`Size`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Room<const N: usize>;

/// The unknowns of the largest size, which has room for any listing that is read.
pub(crate) const LARGEST: usize = MOST_UNKNOWNS;

/// The room in a model of a size. There are four sizes: `Room<15>`, `Room<30>`, `Room<60>`, `Room<120>`.
///
/// | unknowns | chassis points | all points | drives, measures, markers, bodies, carried points, each | lengths | numbers of the factored Jacobian |
/// | --- | --- | --- | --- | --- | --- |
/// | 15 | 8 | 32 | 8 | 64 | 126 |
/// | 30 | 16 | 64 | 16 | 128 | 254 |
/// | 60 | 32 | 128 | 32 | 256 | 1022 |
/// | 120 | 64 | 128 | 32 | 256 | 2046 |
pub trait Size: Value {
    /// A value for each chassis point.
    type Chassis<V: Value>: Table<V>;
    /// A few values: drives, measures, markers and the like.
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
    ($($unknowns:literal: $chassis:literal, $few:literal, $places:literal, $points:literal, $lengths:literal, $numbers:literal;)*) => {
        $(impl Size for Room<$unknowns> {
            type Chassis<V: Value> = Masked<V, $chassis>;
            type Few<V: Value> = Masked<V, $few>;
            type Unknowns<V: Value> = Masked<V, $places>;
            type Points<V: Value> = Masked<V, $points>;
            type Lengths<V: Value> = Masked<V, $lengths>;
            type Numbers<V: Value> = Masked<V, $numbers>;
        })*
    };
}

sizes! {
    15: 8, 8, 16, 32, 64, 128;
    30: 16, 16, 32, 64, 128, 256;
    60: 32, 32, 64, 128, 256, 1024;
    120: 64, 32, 128, 128, 256, 2048;
}

/// The chassis points of a model of `N` unknowns, or their rates.
pub(crate) type Chassis<T, const N: usize> = <Room<N> as Size>::Chassis<Vector3<T>>;

/// A few values in a model of `N` unknowns.
pub(crate) type Few<V, const N: usize> = <Room<N> as Size>::Few<V>;

/// A value for each unknown of a model of `N`, and one more.
pub(crate) type Unknowns<V, const N: usize> = <Room<N> as Size>::Unknowns<V>;

/// A value for each point of a model of `N` unknowns.
pub(crate) type Points<V, const N: usize> = <Room<N> as Size>::Points<V>;

/// A value for each length of a model of `N` unknowns.
pub(crate) type Lengths<V, const N: usize> = <Room<N> as Size>::Lengths<V>;
