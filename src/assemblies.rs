//! All assemblies of a mechanism: numerical algebraic geometry.
//!
//! A. J. Sommese and C. W. Wampler 2005, The Numerical Solution of Systems of Polynomials Arising in
//! Engineering and Science. The equations are polynomials; over complex numbers all their roots hang
//! together. The roots of one general mechanism are found by following random points and going round
//! loops; from there each leads to a root of the mechanism at hand, or to infinity.

mod census;
mod family;
mod generic;
mod listed;
mod parallel;
mod path;
mod random;
mod report;

use nalgebra::{Const, DimMin, SVector};
use suspension_core::{Inputs, Linkage, Listing, Still};

pub use census::{Census, Tally};
pub use generic::Evidence;
pub use listed::{Assembly, Listed, OnListed, Wish, list};
pub use report::{columns, rows, text};

use family::{Family, complex};
use generic::Generic;

/// A model of a listing, whose equations can be taken over complex numbers.
pub trait Enumerable<const N: usize>:
    Linkage<N, Scalar = f64, Listing: Listing<N, Model<f64> = Self>>
{
}

impl<L, const N: usize> Enumerable<N> for L where
    L: Linkage<N, Scalar = f64, Listing: Listing<N, Model<f64> = L>>
{
}

/// The search for all assemblies of a mechanism. What it finds out about general lengths serves all
/// values of the drives.
pub struct Assemblies<'a, L: Enumerable<N>, const N: usize> {
    model: &'a L,
    generic: Generic<L::Listing, N>,
}

impl<'a, L: Enumerable<N>, const N: usize> Assemblies<'a, L, N>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    /// Searches a mechanism of general lengths, starting around `near`.
    pub fn new(model: &'a L, near: &SVector<f64, N>, inputs: &Inputs<Still, L::Drives>) -> Self {
        const SEED: u64 = 1;
        let family = Family::new(model);
        let generic = Generic::new(family, near, complex(model, inputs), SEED);
        Self { model, generic }
    }

    /// All assemblies at values of the drives.
    pub fn at(&mut self, inputs: &Inputs<Still, L::Drives>) -> Census<N> {
        census::census(&mut self.generic, self.model, inputs)
    }
}
