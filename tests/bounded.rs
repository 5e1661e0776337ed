//! Steps of fixed cost against solutions of their own at each instant, and what they refuse.

mod accuracy;
mod assemblies;
mod attempt;
mod case;
mod jumps;
mod pivots;
mod refusals;
