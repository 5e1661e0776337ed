//! What is read off a mechanism: one catalogue, from which tables, plots, summaries and help are made.

mod catalogue;
mod kind;
mod quantity;
mod readings;
mod words;

pub use catalogue::{
    ACCELERATIONS, ALPHA, CAMBER, CAMBER_TO_GROUND, CASTER, CATALOGUE, CENTRE, DRIVES, ITERATIONS,
    KINGPIN, MARKERS, MEASURES, OMEGA, POSITIONS, RESIDUAL, TIME, TOE, VELOCITIES,
};
pub use kind::Kind;
pub use quantity::{Axis, Column, Quantity, Shown, columns};
pub use words::in_words;
