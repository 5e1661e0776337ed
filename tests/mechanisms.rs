//! Mechanisms outside the catalogue, written with `linkage!` and proved against closed-form
//! answers, finite differences, and the published results of another program.

mod angle;
mod checks;
mod couple;
mod double_wishbone;
mod drives;
mod factors;
pub(crate) mod four_bar;
mod hinge;
mod joints;
mod plane;
mod rocker;
mod slide;
mod trailing_arm;
mod turned;
