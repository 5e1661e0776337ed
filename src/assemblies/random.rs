//! Random complex numbers, the same for the same seed.

use nalgebra::{Complex, SVector};

/// A stream of evenly mixed bits: splitmix64 (Steele, Lea and Flood 2014).
#[derive(Clone, Debug)]
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Evenly distributed between -1 and 1.
    fn signed(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as i64 as f64 / (i64::MAX as f64)
    }

    /// Numbers whose real and imaginary parts are evenly distributed between plus and minus `size`.
    pub(crate) fn vector<const N: usize>(&mut self, size: f64) -> SVector<Complex<f64>, N> {
        SVector::from_fn(|_, _| Complex::new(self.signed(), self.signed()) * size)
    }
}
