//! The two back ends side by side: the code that `linkage!` writes for a listing, and the same listing at run time.

use nalgebra::SVector;
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Build, Inputs, Motion, Signal, Still, Tracker, Values};

mod functions;
mod same;

pub(crate) use same::{Number, same_parts};
use same::{as_other, same, same_points, signal_as_other};

/// A model of `N` unknowns that `linkage!` wrote, and a run-time model with room for `M` or fewer.
pub(crate) struct Twins<L, R, const N: usize, const M: usize> {
    pub(crate) written: L,
    pub(crate) walked: R,
}

impl<T, L, R, const N: usize, const M: usize> Twins<L, R, N, M>
where
    T: Number,
    L: Build<N, Scalar = T> + Copy,
    R: Build<M, Scalar = T> + Copy,
{
    /// Returns the vector padded to the larger size.
    fn wide(&self, q: &SVector<T, N>) -> SVector<T, M> {
        SVector::from_fn(|index, _| q.get(index).copied().unwrap_or_else(T::zero))
    }

    #[track_caller]
    fn same_vector(&self, what: &str, written: &SVector<T, N>, walked: &SVector<T, M>) {
        same(what, written.iter().copied(), walked.iter().copied());
        let beyond = walked.iter().skip(N);
        assert!(beyond.into_iter().all(|x| *x == T::zero()), "{what} beyond");
    }

    /// Returns both models with the lengths of other points, if there is such a linkage.
    pub(crate) fn with_lengths_of(&self, points: &L::Points) -> Option<Self> {
        let lengths = L::of(self.written.listing(), points).map(|model| model.lengths());
        let others = R::of(self.walked.listing(), &as_other(points)).map(|model| model.lengths());
        let (lengths, others) = match (lengths, others) {
            (Ok(lengths), Ok(others)) => (lengths, others),
            (refused, also) => {
                assert_eq!(refused.err(), also.err());
                return None;
            }
        };
        same("lengths", lengths.values(), others.values());
        let written = self.written.with_lengths(&lengths);
        let walked = self.walked.with_lengths(&others);
        match (written, walked) {
            (Ok(written), Ok(walked)) => Some(Self { written, walked }),
            (refused, also) => {
                assert_eq!(refused.err(), also.err());
                None
            }
        }
    }

    /// A motion from the design, at a fixed cost and to tolerance; returns how many steps it took.
    pub(crate) fn compare_motion(&self, design: &L::Points, swing: f64) -> usize {
        let (rest, swing) = (self.written.drives_at(design), T::constant(swing));
        let inputs = |t: T| {
            let swung = |amplitude: T| {
                let mut fraction = T::one();
                let values = rest.values().map(|_| {
                    let value = amplitude * fraction;
                    fraction *= T::constant(-0.5);
                    value
                });
                values.collect::<Vec<T>>()
            };
            let add = |change: Vec<T>| {
                let values = rest.values().zip(change);
                L::Drives::from_values(values.map(|(rest, change)| rest + change))
            };
            let frequency = T::constant(5.0);
            let (sine, cosine) = (frequency * t).sin_cos();
            Inputs::still(Signal {
                value: add(swung(swing * sine)),
                rate: L::Drives::from_values(swung(swing * frequency * cosine)),
                second_rate: L::Drives::from_values(swung(-swing * frequency * frequency * sine)),
            })
        };
        let q = self.written.unknowns(design);
        let start = (Motion::at_rest(q), Motion::at_rest(self.wide(&q)));
        let bounded = self.follow(start, inputs, |inputs, others, dt, (motion, other)| {
            let bounded = Bounded::<T>::default();
            let outputs = Outputs::Acceleration;
            let done = bounded.attempt(outputs, &self.written, inputs, dt, motion);
            let also = bounded.attempt(outputs, &self.walked, others, dt, other);
            assert_eq!(done, also);
            done.is_ok()
        });
        let tracked = self.follow(start, inputs, |inputs, others, dt, (motion, other)| {
            let done = Tracker::default().step(&self.written, inputs, dt, motion);
            let also = Tracker::default().step(&self.walked, others, dt, other);
            assert_eq!(done.as_ref().err(), also.as_ref().err());
            done.is_ok()
        });
        bounded + tracked
    }

    fn follow(
        &self,
        start: (Motion<T, N>, Motion<T, M>),
        inputs: impl Fn(T) -> Inputs<Still, L::Drives>,
        step: impl Fn(
            &Inputs<Still, L::Drives>,
            &Inputs<Still, R::Drives>,
            T,
            &mut (Motion<T, N>, Motion<T, M>),
        ) -> bool,
    ) -> usize {
        let mut motions = start;
        for index in 0..100 {
            let dt = if index == 0 { 0.0 } else { 1e-3 };
            let inputs = inputs(T::constant(1e-3 * f64::from(index)));
            let others = Inputs::still(signal_as_other(&inputs.drives));
            if !step(&inputs, &others, T::constant(dt), &mut motions) {
                return index as usize;
            }
            let (motion, other) = &motions;
            self.same_vector("position", &motion.position, &other.position);
            self.same_vector("velocity", &motion.velocity, &other.velocity);
            self.same_vector("acceleration", &motion.acceleration, &other.acceleration);
            assert_eq!(motion.positive_determinant, other.positive_determinant);
            let points = motion.points(&self.written, &inputs);
            let others = other.points(&self.walked, &others);
            same_points("points", &points.value, &others.value);
            same_points("velocities", &points.rate, &others.rate);
            same_points("accelerations", &points.second_rate, &others.second_rate);
        }
        100
    }
}
