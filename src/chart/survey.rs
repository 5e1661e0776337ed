//! The survey of all methods at all time steps: errors first, then times in rounds.

use std::sync::atomic::{AtomicBool, Ordering};

use suspension_core::Named;

use super::course::Course;
use super::method::Outputs;
use super::methods::Methods;
use super::reference::Reference;
use super::rows::Row;
use super::timing::{Batch, Measured};
use super::trial::Label;
use crate::output::progress::Progress;

/// How much is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Effort {
    /// Time steps, s: multiples of the first.
    pub steps: Vec<f64>,
    /// Times that each batch is run.
    pub rounds: usize,
    /// Steps in the histogram of latencies.
    pub latencies: u64,
}

impl Effort {
    /// For figures to rely on: a minute or two.
    pub fn full() -> Self {
        Self {
            steps: vec![1e-4, 1e-3, 5e-3, 20e-3],
            rounds: 101,
            latencies: 1_000_000,
        }
    }

    /// For a look: some seconds.
    pub fn quick() -> Self {
        Self {
            steps: vec![5e-3, 20e-3],
            rounds: 7,
            latencies: 20_000,
        }
    }
}

/// What is known of a method at a time step.
struct Tried<'a> {
    label: Label,
    step: f64,
    errors: [f64; 3],
    batches: [(Box<dyn Batch + 'a>, Vec<f64>); 3],
}

/// Rows of all that was measured, and what there is no row of, and why.
pub type Surveyed = (Vec<Row>, Vec<String>);

/// Puts every method through the course at every time step. What was measured when the user
/// interrupts is kept.
pub fn survey<D: Named<f64>, const N: usize>(
    methods: &Methods<'_, D, N>,
    course: &Course<D>,
    reference: &Reference<N>,
    effort: &Effort,
    interrupted: &AtomicBool,
) -> Surveyed {
    let stop = || interrupted.load(Ordering::Relaxed);
    let mut progress = Progress::new((methods.rows.len() * effort.steps.len()) + effort.rounds);
    let (mut tried, mut missing) = (Vec::new(), Vec::new());
    for candidate in &methods.rows {
        for step in &effort.steps {
            if stop() {
                break;
            }
            let Some(stride) = course.stride(*step) else {
                continue;
            };
            let label = candidate.label().clone();
            match candidate.try_at(course, stride, reference) {
                Ok(trial) => tried.push(Tried {
                    label,
                    step: *step,
                    errors: trial.errors,
                    batches: trial.batches.map(|batch| (batch, Vec::new())),
                }),
                Err(index) => missing.push(format!(
                    "{} in {}, steps of {} s: no configuration at t = {} s",
                    label.method, label.scalar, step, course.times[index]
                )),
            }
            progress.step();
        }
    }
    // In rounds, so that what else the machine does is shared out evenly.
    for _ in 0..effort.rounds {
        for (batch, times) in tried.iter_mut().flat_map(|tried| &mut tried.batches) {
            if stop() {
                break;
            }
            let nanoseconds = batch.run().as_secs_f64() * 1e9;
            times.push(nanoseconds / batch.steps() as f64);
        }
        progress.step();
    }
    (tried.into_iter().flat_map(rows).collect(), missing)
}

/// The rows of a method at a time step, as far as they were timed.
fn rows(tried: Tried<'_>) -> Vec<Row> {
    let Tried {
        label,
        step,
        errors,
        batches,
    } = tried;
    let timed = Outputs::ALL.into_iter().zip(batches);
    let row = |(outputs, (_, times)): (Outputs, (_, Vec<f64>))| {
        let time = Measured::of(times)?;
        let error = |order: Outputs| (order <= outputs).then_some(errors[order as usize]);
        Some(Row {
            method: label.method.clone(),
            scalar: label.scalar.to_owned(),
            lanes: label.lanes,
            step_s: step,
            outputs: outputs.name().to_owned(),
            nanoseconds: hundredth(time.median),
            spread_ns: hundredth(time.between_quartiles),
            error_position_m: error(Outputs::Position),
            error_velocity_m_s: error(Outputs::Velocity),
            error_acceleration_m_s2: error(Outputs::Acceleration),
        })
    };
    timed.filter_map(row).collect()
}

fn hundredth(number: f64) -> f64 {
    (number * 100.0).round() / 100.0
}
