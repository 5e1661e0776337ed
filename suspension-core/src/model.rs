//! What a model of a linkage is made of.
//!
//! A program uses [`local`], an origin among the hardpoints, which keeps `f32` accurate, and [`measure`], lengths and angles with
//! their derivatives. The rest is for the code that `linkage!` writes: equations of each kind ([`constraint`]), their constants
//! from hardpoints or lengths ([`parts`]), and the side on which a point stands that links alone hold ([`handedness`]).

pub mod constraint;
pub mod handedness;
pub mod local;
pub mod measure;
pub mod parts;
pub(crate) mod rows;
