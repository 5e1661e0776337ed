//! Random vectors, the same for the same seed.

use nalgebra::SVector;

/// splitmix64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Evenly distributed between 0 and 1.
    pub(crate) fn even(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number from a normal distribution (Box and Muller).
    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.even()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.even()).cos()
    }

    /// Gaussian noise on all coordinates.
    pub(crate) fn noise<const N: usize>(&mut self, sigma: f64) -> SVector<f64, N> {
        SVector::from_fn(|_, _| sigma * self.normal())
    }

    /// Evenly distributed in a box.
    pub(crate) fn within<const N: usize>(&mut self, half_width: f64) -> SVector<f64, N> {
        SVector::from_fn(|_, _| half_width * (2.0 * self.even() - 1.0))
    }
}
