//! Bounded steps of several suspensions at once, with the best instructions of the processor.

use std::hint::black_box;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use hdrhistogram::Histogram;
use suspension_core::step::bounded::Outputs;
use suspension_core::{Listing, Motion, Signal};

use super::course::{Course, cast_drives};
use super::formulation::to_f64;
use super::method::ALL_OUTPUTS;
use super::reference::Reference;
use super::timing::Batch;
use super::trial::{Candidate, Failed, Label, Trial};
use suspension_lanes::{Lane, Lanes};

/// Makes lanes at motions of one model each.
type Make<G, T, const N: usize, const LANES: usize> =
    fn([<G as Listing<N>>::Model<T>; LANES], &[Motion<T, N>; LANES]) -> Lanes<G, T, N, LANES>;

/// The same suspension in every lane.
pub struct InLanes<'a, G: Listing<N>, T: Lane, const N: usize, const LANES: usize> {
    label: Label,
    model: &'a G::Model<T>,
    make: Make<G, T, N, LANES>,
}

impl<'a, G, T, const N: usize, const LANES: usize> InLanes<'a, G, T, N, LANES>
where
    G: Listing<N>,
    T: Lane,
{
    /// Lanes under the name of the method that they run.
    pub fn new(method: &str, model: &'a G::Model<T>, make: Make<G, T, N, LANES>) -> Self {
        let label = Label {
            method: method.to_owned(),
            scalar: std::any::type_name::<T>(),
            lanes: LANES,
        };
        Self { label, model, make }
    }

    /// Moves through the course; returns the worst errors and the starts of runs. Velocities and accelerations that steps do
    /// not compute are estimates, from which the next step starts.
    fn follow(
        &self,
        outputs: Outputs,
        dt: T,
        course: &Course<G::Drives<f64>>,
        stride: usize,
        reference: &Reference<N>,
    ) -> Result<Followed<G, T, N>, usize> {
        let instants: Vec<usize> = (0..course.times.len()).step_by(stride).collect();
        let cast = |index: &usize| cast_drives(&course.drives[*index].signal);
        let drives: Vec<Signal<G::Drives<T>>> = instants.iter().map(cast).collect();
        let every = instants.len().div_ceil(RUNS);
        let (mut errors, mut runs) = ([0.0_f64; 3], Vec::new());
        let mut lanes = self.at(&Motion::at_rest(reference.start().map(T::constant)));
        let first = drives.first().ok_or(0_usize)?;
        let begun = lanes.step(Outputs::Acceleration, &[*first; LANES], T::zero());
        if begun.iter().any(Result::is_err) {
            return Err(0);
        }
        for (number, (index, given)) in instants.iter().zip(&drives).enumerate().skip(1) {
            let from = lanes.motion(0);
            if (number - 1).is_multiple_of(every) {
                let drives = drives[number..].iter().take(RUN).copied().collect();
                runs.push(Run { from, drives });
            }
            let stepped = lanes.step(outputs, &[*given; LANES], dt);
            let to = lanes.motion(0);
            let found = [to.position, to.velocity, to.acceleration].map(to_f64);
            let found = reference.distance(*index, &found);
            if stepped.iter().any(Result::is_err) || !found.iter().all(|e| e.is_finite()) {
                return Err(*index);
            }
            for (worst, error) in errors.iter_mut().zip(found) {
                *worst = worst.max(error);
            }
        }
        Ok((errors, runs))
    }

    fn at(&self, motion: &Motion<T, N>) -> Lanes<G, T, N, LANES> {
        (self.make)([*self.model; LANES], &[*motion; LANES])
    }
}

/// Runs of consecutive steps: lanes keep their motions.
struct Runs<'a, G: Listing<N>, T: Lane, const N: usize, const LANES: usize> {
    lanes: InLanes<'a, G, T, N, LANES>,
    outputs: Outputs,
    dt: T,
    runs: Vec<Run<T, G::Drives<T>, N>>,
}

/// The start of a run, and the drives of each step.
struct Run<T, D, const N: usize> {
    from: Motion<T, N>,
    drives: Vec<Signal<D>>,
}

/// Worst errors, and runs to time.
type Followed<G, T, const N: usize> = ([f64; 3], Vec<Run<T, <G as Listing<N>>::Drives<T>, N>>);

/// The number of runs in a batch, and of steps in each.
const RUNS: usize = 8;
const RUN: usize = 12;

impl<G, T, const N: usize, const LANES: usize> Batch for Runs<'_, G, T, N, LANES>
where
    G: Listing<N>,
    T: Lane,
{
    fn run(&self) -> Duration {
        let timed = |run: &Run<T, G::Drives<T>, N>| {
            let mut lanes = self.lanes.at(&run.from);
            let began = Instant::now();
            for drives in black_box(&run.drives) {
                let _ = black_box(lanes.step(self.outputs, &[*drives; LANES], self.dt));
            }
            began.elapsed()
        };
        for run in &self.runs {
            timed(run); // Caches and branch predictors get to know the method.
        }
        self.runs.iter().map(timed).sum()
    }

    fn steps(&self) -> usize {
        let steps: usize = self.runs.iter().map(|run| run.drives.len()).sum();
        steps * LANES
    }
}

impl<'a, G, T, const N: usize, const LANES: usize> Candidate<'a, G::Drives<f64>, N>
    for InLanes<'a, G, T, N, LANES>
where
    G: Listing<N> + 'a,
    T: Lane + 'a,
{
    fn label(&self) -> &Label {
        &self.label
    }

    fn try_at(
        &self,
        course: &Course<G::Drives<f64>>,
        stride: usize,
        reference: &Reference<N>,
    ) -> Vec<Result<Trial<'a>, Failed>> {
        let dt = T::constant(course.times[stride] - course.times[0]);
        let tried = ALL_OUTPUTS.map(|outputs| {
            let followed = self.follow(outputs, dt, course, stride, reference);
            let (errors, runs) = followed.map_err(|at| (outputs, at))?;
            let lanes = Self::new(&self.label.method, self.model, self.make);
            let batch: Box<dyn Batch + 'a> = Box::new(Runs {
                lanes,
                outputs,
                dt,
                runs,
            });
            Ok(Trial {
                outputs,
                errors,
                batch,
            })
        });
        tried.into()
    }

    fn latencies(
        &self,
        _: &Course<G::Drives<f64>>,
        _: usize,
        _: &Reference<N>,
        _: u64,
        _: &AtomicBool,
    ) -> Option<Histogram<u64>> {
        None
    }
}
