//! Derivatives of the points at a place with respect to the drives, each computed once, on demand.

use std::cell::OnceCell;

use nalgebra::{SVector, Vector3};
use suspension_core::Values;
use suspension_core::directions::{Direction, Directions};

use crate::mechanism::derivatives::place_data::Arrival;
use crate::mechanism::driven_linkage::Mechanism;
use crate::mechanism::motion::drive_laws::unit_change;
use crate::mechanism::points::Points;
use crate::mechanism::suspension::Suspension;

/// Derivatives at a place; none exist if the mechanism locks.
pub(crate) struct Derivatives<'a, L: Suspension<N>, const N: usize> {
    mechanism: &'a Mechanism<L, N>,
    directions: Option<&'a Directions<'a, L, N>>,
    /// The motion by which the place was reached.
    arrival: Option<&'a Arrival<N>>,
    /// The derivatives along each drive.
    along: Vec<OnceCell<Option<AlongDrive<L, N>>>>,
    /// The second derivatives with respect to two drives: a row for each drive, up to itself.
    second: Vec<OnceCell<Option<Points>>>,
}

/// The motion of a mechanism along a drive.
pub(crate) struct AlongDrive<L: Suspension<N>, const N: usize> {
    pub(crate) direction: Direction<L, N>,
    /// The derivatives of the points.
    pub(crate) points: Points,
}

impl<'a, L: Suspension<N>, const N: usize> Derivatives<'a, L, N> {
    pub(crate) fn new(
        mechanism: &'a Mechanism<L, N>,
        directions: Option<&'a Directions<'a, L, N>>,
        arrival: Option<&'a Arrival<N>>,
    ) -> Self {
        let count = mechanism.names.drives.len();
        let pairs = count * (count + 1) / 2;
        Self {
            mechanism,
            directions,
            arrival,
            along: (0..count).map(|_| OnceCell::new()).collect(),
            second: (0..pairs).map(|_| OnceCell::new()).collect(),
        }
    }

    /// The motion of the mechanism along a drive.
    pub(crate) fn along(&self, drive: usize) -> Option<&AlongDrive<L, N>> {
        let along = || {
            let change = unit_change::<L::Drives>(drive);
            let direction = match self.arrival(drive) {
                Some(arrival) => self.directions?.first_of(change, arrival.first),
                None => self.directions?.first(change).ok()?,
            };
            Some(AlongDrive {
                points: self.mechanism.listed(&direction.points),
                direction,
            })
        };
        self.along.get(drive)?.get_or_init(along).as_ref()
    }

    /// The motion by which the place was reached, if it was by this drive.
    fn arrival(&self, drive: usize) -> Option<&Arrival<N>> {
        self.arrival.filter(|arrival| arrival.drive == drive)
    }

    /// The second derivative of the points with respect to two drives, or to one.
    pub(crate) fn second(&self, one: usize, other: usize) -> Option<&Points> {
        let (one, other) = (one.min(other), one.max(other));
        let second = || {
            let [a, b] = [&self.along(one)?.direction, &self.along(other)?.direction];
            let points = match self.arrival(one) {
                Some(arrival) if one == other => self.directions?.second_of(a, &arrival.second),
                None if one == other => self.directions?.second(a).ok()?,
                _ => self.directions?.mixed([a, b]).ok()?,
            };
            Some(self.mechanism.listed(&points))
        };
        let row = other * (other + 1) / 2;
        self.second.get(row + one)?.get_or_init(second).as_ref()
    }

    /// The third derivative of the unknowns, with respect to one drive once and to another or the same twice.
    pub(crate) fn third(&self, once: usize, twice: usize) -> Option<SVector<f64, N>> {
        let along = |change: L::Drives| {
            let jet = self.directions?.unknowns::<3>(change).ok()?;
            Some(jet.terms[2] * 6.0)
        };
        let single = unit_change::<L::Drives>(once);
        if once == twice {
            return along(single);
        }
        let [plus, minus] = [1.0, -1.0].map(|sign| along(single.with(twice, sign)));
        Some((plus? + minus? - along(single)? * 2.0) / 6.0)
    }

    /// Rates of the unknowns as rates of points: zero for the chassis, NaN for markers.
    pub(crate) fn spread(&self, unknowns: &SVector<f64, N>) -> Points {
        let names = &self.mechanism.names;
        let free = (0..names.free).map(|point| unknowns.fixed_rows::<3>(3 * point).into_owned());
        let mut points = vec![Vector3::zeros(); names.chassis];
        points.extend(free);
        points.resize(names.points.len(), Vector3::repeat(f64::NAN));
        points.into()
    }
}
