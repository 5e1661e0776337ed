//! Lanes against the same steps made alone, and lanes that fail among others that succeed.

mod agreement;
mod failures;
mod fleet;
