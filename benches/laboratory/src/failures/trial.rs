//! A trial: a method that starts at a known configuration and aims at another one.

use nalgebra::SVector;
use suspension_core::{Build, Inputs, Motion, Real, Still, Values};

use super::marquardt::Number;
use super::method::{Method, Step};
use super::outcome::{Outcome, judged};
use super::truth::{Truth, drift};
use crate::chart::course::cast_drives;
use crate::chart::formulation::to_f64;
use suspension::mechanism::DriveLaws;
use suspension::mechanism::Suspension;

/// A single step.
pub struct Trial<'a, const N: usize> {
    /// The drives.
    pub drives: &'a DriveLaws,
    /// Start and end, s.
    pub times: [f64; 2],
    /// The motion at the start.
    pub start: Motion<f64, N>,
    /// The intended configuration at the end.
    pub meant: SVector<f64, N>,
    /// The largest permitted error of a coordinate there.
    pub tolerance: f64,
}

impl<const N: usize> Trial<'_, N> {
    /// Returns the outcome and the residual of the result.
    pub fn outcome<T, M, D>(&self, method: Method, model: &M) -> (Outcome, f64)
    where
        T: Number,
        M: Build<N, Scalar = T>,
        D: Values<f64>,
    {
        let start = cast(&self.start);
        match step::<_, _, D, N>(method, model, self.drives, self.times, &start) {
            None => (Outcome::NoRoot, 0.0),
            Some((found, residual)) => {
                let found = to_f64(found.position);
                (judged(&found, &self.meant, self.tolerance), residual)
            }
        }
    }
}

/// A run through a whole motion, forwards or backwards.
pub struct Run<'a, L, const N: usize> {
    /// The motion.
    pub truth: &'a Truth<'a, L, N>,
    /// The length of the steps, s; negative backwards.
    pub step: f64,
    /// The start between the first two instants, from 0 to 1.
    pub phase: f64,
    /// The largest permitted error of a coordinate.
    pub tolerance: f64,
}

impl<L: Suspension<N>, const N: usize> Run<'_, L, N> {
    /// Returns the outcome and the largest residual: right only if every step is.
    pub fn outcome<T, M>(&self, method: Method, model: &M) -> (Outcome, f64)
    where
        T: Number,
        M: Build<N, Scalar = T>,
    {
        let (start, count) = self.instants();
        let mut motion = cast(&self.truth.at(start));
        let mut largest = 0.0_f64;
        for index in 0..count {
            let times = [index, index + 1].map(|index| start + self.step * index as f64);
            let drives = self.truth.drives;
            let next = step::<_, _, L::Drives, N>(method, model, drives, times, &motion);
            let Some((next, residual)) = next else {
                return (Outcome::NoRoot, largest);
            };
            largest = largest.max(residual);
            let meant = self.truth.at(times[1]).position;
            let outcome = judged(&to_f64(next.position), &meant, self.tolerance);
            if outcome != Outcome::Right {
                return (outcome, largest);
            }
            motion = next;
        }
        (Outcome::Right, largest)
    }

    /// The first instant, and how many steps there are from it.
    fn instants(&self) -> (f64, usize) {
        /// The part of a step that rounding may take from the last one.
        const SLACK: f64 = 1e-9;
        let (duration, length) = (self.truth.duration(), self.step.abs());
        let later = self.phase * length.min(duration - length);
        let [first, last] = self.truth.ends;
        let start = if self.step > 0.0 {
            first + later
        } else {
            last - later
        };
        (start, ((duration - later) / length + SLACK) as usize)
    }
}

/// The result of a step and its residual.
fn step<T, M, D, const N: usize>(
    method: Method,
    model: &M,
    drives: &DriveLaws,
    times: [f64; 2],
    start: &Motion<T, N>,
) -> Option<(Motion<T, N>, f64)>
where
    T: Number,
    M: Build<N, Scalar = T>,
    D: Values<f64>,
{
    let inputs = |t: T| inputs::<_, D, _>(drives, t);
    let step = Step {
        inputs: &inputs,
        times: times.map(T::constant),
    };
    let found = method.step(model, &step, start)?;
    let residual = drift(model, &inputs(step.times[1]), &found.position);
    Some((found, residual))
}

/// The drives at a time, computed in `f64`.
pub fn inputs<T: Real, D: Values<f64>, E: Values<T>>(drives: &DriveLaws, t: T) -> Inputs<Still, E> {
    let exact = drives.inputs::<D>(t.to_subset_unchecked());
    Inputs::still(cast_drives(&exact.drives))
}

/// The same motion in another number type.
pub fn cast<T: Real, const N: usize>(motion: &Motion<f64, N>) -> Motion<T, N> {
    let cast = |vector: &SVector<f64, N>| vector.map(T::constant);
    Motion {
        position: cast(&motion.position),
        velocity: cast(&motion.velocity),
        acceleration: cast(&motion.acceleration),
        positive_determinant: motion.positive_determinant,
    }
}
