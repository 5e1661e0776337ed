//! The trial of a method: the worst error of a whole motion, and steps to be timed.

use std::marker::PhantomData;
use std::sync::atomic::AtomicBool;

use hdrhistogram::Histogram;
use suspension_core::Values;

use super::course::Course;
use super::latency::latencies;
use super::method::{ALL_OUTPUTS, Method, Outputs};
use super::reference::Reference;
use super::timing::{Batch, Start, Steps};

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

/// The results of a method over a course.
pub struct Trial<'a> {
    /// The outputs of its steps.
    pub outputs: Outputs,
    /// The worst error of position, velocity and acceleration, in the unit of the reference.
    pub errors: [f64; 3],
    /// Steps to time.
    pub batch: Box<dyn Batch + 'a>,
}

/// The requested outputs, and the index of the instant at which a step failed.
pub type Failed = (Outputs, usize);

/// A method, whatever its types, over drives `D` and `N` coordinates.
pub trait Candidate<'a, D, const N: usize> {
    /// Its name.
    fn label(&self) -> &Label;

    /// Goes through the course in strides, for each of [`ALL_OUTPUTS`].
    fn try_at(
        &self,
        course: &Course<D>,
        stride: usize,
        reference: &Reference<N>,
    ) -> Vec<Result<Trial<'a>, Failed>>;

    /// Times each of `count` steps to position, velocity and acceleration; `None` if a step fails.
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
            lanes: 1,
        };
        let drives = PhantomData;
        Self {
            label,
            method,
            drives,
        }
    }
}

/// The worst errors of a method over a course, and starts of its steps.
struct Followed<S, I> {
    errors: [f64; 3],
    starts: Vec<Start<S, I>>,
}

/// Goes through a course in strides. The error is the index of the instant at which the method
/// finds no configuration.
fn follow<M: Method<D, N>, D, const N: usize>(
    method: &M,
    outputs: Outputs,
    course: &Course<D>,
    stride: usize,
    reference: &Reference<N>,
) -> Result<Followed<M::State, M::Input>, usize> {
    let instants: Vec<usize> = (0..course.times.len()).step_by(stride).collect();
    let every = instants.len().div_ceil(BATCH);
    let (mut errors, mut starts) = ([0.0_f64; 3], Vec::new());
    let first = course.drives.first().ok_or(0_usize)?;
    let begin = Start {
        from: method.rest(&reference.start()),
        input: method.input(first, first),
        dt: 0.0,
    };
    let mut from = begin.step(method, Outputs::Acceleration).ok_or(0_usize)?;
    for (number, ends) in instants.windows(2).enumerate() {
        let [last, next] = [ends[0], ends[1]];
        let start = Start {
            from,
            input: method.input(&course.drives[last], &course.drives[next]),
            dt: course.times[next] - course.times[last],
        };
        if number.is_multiple_of(every) {
            starts.push(start);
        }
        from = start.step(method, outputs).ok_or(next)?;
        let found = reference.distance(next, &method.coordinates(&from));
        if !found.iter().all(|error| error.is_finite()) {
            return Err(next);
        }
        for (worst, error) in errors.iter_mut().zip(found) {
            *worst = worst.max(error);
        }
    }
    Ok(Followed { errors, starts })
}

impl<'a, M, D, const N: usize> Candidate<'a, D, N> for Entry<M, D>
where
    M: Method<D, N> + Copy + 'a,
    D: Values<f64> + 'a,
{
    fn label(&self) -> &Label {
        &self.label
    }

    fn try_at(
        &self,
        course: &Course<D>,
        stride: usize,
        reference: &Reference<N>,
    ) -> Vec<Result<Trial<'a>, Failed>> {
        let tried = ALL_OUTPUTS.map(|outputs| {
            let on_the_way = self.method.on_the_way(outputs);
            let followed = follow(&self.method, on_the_way, course, stride, reference);
            let Followed { errors, starts } = followed.map_err(|at| (outputs, at))?;
            let batch: Box<dyn Batch + 'a> = Box::new(Steps::<M, D, N> {
                method: self.method,
                outputs,
                starts,
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
