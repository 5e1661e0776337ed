//! The forms of equations, each in one file: where its points and its derivatives are. What is computed of them is
//! in [`suspension_core::constraint`].

mod along;
mod bilinear;
mod carried;
mod distance;
mod linear;
mod product;
mod rates;
mod span;
mod stretch;
mod turn;

pub(crate) use along::Along;
pub(crate) use bilinear::{Bilinear, Scale};
pub(crate) use carried::Body;
pub(crate) use distance::Distance;
pub(crate) use linear::{Linear, Prescribed};
pub(crate) use product::Product;
pub(crate) use rates::InputRates;
pub(crate) use stretch::Stretch;
pub(crate) use turn::Turn;
