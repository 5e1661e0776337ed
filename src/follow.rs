//! Following a motion over any distance without leaving its assembly.

use suspension_core::{Advanced, Converged, Motion, Stopped, Tracker};

use crate::drives::DriveLaws;
use crate::study::Suspension;

/// How far a step may move a coordinate, as a part of the linkage's size. Newton's method may
/// converge to another assembly from farther away.
const REACH: f64 = 0.02;

/// Follows the motion from one time to another, in as many steps as it takes.
///
/// # Errors
///
/// [`Stopped`] where the mechanism has no further configuration; the motion is the last good one.
pub fn follow<L: Suspension<N>, const N: usize>(
    model: &L,
    drives: &DriveLaws,
    [from, to]: [f64; 2],
    motion: &mut Motion<f64, N>,
) -> Result<Advanced<f64>, Stopped<f64>> {
    let tracker = Tracker::default();
    let mut total = Advanced {
        steps: 0,
        iterations: 0,
        last: Converged::default(),
    };
    // The rates that a motion brings along may be those of another drive.
    let mut reached = from;
    let mut next = from;
    loop {
        let inputs = |t| drives.inputs(t);
        let advanced = tracker.advance(model, inputs, reached, next, motion)?;
        total.steps += advanced.steps;
        total.iterations += advanced.iterations;
        total.last = advanced.last;
        if next == to {
            return Ok(total);
        }
        reached = next;
        next = within_reach(REACH * model.size(), [reached, to], motion);
    }
}

/// The time, on the way to `to`, until which no coordinate moves by more than `reach`.
fn within_reach<const N: usize>(reach: f64, [from, to]: [f64; 2], motion: &Motion<f64, N>) -> f64 {
    let speed = motion.velocity.amax();
    let acceleration = motion.acceleration.amax();
    // The root of `speed h + acceleration h^2 / 2 = reach`, without cancellation.
    let step = 2.0 * reach / (speed + (speed * speed + 2.0 * acceleration * reach).sqrt());
    let next = from + step.copysign(to - from);
    if (to - from).abs() <= step || next == from {
        to
    } else {
        next
    }
}
