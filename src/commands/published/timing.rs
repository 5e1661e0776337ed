//! The time of a step.

use std::time::{Duration, Instant};

use crate::kinematics::Kinematics;

/// Measures the time of one step of a millisecond, position, velocity and acceleration, and returns it in words; `None` if the
/// motion is too short to measure, or stops.
pub(super) fn text(mechanism: &dyn Kinematics) -> Option<String> {
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
    let median = passes[passes.len() / 2] / steps;
    Some(format!(
        "Time a step: {:.2} us for position, velocity and acceleration\n             (median of {} passes through the motion in {steps} steps of 1 ms;\n             this build is quick to make, not the fastest: docs/speed.md has the times of others)\n",
        median.as_secs_f64() * 1e6,
        passes.len(),
    ))
}
