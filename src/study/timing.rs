//! What a step takes.

use std::time::{Duration, Instant};

use suspension_core::{Inputs, Still, Tracker};

use crate::input::instants::Instants;
use crate::study::{Assembled, Suspension};

/// What a step takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// The median over the passes of a pass' time divided by its steps.
    pub per_step: Duration,
    /// Steps of a pass.
    pub steps: usize,
    /// Passes through the motion.
    pub passes: usize,
}

/// See [`Study::time_a_step`](crate::study::Study::time_a_step).
pub(super) fn time_a_step<L: Suspension<N>, const N: usize>(
    assembled: &Assembled<L, N>,
    ends: [f64; 2],
) -> Option<Timing> {
    const STEP: f64 = 1e-3;
    const ENOUGH: Duration = Duration::from_millis(250);
    const PASSES: std::ops::RangeInclusive<usize> = 3..=51;
    let instants = Instants::stepped(ends[0], ends[1], STEP.copysign(ends[1] - ends[0]));
    let inputs: Vec<_> = instants
        .iter()
        .map(|t| assembled.drives.inputs(t))
        .collect();
    let (first, steps) = inputs.split_first()?;
    let dt = STEP.copysign(ends[1] - ends[0]);
    let began = Instant::now();
    let mut passes = Vec::new();
    while passes.len() < *PASSES.start()
        || (passes.len() < *PASSES.end() && began.elapsed() < ENOUGH)
    {
        passes.push(timed_pass(assembled, first, steps, dt)?);
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
    assembled: &Assembled<L, N>,
    first: &Inputs<Still, L::Drives>,
    steps: &[Inputs<Still, L::Drives>],
    dt: f64,
) -> Option<Duration> {
    let tracker = Tracker::default();
    let mut motion = assembled.start;
    tracker
        .step(&assembled.model, first, 0.0, &mut motion)
        .ok()?;
    let began = Instant::now();
    for inputs in steps {
        tracker
            .step(&assembled.model, inputs, dt, &mut motion)
            .ok()?;
    }
    let took = began.elapsed();
    std::hint::black_box(motion);
    Some(took)
}
