//! The motion with which results are compared, followed in fine steps.

use nalgebra::SVector;
use suspension_core::solve::motion::Prescribed;
use suspension_core::step::stepper::Stopped;
use suspension_core::{Inputs, Linkage, Motion, Real, Still};

use suspension::mechanism::{DriveLaws, Suspension, follow};

/// Instants at which the motion is kept.
const KEPT: usize = 4096;

/// A motion in `f64`, known at every time between two.
#[derive(Clone, Debug)]
pub struct Truth<'a, L, const N: usize> {
    /// The linkage.
    pub model: &'a L,
    /// The drives.
    pub drives: &'a DriveLaws,
    /// The first time and the last, the earlier one first, s.
    pub ends: [f64; 2],
    kept: Vec<Motion<f64, N>>,
}

impl<'a, L: Suspension<N>, const N: usize> Truth<'a, L, N> {
    /// Follows the motion from the configuration `start` at the first of `ends`, in either direction.
    ///
    /// # Errors
    ///
    /// [`Stopped`] if the motion ends before.
    pub fn new(
        model: &'a L,
        drives: &'a DriveLaws,
        start: &SVector<f64, N>,
        [first, last]: [f64; 2],
    ) -> Result<Self, Stopped<f64>> {
        let mut motion = Motion::at_rest(*start);
        let mut reached = first;
        let mut kept = Vec::with_capacity(KEPT + 1);
        for index in 0..=KEPT {
            let t = first + (last - first) * index as f64 / KEPT as f64;
            follow(model, drives, [reached, t], &mut motion)?;
            kept.push(motion);
            reached = t;
        }
        if last < first {
            kept.reverse();
        }
        Ok(Self {
            model,
            drives,
            ends: [first.min(last), first.max(last)],
            kept,
        })
    }

    /// Returns the duration of the motion, s.
    pub fn duration(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }

    /// The times at which the motion is kept, s.
    pub fn times(&self) -> impl Iterator<Item = f64> {
        let spacing = self.duration() / KEPT as f64;
        (0..=KEPT).map(move |index| self.ends[0] + spacing * index as f64)
    }

    /// The motion at a time between the ends.
    pub fn at(&self, t: f64) -> Motion<f64, N> {
        let spacing = self.duration() / KEPT as f64;
        let nearest = ((t - self.ends[0]) / spacing).round() as usize;
        let nearest = nearest.min(KEPT);
        let from = self.ends[0] + spacing * nearest as f64;
        let mut motion = self.kept[nearest];
        // The last digits of a time may lie beyond an end at a lock; then the configuration of the end serves.
        match follow(self.model, self.drives, [from, t], &mut motion) {
            Ok(_) => motion,
            Err(_) => self.kept[nearest],
        }
    }
}

/// Returns the largest residual of a configuration, in the unit of length: the errors of the links' lengths and of the
/// drives' values.
pub fn drift<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
    linkage: &L,
    inputs: &Inputs<Still, L::Drives>,
    q: &SVector<T, N>,
) -> f64 {
    let Prescribed { fixed, drives } = Prescribed::new(linkage, inputs);
    let residual = linkage.residual(q, &fixed.value, &drives.value);
    residual.amax().to_subset_unchecked()
}
