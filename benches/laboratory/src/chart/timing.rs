//! The time of a step: batches over the motion, repeated.

use std::hint::black_box;
use std::time::{Duration, Instant};

use super::method::{Method, Outputs};

/// Steps that can be timed again and again.
pub trait Batch {
    /// Makes all steps once and says how long they took.
    fn run(&self) -> Duration;

    /// Suspensions moved by a run, once each.
    fn steps(&self) -> usize;
}

/// The start and the input of a step.
#[derive(Clone, Copy, Debug)]
pub struct Start<S, I> {
    /// The motion before the step.
    pub from: S,
    /// The inputs.
    pub input: I,
    /// The length of the step, s.
    pub dt: f64,
}

impl<S: Copy, I: Copy> Start<S, I> {
    /// Makes the step; `None` if the method finds no configuration.
    #[inline(always)]
    pub fn step<M, D, const N: usize>(&self, method: &M, outputs: Outputs) -> Option<S>
    where
        M: Method<D, N, State = S, Input = I>,
    {
        method.step(outputs, &self.input, self.dt, &self.from)
    }
}

/// Single steps of one method, from motions spread over the course.
pub struct Steps<M: Method<D, N>, D, const N: usize> {
    /// The method.
    pub method: M,
    /// The outputs of each step.
    pub outputs: Outputs,
    /// The start of each step.
    pub starts: Vec<Start<M::State, M::Input>>,
}

impl<M: Method<D, N>, D, const N: usize> Batch for Steps<M, D, N> {
    fn run(&self) -> Duration {
        let pass = || {
            for start in black_box(&self.starts) {
                black_box(start.step(&self.method, self.outputs));
            }
        };
        pass(); // Caches and branch predictors get to know the method.
        let began = Instant::now();
        pass();
        began.elapsed()
    }

    fn steps(&self) -> usize {
        self.starts.len()
    }
}

/// A quantity measured repeatedly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Half of the values are smaller.
    pub median: f64,
    /// The distance between the quartiles.
    pub between_quartiles: f64,
}

impl Measured {
    /// Computes the statistics of values in any order; `None` without any.
    pub fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_unstable_by(f64::total_cmp);
        let last = values.len().checked_sub(1)?;
        let quantile = |part: f64| {
            let place = part * last as f64;
            let (below, above) = (place.floor(), place.ceil());
            let [low, high] = [below, above].map(|place| values[place as usize]);
            low + (high - low) * (place - below)
        };
        Some(Self {
            median: quantile(0.5),
            between_quartiles: quantile(0.75) - quantile(0.25),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn timings_are_summarised_by_median_and_quartiles() {
        let measured = Measured::of(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        let expected = Measured {
            median: 3.0,
            between_quartiles: 2.0,
        };
        assert_eq!(measured, Some(expected));
        assert_eq!(Measured::of(Vec::new()), None);
    }
}
