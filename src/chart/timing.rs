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

/// Single steps of one method, from motions spread over the course.
#[derive(Debug)]
pub struct Steps<M, S> {
    /// The method.
    pub method: M,
    /// What each step computes.
    pub outputs: Outputs,
    /// Where each step starts.
    pub starts: Vec<S>,
}

/// Where a step starts and what it is given.
#[derive(Clone, Copy, Debug)]
pub struct Start<S, I> {
    /// The motion before the step.
    pub from: S,
    /// The inputs after it.
    pub input: I,
    /// The time between, s.
    pub dt: f64,
}

/// Runs of [`Steps`] over drives `D` and `N` coordinates.
pub struct Timed<M: Method<D, N>, D, const N: usize>(pub Steps<M, Start<M::State, M::Input>>);

impl<M: Method<D, N>, D, const N: usize> Batch for Timed<M, D, N> {
    fn run(&self) -> Duration {
        let Steps {
            method,
            outputs,
            starts,
        } = &self.0;
        let pass = || {
            for Start { from, input, dt } in black_box(starts) {
                black_box(method.step(*outputs, input, *dt, from));
            }
        };
        pass(); // Caches and branch predictors get to know the method.
        let began = Instant::now();
        pass();
        began.elapsed()
    }

    fn steps(&self) -> usize {
        self.0.starts.len() * M::LANES
    }
}

/// A quantity measured repeatedly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Half of the values are smaller.
    pub median: f64,
    /// Between the quartiles lies the middle half of the values.
    pub between_quartiles: f64,
}

impl Measured {
    /// Of values in any order; `None` without any.
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
    fn median_and_quartiles() {
        let measured = Measured::of(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        let expected = Measured {
            median: 3.0,
            between_quartiles: 2.0,
        };
        assert_eq!(measured, Some(expected));
        assert_eq!(Measured::of(Vec::new()), None);
    }
}
