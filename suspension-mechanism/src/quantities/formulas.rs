//! The formulas of a quantity, and the numbers that they make.

use suspension_core::Signal;

use crate::file::Dimension;
use crate::mechanism::{Gradient, Names, Sensitive};
use crate::quantities::axis::Axis;
use crate::quantities::number::Number;
use crate::quantities::reader::Reader;

/// Makes the numbers of a quantity: one formula, compiled for each number type.
pub struct Formulas {
    pub(super) along: fn(&Names) -> Vec<Reading<Signal<f64>>>,
    pub(super) gradient: fn(&Names) -> Vec<Reading<Gradient>>,
    pub(super) sensitive: fn(&Names) -> Vec<Reading<Sensitive>>,
}

/// A number type for which the formulas of quantities are compiled.
pub trait Compiled: Number {
    /// The numbers of a quantity; none if the linkage lacks what it describes.
    fn readings(formulas: &Formulas, names: &Names) -> Vec<Reading<Self>>;
}

impl Compiled for Signal<f64> {
    fn readings(formulas: &Formulas, names: &Names) -> Vec<Reading<Self>> {
        (formulas.along)(names)
    }
}

impl Compiled for Gradient {
    fn readings(formulas: &Formulas, names: &Names) -> Vec<Reading<Self>> {
        (formulas.gradient)(names)
    }
}

impl Compiled for Sensitive {
    fn readings(formulas: &Formulas, names: &Names) -> Vec<Reading<Self>> {
        (formulas.sensitive)(names)
    }
}

/// A function that reads a number of any state.
pub(super) type Read<N> = dyn Fn(&Reader<'_, N>) -> N;

/// One number of a quantity.
pub struct Reading<N> {
    pub(super) name: Option<String>,
    /// The name of the wheel to which it belongs.
    pub(super) wheel: Option<String>,
    pub(super) dimension: Dimension,
    pub(super) axis: Option<Axis>,
    pub(super) has_derivatives: bool,
    pub(super) value: Box<Read<N>>,
}
