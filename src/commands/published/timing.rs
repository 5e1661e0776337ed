//! What a step takes.

use std::time::{Duration, Instant};

use suspension_core::{Inputs, Still, Tracker};

use crate::mechanism::{Instants, Mechanism, Suspension};

/// What a step takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Timing {
    /// The median over the passes of a pass' time divided by its steps.
    pub(super) per_step: Duration,
    /// Steps of a pass.
    pub(super) steps: usize,
    /// Passes through the motion.
    pub(super) passes: usize,
}

/// Measures what one step of a millisecond takes: position, velocity and acceleration. `None` where the
/// motion is too short to tell, or stops.
pub(super) fn time_a_step<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
) -> Option<Timing> {
    const STEP: f64 = 1e-3;
    const ENOUGH: Duration = Duration::from_millis(250);
    const PASSES: std::ops::RangeInclusive<usize> = 3..=51;
    let [from, to] = mechanism.instants.ends();
    let dt = STEP.copysign(to - from);
    let instants = Instants::stepped(from, to, dt);
    let inputs: Vec<_> = instants
        .iter()
        .map(|t| mechanism.drives.inputs(t))
        .collect();
    let (first, steps) = inputs.split_first()?;
    let began = Instant::now();
    let mut passes = Vec::new();
    while passes.len() < *PASSES.start()
        || (passes.len() < *PASSES.end() && began.elapsed() < ENOUGH)
    {
        passes.push(timed_pass(mechanism, first, steps, dt)?);
    }
    passes.sort_unstable();
    let steps = u32::try_from(steps.len()).ok().filter(|count| *count > 0)?;
    Some(Timing {
        per_step: passes[passes.len() / 2] / steps,
        steps: steps as usize,
        passes: passes.len(),
    })
}

fn timed_pass<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    first: &Inputs<Still, L::Drives>,
    steps: &[Inputs<Still, L::Drives>],
    dt: f64,
) -> Option<Duration> {
    let tracker = Tracker::default();
    let mut motion = mechanism.start;
    tracker
        .step(&mechanism.model, first, 0.0, &mut motion)
        .ok()?;
    let began = Instant::now();
    for inputs in steps {
        tracker
            .step(&mechanism.model, inputs, dt, &mut motion)
            .ok()?;
    }
    let took = began.elapsed();
    std::hint::black_box(motion);
    Some(took)
}
