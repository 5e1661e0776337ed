//! A method put to the test: the worst error of a whole motion, and steps to be timed.

use std::marker::PhantomData;
use std::sync::atomic::AtomicBool;

use hdrhistogram::Histogram;
use suspension_core::Named;

use super::course::Course;
use super::latency::latencies;
use super::method::{ALL_OUTPUTS, Method, Outputs};
use super::reference::Reference;
use super::timing::{Batch, Start, Steps, Timed};

/// Steps in a batch, at most: from motions spread evenly over the course.
const BATCH: usize = 96;

/// A method of the chart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The method.
    pub method: String,
    /// The number type.
    pub scalar: &'static str,
    /// Suspensions that a step moves.
    pub lanes: usize,
}

/// What a method did over a course.
pub struct Trial<'a> {
    /// The worst error of position, velocity and acceleration: m, m/s, m/s^2.
    pub errors: [f64; 3],
    /// Steps to time, one batch for each of [`ALL_OUTPUTS`].
    pub batches: [Box<dyn Batch + 'a>; 3],
}

/// A method, whatever its types, over drives `D` and `N` coordinates.
pub trait Candidate<'a, D, const N: usize> {
    /// Its name.
    fn label(&self) -> &Label;

    /// Goes through the course in strides. The error is the index of the instant at which the
    /// method finds no configuration.
    ///
    /// # Errors
    ///
    /// The index of the instant that is out of the method's reach.
    fn try_at(
        &self,
        course: &Course<D>,
        stride: usize,
        reference: &Reference<N>,
    ) -> Result<Trial<'a>, usize>;

    /// Times each of `count` steps to position, velocity and acceleration by itself; `None` where
    /// a step fails.
    fn latencies(
        &self,
        course: &Course<D>,
        stride: usize,
        reference: &Reference<N>,
        count: u64,
        interrupted: &AtomicBool,
    ) -> Option<Histogram<u64>>;
}

/// A method and its label.
#[derive(Debug)]
pub struct Entry<M, D> {
    label: Label,
    method: M,
    drives: PhantomData<D>,
}

impl<M, D> Entry<M, D> {
    /// A method under a name, in a number type.
    pub fn new<const N: usize>(name: &str, scalar: &'static str, method: M) -> Self
    where
        M: Method<D, N>,
    {
        let label = Label {
            method: name.to_owned(),
            scalar,
            lanes: M::LANES,
        };
        let drives = PhantomData;
        Self {
            label,
            method,
            drives,
        }
    }
}

impl<'a, M, D, const N: usize> Candidate<'a, D, N> for Entry<M, D>
where
    M: Method<D, N> + Copy + 'a,
    D: Named<f64> + 'a,
{
    fn label(&self) -> &Label {
        &self.label
    }

    fn try_at(
        &self,
        course: &Course<D>,
        stride: usize,
        reference: &Reference<N>,
    ) -> Result<Trial<'a>, usize> {
        let method = self.method;
        let mut errors = [0.0_f64; 3];
        let mut starts = Vec::new();
        let instants: Vec<usize> = (0..course.times.len()).step_by(stride).collect();
        let every = instants.len().div_ceil(BATCH);
        let [first, ..] = &course.drives[..] else {
            return Err(0);
        };
        let at_first = method.input(first, first);
        let step = |from: &M::State, input: &M::Input, dt: f64, index: usize| {
            method
                .step(Outputs::Acceleration, input, dt, from)
                .ok_or(index)
        };
        let mut state = step(&method.rest(&reference.start()), &at_first, 0.0, 0)?;
        for (step_number, pair) in instants.windows(2).enumerate() {
            let [last, next] = [pair[0], pair[1]];
            let input = method.input(&course.drives[last], &course.drives[next]);
            let dt = course.times[next] - course.times[last];
            if step_number.is_multiple_of(every) {
                starts.push(Start {
                    from: state,
                    input,
                    dt,
                });
            }
            state = step(&state, &input, dt, next)?;
            let found = reference.distance(next, &method.coordinates(&state));
            for (worst, error) in errors.iter_mut().zip(found) {
                *worst = if error.is_nan() {
                    error
                } else {
                    worst.max(error)
                };
            }
        }
        let batches = ALL_OUTPUTS.map(|outputs| -> Box<dyn Batch + 'a> {
            Box::new(Timed::<M, D, N>(Steps {
                method,
                outputs,
                starts: starts.clone(),
            }))
        });
        Ok(Trial { errors, batches })
    }

    fn latencies(
        &self,
        course: &Course<D>,
        stride: usize,
        reference: &Reference<N>,
        count: u64,
        interrupted: &AtomicBool,
    ) -> Option<Histogram<u64>> {
        let rest = self.method.rest(&reference.start());
        latencies(&self.method, &rest, course, stride, count, interrupted)
    }
}
