//! Millions of steps back and forth through a motion, which show the drift of a method.

use std::fmt::LowerExp;
use std::marker::PhantomData;

use suspension_core::{Inputs, Linkage, Motion, Real, SolveError, Still, Tracker, Values};

use super::integration::runge_kutta;
use super::method::Method;
use super::rows::LongRow;
use super::survey::Survey;
use super::trial::{cast, inputs};
use super::truth::{Truth, drift};
use suspension::mechanism::{DriveLaws, Suspension};

/// The length of a step, s.
pub const STEP: f64 = 1e-3;

/// The kind of steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Steps of the core's tracker.
    Tracked,
    /// Integration of velocities.
    Integrated,
}

impl Way {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Tracked, Self::Integrated];

    /// The method's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tracked => Method::Stepped.name(),
            Self::Integrated => Method::Integrated.name(),
        }
    }
}

/// A method on its way back and forth.
#[derive(Clone, Debug)]
pub struct LongRun<'a, D, M, T, const N: usize> {
    way: Way,
    model: &'a M,
    drives: &'a DriveLaws,
    /// The drives' names.
    named: PhantomData<D>,
    first: f64,
    step: f64,
    /// The number of steps from one end of the motion to the other.
    leg: u64,
    done: u64,
    motion: Motion<T, N>,
    /// The reason for which the last step failed.
    failed: Option<SolveError<T>>,
}

/// The results of a number of steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stretch {
    /// Steps.
    pub steps: u64,
    /// Iterations of all steps.
    pub iterations: u64,
    /// The largest residual after a step, in the unit of length.
    pub drift: f64,
}

impl<'a, D, M, T, const N: usize> LongRun<'a, D, M, T, N>
where
    D: Values<f64>,
    T: Real,
    M: Linkage<N, Scalar = T>,
{
    /// Starts at the first instant of `truth`.
    pub fn new<L: Suspension<N, Drives = D>>(
        way: Way,
        model: &'a M,
        truth: &Truth<'a, L, N>,
    ) -> Self {
        let step = STEP.min(truth.duration());
        Self {
            way,
            model,
            drives: truth.drives,
            named: PhantomData,
            first: truth.ends[0],
            step,
            leg: (truth.duration() / step) as u64,
            done: 0,
            motion: cast(&truth.at(truth.ends[0])),
            failed: None,
        }
    }

    /// Makes `steps` more steps; fewer if one fails.
    pub fn advance(&mut self, steps: u64) -> Stretch {
        let mut stretch = Stretch::default();
        while stretch.steps < steps {
            let times = [self.done, self.done + 1].map(|step| self.time(step));
            let inputs = |t: T| inputs::<_, D, _>(self.drives, t);
            let iterations = match self.step(inputs, times.map(T::constant)) {
                Ok(iterations) => iterations,
                Err(error) => {
                    self.failed = Some(error);
                    break;
                }
            };
            let [_, to] = times.map(T::constant);
            let off = drift(self.model, &inputs(to), &self.motion.position);
            stretch.drift = stretch.drift.max(off);
            stretch.iterations += iterations;
            stretch.steps += 1;
            self.done += 1;
        }
        stretch
    }

    /// The time after a number of steps.
    fn time(&self, step: u64) -> f64 {
        let there_and_back = step % (2 * self.leg);
        let away = there_and_back.min(2 * self.leg - there_and_back);
        self.first + self.step * away as f64
    }
}

impl<D, M, T, const N: usize> LongRun<'_, D, M, T, N>
where
    T: Real,
    M: Linkage<N, Scalar = T>,
{
    /// Makes one step and returns the number of its iterations.
    fn step(
        &mut self,
        inputs: impl Fn(T) -> Inputs<Still, M::Drives>,
        [from, to]: [T; 2],
    ) -> Result<u64, SolveError<T>> {
        let Self { model, motion, .. } = self;
        match self.way {
            Way::Tracked => {
                let converged = Tracker::default().step(*model, &inputs(to), to - from, motion);
                converged.map(|converged| converged.iterations as u64)
            }
            Way::Integrated => {
                motion.position = runge_kutta(*model, inputs, [from, to], &motion.position)?;
                Ok(0)
            }
        }
    }
}

/// The number of steps between two checks for an interrupt.
const A_LOOK: u64 = 100_000;

/// Returns the number of checks in a run.
pub fn looks(steps: u64) -> usize {
    (steps / A_LOOK) as usize
}

/// Makes as many steps as the survey wants, with a row wherever their number has doubled or so,
/// from a thousand on. Where a step fails or the user interrupts, the last row says so.
pub fn add<D, M, T, const N: usize>(
    survey: &mut Survey<'_>,
    closure: &str,
    mut run: LongRun<'_, D, M, T, N>,
) where
    T: Real + LowerExp,
    M: Linkage<N, Scalar = T>,
    D: Values<f64>,
{
    for stop in milestones(survey.effort.long_run) {
        let mut all = Stretch::default();
        let mut ended = String::new();
        while run.done < stop && ended.is_empty() {
            let steps = (stop - run.done).min(A_LOOK);
            let stretch = run.advance(steps);
            all.steps += stretch.steps;
            all.iterations += stretch.iterations;
            all.drift = all.drift.max(stretch.drift);
            survey.progress.step();
            if let Some(error) = &run.failed {
                ended = format!("no further step: {}", error.named(run.model));
            } else if survey.is_interrupted() {
                "interrupted".clone_into(&mut ended);
            }
        }
        let is_last = !ended.is_empty();
        survey.counted.long_runs.push(LongRow {
            method: run.way.name().to_owned(),
            closure: closure.to_owned(),
            scalar: std::any::type_name::<T>().to_owned(),
            steps: run.done,
            drift_m: all.drift / survey.metre,
            iterations_a_step: all.iterations as f64 / all.steps.max(1) as f64,
            ended,
        });
        if is_last {
            return;
        }
    }
}

/// 1, 2 and 5 times the powers of ten from a thousand on, and the total.
fn milestones(total: u64) -> impl Iterator<Item = u64> {
    let decades = (3..).map(|exponent| 10_u64.saturating_pow(exponent));
    let all = decades.flat_map(|decade| [1, 2, 5].map(|k| decade.saturating_mul(k)));
    let last = (total > 0).then_some(total);
    all.take_while(move |steps| *steps < total).chain(last)
}

#[cfg(test)]
mod tests {
    use super::milestones;

    #[test]
    fn a_long_run_has_rows_at_1_2_5_times_powers_of_ten_steps() {
        let rows: Vec<u64> = milestones(12_000).collect();
        assert_eq!(rows, [1_000, 2_000, 5_000, 10_000, 12_000]);
        assert_eq!(milestones(0).count(), 0);
        assert_eq!(milestones(u64::MAX).last(), Some(u64::MAX));
    }
}
