//! All assemblies of a mechanism: numerical algebraic geometry.
//!
//! A. J. Sommese and C. W. Wampler 2005, The Numerical Solution of Systems of Polynomials Arising in
//! Engineering and Science. The equations are polynomials; over complex numbers all their roots are
//! connected. A mechanism is assembled part by part. The roots of a part of one general mechanism are found by
//! following random points and going round loops. From there each root leads to a root of the given part, or to infinity.

mod census;
mod factors;
mod family;
mod generic;
mod limits;
mod parallel;
mod parts;
mod path;
mod random;
mod searched;
mod tilt;

use nalgebra::SVector;
use suspension_core::{Inputs, Newton, Still};

use crate::mechanism::Suspension;

pub use census::{PartTally, Tally};
pub use generic::Evidence;
pub use limits::{Stage, Watch};

use factors::Vector;
use family::{complex, parts};
use limits::MOST;
use random::Random;
use searched::Searched;

/// All assemblies of a mechanism at given values of its drives.
#[derive(Clone, Debug, PartialEq)]
pub struct Census<const N: usize> {
    /// The real assemblies, whose residuals were tested.
    pub real: Vec<SVector<f64, N>>,
    /// The outcome for all assemblies.
    pub tally: Tally,
}

/// The search for all assemblies of a mechanism. Its results for general dimensions are used for all values of the
/// drives.
pub struct Assemblies<'a, L: Suspension<N>, const N: usize> {
    model: &'a L,
    near: Vector<N>,
    parts: Vec<Searched<'a, L::Listing, N>>,
    watch: &'a Watch<'a>,
}

impl<'a, L: Suspension<N>, const N: usize> Assemblies<'a, L, N> {
    /// Searches the parts of a mechanism with general dimensions, starting around `near`.
    pub fn new(
        model: &'a L,
        near: &SVector<f64, N>,
        inputs: &Inputs<Still, L::Drives>,
        watch: &'a Watch<'a>,
    ) -> Self {
        const SEED: u64 = 1;
        let mut random = Random::new(SEED);
        let drives = complex(model, inputs);
        let parts = parts::<L::Listing, N>(model, &mut random).into_iter();
        let search = |part| Searched::new(model, part, near, drives, random.clone(), watch);
        Self {
            model,
            near: near.map(Into::into),
            parts: parts.map(search).collect(),
            watch,
        }
    }

    /// All assemblies at values of the drives; `None` if the search is given up.
    pub fn at(&mut self, inputs: &Inputs<Still, L::Drives>) -> Option<Census<N>> {
        let drives = complex(self.model, inputs);
        let mut assemblies = vec![self.near];
        let mut tallies = Vec::new();
        let mut is_cut = false;
        for part in &mut self.parts {
            let (longer, tally) = part.after(&assemblies, drives)?;
            is_cut |= longer.len() > MOST;
            assemblies = longer;
            assemblies.truncate(MOST);
            tallies.extend(tally);
        }
        let mut real = Vec::new();
        for assembly in &assemblies {
            if !(self.watch)(Stage::Follow, real.len()) {
                return None;
            }
            let mut q = assembly.map(|entry| entry.re);
            let confirmed = Newton::near_by().solve(self.model, inputs, &mut q);
            real.extend(confirmed.is_ok().then_some(q));
        }
        let tally = Tally {
            real: real.len(),
            turned: 0,
            unconfirmed: assemblies.len() - real.len(),
            is_cut,
            parts: tallies,
        };
        Some(Census { real, tally })
    }
}
