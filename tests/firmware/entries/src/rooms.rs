//! Every call of the solver. All settings come from outside, so that no branch is folded away.

mod assembly;
mod baked;
mod bounded;
mod certificate;
mod construction;
mod path;
mod series;
mod solving;
