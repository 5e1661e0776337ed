//! One step along a curve: predicted, corrected, and examined for events within it.

use crate::arithmetic::magnitude::index_of_largest;
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::listing::Part;
use crate::path::arc::Arc;
use crate::path::linear::Linear;
use crate::path::place::{End, Place, Stretch};
use crate::path::{Continuation, ORDER, Path};
use crate::step::tracker::CORRECTION_OF_MOVE;

/// The smallest cosine of the angle between the tangents at the ends of a step.
const STRAIGHT: f64 = 0.97;

/// How often a step may be halved.
const HALVINGS: usize = 40;

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Path<'_, L, N> {
    /// Makes one step, as long as the series and the corrector allow.
    pub(super) fn step(&mut self) -> Result<Stretch<T, N>, SolveError<T>> {
        let Continuation {
            longest, precision, ..
        } = self.settings;
        if self.linear.parameter != self.here.parameter {
            self.linear = self
                .curve
                .linear(&self.here.configuration, self.here.parameter)?;
        }
        let arc = Arc::new(
            &self.curve,
            &self.here.configuration,
            &self.linear,
            &self.here.tangent,
        );
        let size = self.curve.linkage.size();
        // The last term grows with the fourth power of the distance.
        let reach = (precision * size / arc.last_term()).sqrt().sqrt();
        let mut distance = (longest * size)
            .min(reach)
            .min(self.last_step * T::constant(2.0));
        let mut result = Err(SolveError::CrossedSingularity {
            part: Part::Unknown(index_of_largest(&self.here.tangent.unknowns)),
        });
        for _ in 0..HALVINGS {
            result = self.stretch(&arc, distance);
            if result.is_ok() {
                break;
            }
            distance *= T::constant(0.5);
        }
        let (mut stretch, linear) = result?;
        self.steps += 1;
        if self.steps >= self.settings.max_steps && stretch.end.is_none() {
            stretch.end = Some(End::Steps);
        }
        self.last_step = distance;
        self.here = stretch.place;
        self.linear = linear;
        Ok(stretch)
    }

    /// The stretch to a distance, cut short if the path ends within it; and the equations linearised at its end if
    /// the path goes on.
    fn stretch(
        &self,
        arc: &Arc<T, N, ORDER>,
        distance: T,
    ) -> Result<(Stretch<T, N>, Linear<L, N>), SolveError<T>> {
        let (place, linear) = self.arrive_with(arc, distance)?;
        let bent = SolveError::CrossedSingularity {
            part: Part::Unknown(index_of_largest(
                &(place.configuration - self.here.configuration).unknowns,
            )),
        };
        let (distance, place, end) = if place.positive != self.here.positive {
            let (distance, place, end) = self.bifurcation(arc, distance).ok_or(bent)?;
            (distance, place, Some(end))
        } else {
            match self.closure(arc, distance) {
                Some((distance, place, end)) => (distance, place, Some(end)),
                None => (distance, place, None),
            }
        };
        if place.tangent.dot(&self.here.tangent) < straight::<T, N>()
            || self.turns(arc, distance) > 1
        {
            return Err(bent);
        }
        let turning = if self.turns_between(&place) {
            Some(self.turning(arc, distance)?)
        } else {
            None
        };
        let stretch = Stretch {
            turning,
            place,
            end,
        };
        Ok((self.within_range(arc, distance, stretch)?, linear))
    }

    /// The place at a distance of the parameter.
    pub(super) fn arrive(
        &self,
        arc: &Arc<T, N, ORDER>,
        distance: T,
    ) -> Result<Place<T, N>, SolveError<T>> {
        let (place, _) = self.arrive_with(arc, distance)?;
        Ok(place)
    }

    /// The same place, with the equations linearised there.
    fn arrive_with(
        &self,
        arc: &Arc<T, N, ORDER>,
        distance: T,
    ) -> Result<(Place<T, N>, Linear<L, N>), SolveError<T>> {
        let guess = arc.at(distance);
        let moved = (guess.value - self.here.configuration).norm();
        let bound = T::constant(CORRECTION_OF_MOVE) * moved;
        let newton = &self.settings.newton;
        let (configuration, report) =
            self.curve
                .correct(newton, guess.value, arc.parameter, bound)?;
        let linear = self.curve.linear(&configuration, arc.parameter)?;
        let tangent = linear.unit_tangent(&guess.rate);
        let place = self
            .curve
            .place(configuration, &linear, tangent, report.residual());
        Ok((place, linear))
    }

    /// The return to the start, if it lies on the arc. Its distance is known, because the parameter is one of the
    /// entries.
    fn closure(&self, arc: &Arc<T, N, ORDER>, end: T) -> Option<(T, Place<T, N>, End<T>)> {
        let start = &self.start.configuration;
        let to_start = start.entry(arc.parameter) - self.here.configuration.entry(arc.parameter);
        let distance = if self.here.tangent.entry(arc.parameter) < T::zero() {
            -to_start
        } else {
            to_start
        };
        let size = self.curve.linkage.size();
        if !(distance > T::zero() && distance <= end)
            || (arc.at(distance).value - *start).norm() > self.settings.precision * size
        {
            return None;
        }
        let place = self.arrive(arc, distance).ok()?;
        let gap = (place.configuration - *start).norm();
        let is_same = gap <= T::EPSILON.sqrt() * size
            && place.tangent.dot(&self.start.tangent) > straight::<T, N>();
        is_same.then_some((distance, place, End::Closed { gap }))
    }

    /// The end before a change of orientation within a distance; `None` if the places on both sides of it are not
    /// neighbours, because one of them is then on another curve.
    fn bifurcation(&self, arc: &Arc<T, N, ORDER>, distance: T) -> Option<(T, Place<T, N>, End<T>)> {
        let size = self.curve.linkage.size();
        // At a distance d, rounding turns the tangent by EPSILON / d^2: nearer than this it means nothing.
        let root = T::EPSILON.sqrt().sqrt().sqrt();
        let accuracy = root * root * root * size;
        let [mut low, mut high] = [T::zero(), distance];
        let [mut before, mut after] = [self.here, self.here];
        for _ in 0..HALVINGS {
            if high - low <= accuracy {
                break;
            }
            let middle = (low + high) * T::constant(0.5);
            match self.arrive(arc, middle) {
                Ok(place) if place.positive == self.here.positive => {
                    (low, before) = (middle, place)
                }
                Ok(place) => (high, after) = (middle, place),
                Err(_) => high = middle,
            }
        }
        let apart = (after.configuration - before.configuration).norm();
        let are_neighbours =
            after.positive != before.positive && apart <= accuracy * T::constant(16.0);
        are_neighbours.then_some((low, before, End::Bifurcation { accuracy }))
    }
}

/// [`STRAIGHT`], or more if there are many unknowns. The largest entry of a unit tangent, which is the parameter's,
/// is `1 / sqrt(N + 1)` or more and keeps its sign as long as the tangents are less than that apart. The orientation
/// is then beyond doubt.
fn straight<T: Real, const N: usize>() -> T {
    T::constant(STRAIGHT.max(1.0 - 0.5 / (N + 1) as f64))
}
