//! Rust rivals and our generated solver, each on the same steps of the published motion.

mod asked;
mod dense;
mod mechanism;
mod ours;
mod rootfinders;

pub use asked::{past_lock, rods};
pub use mechanism::{Inputs, Mechanism, Motion, STEP, Start, Vector};

/// The name and version of a timed method.
pub struct Method {
    pub name: &'static str,
    pub version: &'static str,
    /// Choices that were made.
    pub note: &'static str,
}

/// Times work and keeps its results.
pub trait Stopwatch {
    /// `newton` or `position`: from a start to the next position.
    fn part(&mut self, method: &Method, quantity: &str, work: impl FnMut(&Start) -> Vector);

    /// `step`: from a motion and the inputs of the next instant to the motion there.
    fn step(&mut self, method: &Method, work: impl FnMut(&Motion, &Inputs) -> Motion);
}

/// All methods on all quantities that they offer.
pub fn time_all(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    ours::time(mechanism, watch);
    dense::time_all(mechanism, watch);
    rootfinders::time_all(mechanism, watch);
}
