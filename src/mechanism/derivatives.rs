//! The mechanism about a place: derivatives with respect to its drives.

use nalgebra::{SVector, Vector3};
use suspension_core::{Directions, Signal, Values};

use crate::mechanism::names::Suspension;
use crate::mechanism::ready::Mechanism;
use crate::mechanism::state::State;

/// Up to which order derivatives of quantities are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The first.
    First,
    /// The second too.
    Second,
}

/// Points, or their velocities, with derivatives.
type Moving = Signal<Vec<Vector3<f64>>>;

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// A state at a position with the velocities of travel and steering there.
    pub(crate) fn with_velocities(
        &self,
        state: State,
        drives: L::Drives,
        position: &SVector<f64, N>,
    ) -> State {
        Around::new(self, drives, position, Order::First).with_velocities(state)
    }
}

/// The mechanism about a place.
pub(crate) struct Around<'a, L: Suspension<N>, const N: usize> {
    mechanism: &'a Mechanism<L, N>,
    drives: L::Drives,
    directions: Option<Directions<'a, L, N>>,
    /// All points with their derivatives with respect to each drive; `None` where the mechanism locks.
    per: Vec<Option<Signal<L::Points>>>,
    order: Order,
}

impl<'a, L: Suspension<N>, const N: usize> Around<'a, L, N> {
    pub(crate) fn new(
        mechanism: &'a Mechanism<L, N>,
        drives: L::Drives,
        position: &SVector<f64, N>,
        order: Order,
    ) -> Self {
        let directions = Directions::new(&mechanism.model, drives, position).ok();
        let of_each = 0..mechanism.names.drives.len();
        let per = of_each.map(|drive| {
            directions
                .as_ref()?
                .points(direction::<L, N>(&[drive]))
                .ok()
        });
        let per = per.collect();
        Self {
            mechanism,
            drives,
            directions,
            per,
            order,
        }
    }

    /// A state with the velocities of travel and steering.
    pub(crate) fn with_velocities(&self, state: State) -> State {
        let velocities = |drive: usize| {
            let unknown = vec![Vector3::repeat(f64::NAN); self.mechanism.names.points.len()];
            Some(Signal {
                value: self.along(drive)?.rate,
                rate: unknown.clone(),
                second_rate: unknown,
            })
        };
        State {
            velocities: self.of_moving_drives(velocities),
            ..state
        }
    }

    /// The state with derivatives with respect to a drive; `None` where the mechanism locks.
    pub(crate) fn per(&self, drive: usize) -> Option<State> {
        let Self {
            mechanism, drives, ..
        } = self;
        Some(State {
            velocities: self.of_moving_drives(|of| self.velocities(of, drive)),
            ..mechanism.state(0.0, drives, self.per[drive].as_ref()?)
        })
    }

    /// The velocities of the drives that move wheels or steer them.
    fn of_moving_drives(
        &self,
        velocities: impl Fn(usize) -> Option<Moving>,
    ) -> Vec<Option<Moving>> {
        let vehicle = &self.mechanism.names.vehicle;
        let of_one = |drive| {
            vehicle
                .is_moved_by(drive)
                .then(|| velocities(drive))
                .flatten()
        };
        (0..self.per.len()).map(of_one).collect()
    }

    fn along(&self, drive: usize) -> Option<Moving> {
        Some(self.mechanism.listed(self.per[drive].as_ref()?))
    }

    /// The velocities with respect to one drive, with their derivatives with respect to another or the same.
    fn velocities(&self, of: usize, per: usize) -> Option<Moving> {
        let [first, other] = [self.along(of)?, self.along(per)?];
        let rate = if of == per {
            first.second_rate
        } else {
            let both = self
                .directions
                .as_ref()?
                .points(direction::<L, N>(&[of, per]));
            let both = self.mechanism.listed(&both.ok()?).second_rate;
            let squares = first.second_rate.iter().zip(&other.second_rate);
            let mixed = both
                .iter()
                .zip(squares)
                .map(|(both, (a, b))| (both - a - b) / 2.0);
            mixed.collect()
        };
        let third = match self.order {
            Order::First => SVector::repeat(f64::NAN),
            Order::Second => self.third(of, per)?,
        };
        Some(Signal {
            value: first.rate,
            rate,
            second_rate: self.spread(&third),
        })
    }

    /// The third derivative of the unknowns, once with respect to one drive and twice to another or the same.
    fn third(&self, once: usize, twice: usize) -> Option<SVector<f64, N>> {
        let along = |change: L::Drives| {
            let jet = self.directions.as_ref()?.unknowns::<3>(change).ok()?;
            Some(jet.terms[2] * 6.0)
        };
        let single = direction::<L, N>(&[once]);
        if once == twice {
            return along(single);
        }
        let [plus, minus] = [1.0, -1.0].map(|sign| along(single.with(twice, sign)));
        Some((plus? + minus? - along(single)? * 2.0) / 6.0)
    }

    /// Rates of the unknowns as those of points: zero for the chassis, NaN for markers.
    fn spread(&self, unknowns: &SVector<f64, N>) -> Vec<Vector3<f64>> {
        let names = &self.mechanism.names;
        let free = (0..names.free).map(|point| unknowns.fixed_rows::<3>(3 * point).into_owned());
        let mut points = vec![Vector3::zeros(); names.chassis];
        points.extend(free);
        points.resize(names.points.len(), Vector3::repeat(f64::NAN));
        points
    }
}

/// The change of some drives by one.
fn direction<L: Suspension<N>, const N: usize>(drives: &[usize]) -> L::Drives {
    let none = L::Drives::from_values([]);
    drives
        .iter()
        .fold(none, |change, drive| change.with(*drive, 1.0))
}
