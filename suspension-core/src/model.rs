//! The building blocks of a model of a linkage.
//!
//! A program uses [`local`], an origin among the hardpoints that keeps `f32` accurate, and [`measure`], lengths and
//! angles with their derivatives. The other modules serve the code that `linkage!` writes, and the crate
//! `suspension-runtime`: equations of each kind ([`constraint`]), their constants from hardpoints or lengths
//! ([`parts`]), and the side of a point that only links hold ([`handedness`]).

pub mod constraint;
pub mod handedness;
pub mod local;
pub mod measure;
pub mod parts;
pub(crate) mod rows;
