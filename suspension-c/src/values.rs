//! Named numbers: structs in C, arrays in the order of the names in Rust.

use core::marker::PhantomData;

use suspension_core::nalgebra::Vector3;
use suspension_core::step::bounded::Outputs;
use suspension_core::{Linkage, Signal};

use crate::status::Status;

/// One value per name.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Values<V, const COUNT: usize> {
    /// The values in the order of the names. Without names there is a single unused value, because C has no
    /// empty structs.
    pub values: [V; COUNT],
}

/// Returns the number of values for which there is room.
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
    /// Converts from the core's type.
    pub fn from_signal<S>(signal: &Signal<S>, convert: impl Fn(&S) -> V) -> Self {
        Self {
            value: convert(&signal.value),
            rate: convert(&signal.rate),
            second_rate: convert(&signal.second_rate),
        }
    }
}

/// Converts to the core's type.
#[inline(always)]
pub fn signal<V, S>(rates: &Rates<V>, convert: impl Fn(&V) -> S) -> Signal<S> {
    Signal {
        value: convert(&rates.value),
        rate: convert(&rates.rate),
        second_rate: convert(&rates.second_rate),
    }
}

/// Converts numbers to the struct of their names.
#[inline(always)]
pub fn named<T: Copy + Default, S: suspension_core::Values<T>, const COUNT: usize>(
    values: &Values<T, COUNT>,
) -> S {
    S::from_values(values.values.iter().copied())
}

/// Converts points to the struct of their names.
#[inline(always)]
pub fn named_points<T, S, const COUNT: usize>(values: &Values<[T; 3], COUNT>) -> S
where
    T: Copy + Default + suspension_core::Scalar,
    S: suspension_core::Values<Vector3<T>>,
{
    S::from_values(values.values.iter().copied().map(Vector3::from))
}

/// Converts a struct of numbers to an array.
#[inline(always)]
pub fn values<T: Copy + Default, S: suspension_core::Values<T>, const COUNT: usize>(
    named: &S,
) -> Values<T, COUNT> {
    let mut each = named.values();
    Values {
        values: core::array::from_fn(|_| each.next().unwrap_or_default()),
    }
}

/// Converts a struct of points to an array.
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

/// Returns the number of unknowns of a linkage.
pub const fn unknowns<L: Linkage<N>, const N: usize>(_: PhantomData<L>) -> usize {
    N
}

/// Returns the rates for which a bounded step solves.
#[inline(always)]
pub fn outputs_of(number: i32) -> Result<Outputs, Status> {
    match number {
        0 => Ok(Outputs::Position),
        1 => Ok(Outputs::Velocity),
        2 => Ok(Outputs::Acceleration),
        _ => Err(Status::Argument),
    }
}
