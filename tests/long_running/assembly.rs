//! Assemblies: all of them, and the one nearest to a guess.

mod closed_form;
mod enumeration;
mod noise;
mod random;
