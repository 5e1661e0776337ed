//! The forms of equations, each in one file: where its points and its derivatives are, and what is asked of it where
//! equations are walked. What is computed of them is in [`suspension_core::model::constraint`]. `list` lists the forms.

mod along;
mod bilinear;
mod carried;
mod distance;
mod entering;
mod linear;
mod list;
mod place;
mod product;
mod span;
mod stretch;
mod turn;

use nalgebra::Vector3;
use suspension_core::Scalar;

use crate::site::{Inputs, Sites};
use crate::table::Table;

pub(crate) use along::Along;
pub(crate) use bilinear::{Bilinear, Scale};
pub(crate) use carried::Body;
pub(crate) use distance::Distance;
pub(crate) use linear::{Linear, Prescribed};
pub(crate) use list::{Forms, walk};
pub(crate) use product::Product;
pub(crate) use stretch::Stretch;
pub(crate) use turn::Turn;

use place::Place;

/// The functions of an equation, or of the equations of one body. `F` holds chassis points.
pub(crate) trait Walked<T: Scalar, F: Table<Vector3<T>>> {
    /// The constant that a geometry gives it.
    type Constant: ?Sized;

    /// Writes its residual into its rows.
    fn residual(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, rows: &mut [T]);

    /// Writes its derivatives with respect to the unknowns.
    fn gradient(&self, constant: &Self::Constant, at: &Sites<'_, T, F>, to: &mut impl Entries<T>);

    /// Writes `C(v, w)` into its rows, which are zeros.
    fn curvature(&self, _: &Self::Constant, [_v, _w]: [&Sites<'_, T, F>; 2], _rows: &mut [T]) {}

    /// Writes `-dF/du udot` into its rows, which are zeros. A long implementation is not inlined: inputs enter few
    /// equations, and the walk over all forms would need its registers.
    fn input_rate(&self, _: &Self::Constant, _inputs: &Inputs<'_, T, F>, _rows: &mut [T]) {}

    /// Sets the unknowns of this equation that are not coordinates, for the positions of the points.
    fn put_scalars(&self, _: &Self::Constant, _q: &mut [T], _fixed: &F) {}
}

/// A store of derivatives.
pub(crate) trait Entries<T> {
    fn put(&mut self, entry: u16, derivative: T);
}

impl<T: Scalar, M: Table<T>> Entries<T> for M {
    #[inline(always)]
    fn put(&mut self, entry: u16, derivative: T) {
        *self.place(entry) = derivative;
    }
}

/// Writes a derivative with respect to a point.
#[inline(always)]
fn put_vector<T: Scalar>([x, y, z]: [u16; 3], by_point: Vector3<T>, to: &mut impl Entries<T>) {
    to.put(x, by_point.x);
    to.put(y, by_point.y);
    to.put(z, by_point.z);
}
