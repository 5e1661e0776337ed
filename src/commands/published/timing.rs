//! The time of a step.

use std::time::{Duration, Instant};

use crate::kinematics::Kinematics;

/// The measured time of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Timing {
    /// The median over the passes of a pass's time per step.
    pub(super) per_step: Duration,
    /// Steps per pass.
    pub(super) steps: usize,
    /// Passes through the motion.
    pub(super) passes: usize,
}

/// Measures the time of one step of a millisecond: position, velocity and acceleration. Returns `None` if the motion is too
/// short to measure, or stops.
pub(super) fn time_a_step(mechanism: &dyn Kinematics) -> Option<Timing> {
    const STEP: f64 = 1e-3;
    const ENOUGH: Duration = Duration::from_millis(250);
    const PASSES: std::ops::RangeInclusive<usize> = 3..=51;
    let [from, to] = mechanism.instants.ends();
    let dt = STEP.copysign(to - from);
    let began = Instant::now();
    let mut passes = Vec::new();
    let mut steps = 0;
    while passes.len() < *PASSES.start()
        || (passes.len() < *PASSES.end() && began.elapsed() < ENOUGH)
    {
        let (took, count) = mechanism.time_steps(dt)?;
        passes.push(took);
        steps = count;
    }
    passes.sort_unstable();
    Some(Timing {
        per_step: passes[passes.len() / 2] / steps,
        steps: steps as usize,
        passes: passes.len(),
    })
}
