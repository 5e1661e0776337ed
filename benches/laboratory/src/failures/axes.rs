//! The varied quantities: noise of the start, length of the steps, distance from a turning point.

use nalgebra::SVector;
use rand_distr::{Distribution, StandardNormal, StandardUniform};
use rand_pcg::Pcg64;
use suspension_core::{Build, Motion};

use super::marquardt::Number;
use super::method::Method;
use super::rows::Axis;
use super::survey::{Place, Survey};
use super::trial::{Run, Trial};
use super::truth::Truth;
use super::turning::{Approach, TurningPoint, unit_of_first_drive};
use suspension::mechanism::Suspension;

/// Deviations of a start, m.
pub const NOISES: [f64; 11] = [
    1e-3, 2e-3, 3e-3, 5e-3, 10e-3, 20e-3, 30e-3, 50e-3, 0.1, 0.2, 0.4,
];

/// Lengths of steps through the motion, s.
pub const STEPS: [f64; 13] = [
    1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 10e-3, 20e-3, 50e-3, 0.1, 0.2, 0.5, 1.0,
];

/// Distances from a turning point, in the drive's unit.
pub const DISTANCES: [f64; 12] = [
    1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12,
];

/// Points of all axes, for one model.
pub const POINTS: usize = (NOISES.len() + STEPS.len() + DISTANCES.len()) * Method::ALL.len();

/// The largest error of a coordinate of a right result, m.
pub const RIGHT_WITHIN: f64 = 1e-4;

/// The most steps per point: with short steps there are fewer runs.
const STEPS_A_POINT: f64 = 1e5;

/// A model in the number type of the trials, with the exact motion.
pub struct Subject<'a, L, M, const N: usize> {
    /// The formulation of bodies.
    pub closure: &'a str,
    /// The motion.
    pub truth: &'a Truth<'a, L, N>,
    /// Turning points of the first drive.
    pub turning_points: &'a [TurningPoint<N>],
    /// The model.
    pub model: &'a M,
}

impl<'a, L, M, const N: usize> Subject<'a, L, M, N> {
    /// Returns the subject with the model in another number type.
    pub fn with_model<K>(&self, model: &'a K) -> Subject<'a, L, K, N> {
        Subject {
            closure: self.closure,
            truth: self.truth,
            turning_points: self.turning_points,
            model,
        }
    }
}

impl<T, L, M, const N: usize> Subject<'_, L, M, N>
where
    T: Number,
    L: Suspension<N>,
    M: Build<N, Scalar = T>,
{
    /// Tries every method along every axis.
    pub fn try_all(&self, survey: &mut Survey<'_>) {
        self.try_noises(survey);
        self.try_steps(survey);
        self.try_distances(survey);
    }

    fn place(&self, axis: Axis, value: f64) -> Place<'_> {
        Place {
            closure: self.closure,
            scalar: std::any::type_name::<T>(),
            axis,
            value,
            unit: match axis {
                Axis::Step => "s",
                _ => "m",
            },
        }
    }

    /// Tries every method from starts near the motion.
    pub fn try_noises(&self, survey: &mut Survey<'_>) {
        for (index, noise) in NOISES.into_iter().enumerate() {
            if survey.is_interrupted() {
                return;
            }
            let mut random = survey.random(Axis::StartNoise, index);
            let metre = survey.metre;
            let start = |_| self.noisy(noise * metre, RIGHT_WITHIN * metre, &mut random);
            let trials: Vec<Trial<'_, N>> = (0..survey.effort.starts).map(start).collect();
            let place = self.place(Axis::StartNoise, noise);
            for method in Method::ALL.into_iter().filter(|it| it.takes_guesses()) {
                survey.count(&place, method, &trials, |trial| {
                    trial.outcome::<_, _, L::Drives>(method, self.model)
                });
            }
        }
    }

    /// Returns a trial that starts near the motion at a random instant.
    fn noisy(&self, noise: f64, tolerance: f64, random: &mut Pcg64) -> Trial<'_, N> {
        let t = self.truth.ends[0] + self.truth.duration() * uniform(random);
        let meant = self.truth.at(t).position;
        let off = SVector::from_fn(|_, _| {
            let normal: f64 = StandardNormal.sample(random);
            noise * normal
        });
        Trial {
            drives: self.truth.drives,
            times: [t, t],
            start: Motion::at_rest(meant + off),
            meant,
            tolerance,
        }
    }

    /// Tries every method through the whole motion.
    pub fn try_steps(&self, survey: &mut Survey<'_>) {
        let duration = self.truth.duration();
        let steps = STEPS.into_iter().filter(|step| *step <= duration);
        for (index, length) in steps.enumerate() {
            if survey.is_interrupted() {
                return;
            }
            let mut random = survey.random(Axis::Step, index);
            let few = (STEPS_A_POINT * length / duration).ceil() as usize;
            let count = survey.effort.starts.div_ceil(10).min(few);
            let run = |run: usize| Run {
                truth: self.truth,
                step: if run.is_multiple_of(2) {
                    length
                } else {
                    -length
                },
                phase: uniform(&mut random),
                tolerance: RIGHT_WITHIN * survey.metre,
            };
            let runs: Vec<Run<'_, L, N>> = (0..count).map(run).collect();
            let place = self.place(Axis::Step, length);
            for method in Method::ALL {
                survey.count(&place, method, &runs, |run| run.outcome(method, self.model));
            }
        }
    }

    /// Tries every method in a step that ends near a turning point.
    pub fn try_distances(&self, survey: &mut Survey<'_>) {
        /// The shortest step, s, and how many powers of ten the longest is above it.
        const SHORTEST: f64 = 1e-3;
        const DECADES: f64 = 2.0;
        let (unit, metre) = unit_of_first_drive(self.model, survey.metre);
        for (index, distance) in DISTANCES.into_iter().enumerate() {
            if survey.is_interrupted() {
                return;
            }
            let mut random = survey.random(Axis::TurningPoint, index);
            let distance_here = distance * metre;
            let approaches: Vec<Approach<'_, N>> = self
                .turning_points
                .iter()
                .filter(|point| point.is_apart::<T, L>(self.truth.model, distance_here))
                .map(|point| Approach::new(point, distance_here))
                .collect();
            let within = RIGHT_WITHIN * survey.metre;
            let trials: Vec<Trial<'_, N>> = (0..survey.effort.starts)
                .zip(approaches.iter().cycle())
                .filter_map(|(_, approach)| {
                    let step = SHORTEST * 10_f64.powf(DECADES * uniform(&mut random));
                    approach.trial::<T, L>(self.truth.model, step, within)
                })
                .collect();
            if trials.is_empty() {
                continue;
            }
            let place = Place {
                unit,
                ..self.place(Axis::TurningPoint, distance)
            };
            for method in Method::ALL {
                survey.count(&place, method, &trials, |trial| {
                    trial.outcome::<_, _, L::Drives>(method, self.model)
                });
            }
        }
    }
}

fn uniform(random: &mut Pcg64) -> f64 {
    StandardUniform.sample(random)
}
