//! Hostile input at every entry of the core, in f64 and f32: a root at rounding level or an error
//! that names its cause, the state untouched; never a panic, never a NaN.

mod causes;
mod draw;
mod far;
mod geometry;
mod mechanisms;
mod random;
mod reached;
mod reading;
mod steps;
mod trial;
mod verdict;
mod ways;
