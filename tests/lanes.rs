//! Lanes against the same steps made alone, and lanes that fail or change among others that succeed.

mod agreement;
mod failures;
mod fleet;
mod replaced;
