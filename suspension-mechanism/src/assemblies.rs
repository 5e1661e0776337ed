//! All assemblies of a mechanism: numerical algebraic geometry.
//!
//! A. J. Sommese and C. W. Wampler 2005, The Numerical Solution of Systems of Polynomials Arising in
//! Engineering and Science. The equations are polynomials; over complex numbers all their roots hang
//! together. A mechanism is put together part by part. The roots of a part of one general mechanism are found by
//! following random points and going round loops; from there each leads to a root of the part at hand, or to infinity.

mod census;
mod factors;
mod family;
mod generic;
mod parallel;
mod parts;
mod path;
mod random;
mod searched;
mod tilt;

use nalgebra::SVector;
use suspension_core::{Inputs, Newton, Still};

pub use census::{PartTally, Tally};
pub use family::Enumerable;
pub use generic::Evidence;

use factors::Vector;
use family::{complex, parts};
use random::Random;
use searched::Searched;

/// Watches a search that may take long. It is called before each root is followed, by several threads, with the number of
/// assemblies that are known of a part of general lengths; `false` gives the search up.
pub type Watch<'a> = dyn Fn(usize) -> bool + Sync + 'a;

/// All assemblies of a mechanism at given values of its drives.
#[derive(Clone, Debug, PartialEq)]
pub struct Census<const N: usize> {
    /// The real ones, residuals tested.
    pub real: Vec<SVector<f64, N>>,
    /// What became of all.
    pub tally: Tally,
}

/// The search for all assemblies of a mechanism. What it finds out about general lengths serves all
/// values of the drives.
pub struct Assemblies<'a, L: Enumerable<N>, const N: usize> {
    model: &'a L,
    near: Vector<N>,
    parts: Vec<Searched<'a, L::Listing, N>>,
}

impl<'a, L: Enumerable<N>, const N: usize> Assemblies<'a, L, N> {
    /// Searches the parts of a mechanism of general lengths, starting around `near`; `None` where `watch` gives the search up.
    pub fn new(
        model: &'a L,
        near: &SVector<f64, N>,
        inputs: &Inputs<Still, L::Drives>,
        watch: &'a Watch<'a>,
    ) -> Option<Self> {
        const SEED: u64 = 1;
        let mut random = Random::new(SEED);
        let drives = complex(model, inputs);
        let parts = parts::<L::Listing, N>(model, &drives, &mut random).into_iter();
        let search = |part| Searched::new(model, part, near, drives, random.clone(), watch);
        Some(Self {
            model,
            near: near.map(Into::into),
            parts: parts.map(search).collect::<Option<_>>()?,
        })
    }

    /// All assemblies at values of the drives; `None` where the search is given up.
    pub fn at(&mut self, inputs: &Inputs<Still, L::Drives>) -> Option<Census<N>> {
        let drives = complex(self.model, inputs);
        let mut assemblies = vec![self.near];
        let mut tallies = Vec::new();
        for part in &mut self.parts {
            let (longer, tally) = part.after(&assemblies, drives)?;
            assemblies = longer;
            tallies.extend(tally);
        }
        let confirmed = |q: &Vector<N>| {
            let mut q = q.map(|entry| entry.re);
            let confirmed = Newton::near_by().solve(self.model, inputs, &mut q);
            confirmed.is_ok().then_some(q)
        };
        let real: Vec<_> = assemblies.iter().filter_map(confirmed).collect();
        let tally = Tally {
            real: real.len(),
            turned: 0,
            unconfirmed: assemblies.len() - real.len(),
            parts: tallies,
        };
        Some(Census { real, tally })
    }
}
