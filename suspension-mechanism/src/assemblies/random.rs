//! Random complex vectors, the same for the same seed.

use nalgebra::{Complex, SVector};
use rand_distr::{Distribution, StandardUniform};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

#[derive(Clone, Debug)]
pub(crate) struct Random(Pcg64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(Pcg64::seed_from_u64(seed))
    }

    /// Numbers whose real and imaginary parts are evenly distributed between plus and minus `size`.
    pub(crate) fn vector<const N: usize>(&mut self, size: f64) -> SVector<Complex<f64>, N> {
        let mut signed = || {
            let even: f64 = StandardUniform.sample(&mut self.0);
            even * 2.0 - 1.0
        };
        SVector::from_fn(|_, _| Complex::new(signed(), signed()) * size)
    }
}
