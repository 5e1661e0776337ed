//! Steps of fixed cost against independent solutions at each instant, and their refusals.

mod accuracy;
mod assemblies;
mod attempt;
mod case;
mod jumps;
mod pivots;
mod refusals;
