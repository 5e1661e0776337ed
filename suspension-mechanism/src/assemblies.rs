//! All assemblies of a mechanism: numerical algebraic geometry.
//!
//! A. J. Sommese and C. W. Wampler 2005, The Numerical Solution of Systems of Polynomials Arising in
//! Engineering and Science. The equations are polynomials; over complex numbers all their roots hang
//! together. The roots of one general mechanism are found by following random points and going round
//! loops; from there each leads to a root of the mechanism at hand, or to infinity.

mod census;
mod factors;
mod family;
mod generic;
mod parallel;
mod path;
mod random;
mod tilt;

use nalgebra::SVector;
use suspension_core::{Inputs, Still};

pub use census::{Census, Tally};
pub use family::Enumerable;
pub use generic::Evidence;

use family::{Family, complex};
use generic::Generic;
use random::Random;

/// Watches a search that may take long. It is called before each root is followed, by several threads, with the number of
/// assemblies that are known of a mechanism of general lengths; `false` gives the search up.
pub type Watch<'a> = dyn Fn(usize) -> bool + Sync + 'a;

/// The search for all assemblies of a mechanism. What it finds out about general lengths serves all
/// values of the drives.
pub struct Assemblies<'a, L: Enumerable<N>, const N: usize> {
    model: &'a L,
    generic: Generic<'a, L::Listing, N>,
}

impl<'a, L: Enumerable<N>, const N: usize> Assemblies<'a, L, N> {
    /// Searches a mechanism of general lengths, starting around `near`; `None` where `watch` gives the search up.
    pub fn new(
        model: &'a L,
        near: &SVector<f64, N>,
        inputs: &Inputs<Still, L::Drives>,
        watch: &'a Watch<'a>,
    ) -> Option<Self> {
        const SEED: u64 = 1;
        let mut random = Random::new(SEED);
        let family = Family::new(model, &mut random);
        let generic = Generic::new(family, near, complex(model, inputs), random, watch)?;
        Some(Self { model, generic })
    }

    /// All assemblies at values of the drives; `None` where the search is given up.
    pub fn at(&mut self, inputs: &Inputs<Still, L::Drives>) -> Option<Census<N>> {
        census::census(&mut self.generic, self.model, inputs)
    }
}
