//! Named numbers: structs in C, arrays in the order of the names in Rust.

use core::marker::PhantomData;

use suspension_core::nalgebra::Vector3;
use suspension_core::step::bounded::Outputs;
use suspension_core::{Linkage, Signal};

use crate::status::Status;

/// A value for each name.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Values<V, const COUNT: usize> {
    /// In the order of the names; where there are none a single one that means nothing, because C has
    /// no empty structs.
    pub values: [V; COUNT],
}

/// How many values there is room for.
pub const fn room(names: &[&str]) -> usize {
    if names.is_empty() { 1 } else { names.len() }
}

/// A quantity with its first and second time derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Rates<V> {
    /// The value.
    pub value: V,
    /// Its first derivative, per second.
    pub rate: V,
    /// Its second derivative, per second squared.
    pub second_rate: V,
}

impl<V> Rates<V> {
    /// From the core's form.
    pub fn from_signal<S>(signal: &Signal<S>, convert: impl Fn(&S) -> V) -> Self {
        Self {
            value: convert(&signal.value),
            rate: convert(&signal.rate),
            second_rate: convert(&signal.second_rate),
        }
    }
}

/// The core's form.
#[inline(always)]
pub fn signal<V, S>(rates: &Rates<V>, convert: impl Fn(&V) -> S) -> Signal<S> {
    Signal {
        value: convert(&rates.value),
        rate: convert(&rates.rate),
        second_rate: convert(&rates.second_rate),
    }
}

/// Numbers under their names.
#[inline(always)]
pub fn named<T: Copy + Default, S: suspension_core::Values<T>, const COUNT: usize>(
    values: &Values<T, COUNT>,
) -> S {
    S::from_values(values.values.iter().copied())
}

/// Points under their names.
#[inline(always)]
pub fn named_points<T, S, const COUNT: usize>(values: &Values<[T; 3], COUNT>) -> S
where
    T: Copy + Default + suspension_core::Scalar,
    S: suspension_core::Values<Vector3<T>>,
{
    S::from_values(values.values.iter().copied().map(Vector3::from))
}

/// Numbers in a row.
#[inline(always)]
pub fn values<T: Copy + Default, S: suspension_core::Values<T>, const COUNT: usize>(
    named: &S,
) -> Values<T, COUNT> {
    let mut each = named.values();
    Values {
        values: core::array::from_fn(|_| each.next().unwrap_or_default()),
    }
}

/// Points in a row.
#[inline(always)]
pub fn values_of_points<T, S, const COUNT: usize>(named: &S) -> Values<[T; 3], COUNT>
where
    T: suspension_core::Scalar,
    S: suspension_core::Values<Vector3<T>>,
{
    let mut each = named.values();
    Values {
        values: core::array::from_fn(|_| each.next().unwrap_or_default().into()),
    }
}

/// The number of a linkage's unknowns.
pub const fn unknowns<L: Linkage<N>, const N: usize>(_: PhantomData<L>) -> usize {
    N
}

/// Which rates a bounded step solves for.
#[inline(always)]
pub fn outputs_of(number: i32) -> Result<Outputs, Status> {
    match number {
        0 => Ok(Outputs::Position),
        1 => Ok(Outputs::Velocity),
        2 => Ok(Outputs::Acceleration),
        _ => Err(Status::Argument),
    }
}
