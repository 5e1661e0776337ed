//! Assemblies: all of them, and the one nearest to a guess.

#[path = "assembly/closed_form.rs"]
mod closed_form;
#[path = "assembly/enumeration.rs"]
mod enumeration;
#[path = "assembly/noise.rs"]
mod noise;
#[path = "assembly/random.rs"]
mod random;
mod support;
