//! The survey of all methods at all time steps: errors first, then times in rounds.

use std::sync::atomic::{AtomicBool, Ordering};

use suspension_core::Values;

use super::course::Course;
use super::latency::{Latencies, under_load};
use super::method::{ALL_OUTPUTS, Outputs, name_of};
use super::methods::Methods;
use super::reference::Reference;
use super::rows::Row;
use super::timing::Measured;
use super::trial::{Failed, Label, Trial};
use suspension::number::number;
use suspension::output::progress::Progress;

/// The number of measurements.
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
    /// Enough for reliable figures: a minute or two.
    pub fn full() -> Self {
        Self {
            steps: vec![1e-4, 1e-3, 5e-3, 20e-3],
            rounds: 101,
            latencies: 1_000_000,
        }
    }

    /// Enough for a first look: some seconds.
    pub fn quick() -> Self {
        Self {
            steps: vec![5e-3, 20e-3],
            rounds: 7,
            latencies: 20_000,
        }
    }
}

/// The errors of a method at a time step, and the times of a step in each round.
struct Tried<'a> {
    label: Label,
    step: f64,
    trial: Trial<'a>,
    times: Vec<f64>,
}

/// The measured results.
#[derive(Clone, Debug, Default)]
pub struct Survey {
    /// One row per method, number type, time step and output.
    pub rows: Vec<Row>,
    /// The combinations without a row, and the reasons.
    pub missing: Vec<String>,
    /// Times of single steps.
    pub latencies: Vec<Latencies>,
    /// The length of those steps, s.
    pub latency_step: f64,
}

/// The methods whose steps are timed one by one, in `f64`.
const ONE_BY_ONE: [&str; 2] = ["generated", "bounded_1"];

/// Methods, the motion that they go through, and how much is measured.
pub struct Plan<'a, D, const N: usize> {
    /// The methods.
    pub methods: Methods<'a, D, N>,
    /// The motion.
    pub course: &'a Course<D>,
    /// The exact motion.
    pub reference: &'a Reference<N>,
    /// The number of measurements.
    pub effort: &'a Effort,
    /// A metre in the unit of the reference.
    pub metre: f64,
    /// Set if the user interrupts: the results so far are kept.
    pub interrupted: &'a AtomicBool,
}

impl<'a, D: Values<f64>, const N: usize> Plan<'a, D, N> {
    /// Puts every method through the motion at every time step, then times all of them.
    pub fn survey(&self) -> Survey {
        let steps = self.effort.steps.len();
        let each = 1 + ALL_OUTPUTS.len() * self.effort.rounds;
        let mut progress = Progress::new(self.methods.rows.len() * steps * each, "measurements");
        let (mut tried, missing) = self.try_all(&mut progress);
        self.time_all(&mut tried, &mut progress);
        drop(progress);
        let (latency_step, latencies) = self.latencies();
        Survey {
            rows: tried
                .into_iter()
                .filter_map(|tried| row(tried, self.metre))
                .collect(),
            missing,
            latencies,
            latency_step,
        }
    }

    fn is_interrupted(&self) -> bool {
        self.interrupted.load(Ordering::Relaxed)
    }

    fn try_all(&self, progress: &mut Progress) -> (Vec<Tried<'a>>, Vec<String>) {
        let (mut tried, mut missing) = (Vec::new(), Vec::new());
        for candidate in &self.methods.rows {
            for step in &self.effort.steps {
                let stride = self.course.stride(*step);
                let Some(stride) = stride.filter(|_| !self.is_interrupted()) else {
                    continue;
                };
                let label = candidate.label();
                for trial in candidate.try_at(self.course, stride, self.reference) {
                    match trial {
                        Ok(trial) => tried.push(Tried {
                            label: label.clone(),
                            step: *step,
                            trial,
                            times: Vec::new(),
                        }),
                        Err(failed) => missing.push(self.failure(label, *step, failed)),
                    }
                }
                progress.step();
            }
        }
        (tried, missing)
    }

    fn failure(&self, label: &Label, step: f64, (outputs, index): Failed) -> String {
        let Label {
            method,
            scalar,
            lanes,
        } = label;
        format!(
            "{method}, {scalar}, {lanes} at once, {} in steps of {step} s: no configuration within \
             tolerance at t = {} s",
            name_of(outputs),
            number(self.course.times[index])
        )
    }

    /// Times all methods in rounds, so that other load of the machine affects them equally.
    fn time_all(&self, tried: &mut [Tried<'_>], progress: &mut Progress) {
        for _ in 0..self.effort.rounds {
            for Tried { trial, times, .. } in &mut *tried {
                if self.is_interrupted() {
                    return;
                }
                let nanoseconds = trial.batch.run().as_secs_f64() * 1e9;
                times.push(nanoseconds / trial.batch.steps() as f64);
                progress.step();
            }
        }
    }

    /// Measures single steps with the time step nearest to a millisecond.
    fn latencies(&self) -> (f64, Vec<Latencies>) {
        let step = nearest_to(MILLISECOND, self.effort.steps.iter().copied());
        let step = step.unwrap_or(MILLISECOND);
        let Some(stride) = self.course.stride(step) else {
            return (step, Vec::new());
        };
        let mut all = self.one_by_one(stride, 0);
        all.extend(under_load(|threads| self.one_by_one(stride, threads)));
        (step, all)
    }

    fn one_by_one(&self, stride: usize, load: usize) -> Vec<Latencies> {
        let (count, stop) = (self.effort.latencies, self.interrupted);
        let rows = self.methods.rows.iter().filter(|row| {
            let label = row.label();
            let is_plain = (label.scalar, label.lanes) == ("f64", 1);
            is_plain && ONE_BY_ONE.contains(&label.method.as_str())
        });
        let latencies = rows.filter_map(|row| {
            let times = row.latencies(self.course, stride, self.reference, count, stop)?;
            let method = row.label().method.clone();
            (!times.is_empty()).then_some(Latencies {
                method,
                load,
                times,
            })
        });
        latencies.collect()
    }
}

/// The time step that single figures are drawn for, s.
pub const MILLISECOND: f64 = 1e-3;

/// The time step nearest to another by their ratio.
pub fn nearest_to(wanted: f64, steps: impl Iterator<Item = f64>) -> Option<f64> {
    let off = |step: &f64| (step / wanted).ln().abs();
    steps.min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// Returns the row of a trial; `None` if it was not timed.
fn row(tried: Tried<'_>, metre: f64) -> Option<Row> {
    let Tried {
        label,
        step,
        trial,
        times,
    } = tried;
    let time = Measured::of(times)?;
    let error =
        |order: Outputs| (order <= trial.outputs).then_some(trial.errors[order as usize] / metre);
    Some(Row {
        method: label.method,
        scalar: label.scalar.to_owned(),
        lanes: label.lanes,
        step_s: step,
        outputs: name_of(trial.outputs).to_owned(),
        nanoseconds: hundredth(time.median),
        spread_ns: hundredth(time.between_quartiles),
        error_position_m: error(Outputs::Position),
        error_velocity_m_s: error(Outputs::Velocity),
        error_acceleration_m_s2: error(Outputs::Acceleration),
        points: "all".to_owned(),
    })
}

fn hundredth(number: f64) -> f64 {
    (number * 100.0).round() / 100.0
}
