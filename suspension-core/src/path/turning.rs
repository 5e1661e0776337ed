//! The places where the free drive turns, and where a path leaves its range.

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::path::arc::{Arc, second_order};
use crate::path::place::{End, Place, Stretch, Turning};
use crate::path::{ORDER, Path};
use crate::signal::Signal;
use crate::solve::newton::rounding_at;

/// The number of places of the predictor at which the drive's direction is checked.
const LOOKS: usize = 8;

/// The number of corrections of a place that is searched for.
const SEARCH: usize = 60;

impl<T: Real, L: Linkage<N, Scalar = T>, const N: usize> Path<'_, L, N> {
    /// How often the drive turns within a distance, according to the predictor.
    pub(super) fn turns(&self, arc: &Arc<T, N, ORDER>, distance: T) -> usize {
        let mut forwards = self.here.tangent.drive >= T::zero();
        let mut turns = 0;
        let mut part = T::zero();
        for _ in 0..LOOKS {
            part += T::constant(1.0 / LOOKS as f64);
            let now = arc.drive_rate(distance * part) >= T::zero();
            turns += usize::from(now != forwards);
            forwards = now;
        }
        turns
    }

    /// Whether the drive turns an odd number of times between here and a place.
    pub(super) fn turns_between(&self, place: &Place<T, N>) -> bool {
        (self.here.tangent.drive >= T::zero()) != (place.tangent.drive >= T::zero())
    }

    /// The turning point of the drive within a distance.
    pub(super) fn turning(
        &self,
        arc: &Arc<T, N, ORDER>,
        distance: T,
    ) -> Result<Turning<T, N>, SolveError<T>> {
        let ahead = self.here.tangent.drive >= T::zero();
        let (_, place) = self.search(arc, [T::zero(), distance], |drive| {
            let excess = [drive.rate, drive.second_rate];
            if ahead { excess.map(|x| -x) } else { excess }
        })?;
        let is_end_of_angle = self
            .curve
            .drive_coordinate()
            .largest()
            .is_some_and(|length| {
                let rounding = self.rounding_at(&place);
                length - place.configuration.drive.abs() <= rounding * T::constant(64.0)
            });
        Ok(Turning {
            place,
            is_end_of_angle,
        })
    }

    /// The rounding error of a length at a place.
    fn rounding_at(&self, place: &Place<T, N>) -> T {
        rounding_at(self.curve.linkage, &place.configuration.unknowns)
    }

    /// Whether the path is outside its range by more than the permitted correction at a bound.
    pub(super) fn is_out_of_range(&self) -> bool {
        self.settings.range.is_some_and(|[low, high]| {
            let nearest = self.curve.coordinate(self.here.value.max(low).min(high));
            let off = (self.here.configuration.drive - nearest).abs();
            off > self.rounding_at(&self.here) * T::constant(1024.0)
        })
    }

    /// The stretch or, if it leaves the range, the part of it within the range.
    pub(super) fn within_range(
        &self,
        arc: &Arc<T, N, ORDER>,
        distance: T,
        stretch: Stretch<T, N>,
    ) -> Result<Stretch<T, N>, SolveError<T>> {
        let Some([low, high]) = self.settings.range else {
            return Ok(stretch);
        };
        let turning = stretch.turning.map(|turning| turning.place);
        let places = [turning, Some(stretch.place)];
        let mut from = T::zero();
        for (index, place) in places.into_iter().enumerate() {
            let Some(place) = place else { continue };
            let bound = if place.value < low {
                low
            } else if place.value > high {
                high
            } else {
                from = self.distance_to(arc, &place);
                continue;
            };
            let to = if index == 0 {
                self.distance_to(arc, &place)
            } else {
                distance
            };
            let aim = self.curve.coordinate(bound);
            let rising = place.configuration.drive > aim;
            let (_, place) = self.search(arc, [from, to], |drive| {
                let excess = [drive.value - aim, drive.rate];
                if rising { excess } else { excess.map(|x| -x) }
            })?;
            return Ok(Stretch {
                turning: stretch.turning.filter(|_| index == 1),
                place,
                end: Some(End::Range),
            });
        }
        Ok(stretch)
    }

    /// The distance of a place on the arc: the parameter is one of its entries.
    fn distance_to(&self, arc: &Arc<T, N, ORDER>, place: &Place<T, N>) -> T {
        let moved = place.configuration - self.here.configuration;
        moved.entry(arc.parameter).abs()
    }

    /// The place between two distances where an excess that grows from negative to positive is zero, found by
    /// Newton's method kept between the two. `excess` gives the excess and its derivative, from the drive's
    /// coordinate and its derivatives with respect to the distance.
    fn search(
        &self,
        arc: &Arc<T, N, ORDER>,
        [mut low, mut high]: [T; 2],
        excess: impl Fn(Signal<T>) -> [T; 2],
    ) -> Result<(T, Place<T, N>), SolveError<T>> {
        let half = T::constant(0.5);
        let mut distance = (low + high) * half;
        let mut place = self.arrive(arc, distance)?;
        for _ in 0..SEARCH {
            let at = second_order(
                &self.curve,
                &place.configuration,
                arc.parameter,
                &place.tangent,
            )?;
            let [value, slope] = excess(Signal {
                value: at.value.drive,
                rate: at.rate.drive,
                second_rate: at.second_rate.drive,
            });
            if value < T::zero() {
                low = distance;
            } else {
                high = distance;
            }
            let newton = distance - value / slope;
            let next = if low <= newton && newton <= high {
                newton
            } else {
                (low + high) * half
            };
            let step = (next - distance).abs();
            distance = next;
            place = self.arrive(arc, distance)?;
            if step <= T::EPSILON * self.curve.linkage.size() {
                break;
            }
        }
        Ok((distance, place))
    }
}
