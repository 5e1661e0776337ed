//! All calls of the solver. All settings are arguments, so that no branch is optimised away.

mod assembly;
mod baked;
mod bounded;
mod certificate;
mod construction;
mod path;
mod series;
mod solving;
