//! Lanes against the same steps made alone, and lanes that fail or change among others that succeed.

mod agreement;
mod debug;
mod failures;
mod fleet;
mod on_a_road;
mod replaced;
