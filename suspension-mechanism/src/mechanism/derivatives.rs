//! The mechanism about a place: derivatives with respect to its drives.

use std::cell::OnceCell;
use std::rc::Rc;

use nalgebra::{SVector, Vector3};
use suspension_core::directions::Directions;
use suspension_core::{Signal, SolveError, Values};

use crate::mechanism::names::Suspension;
use crate::mechanism::points::Points;
use crate::mechanism::ready::Mechanism;
use crate::mechanism::state::{Moved, State};
use crate::mechanism::vehicle::Pair;

/// Up to which order derivatives of quantities are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The first.
    First,
    /// The second too.
    Second,
}

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// A state at a position with the velocities of travel and steering there.
    pub(crate) fn with_velocities(
        &self,
        state: State,
        drives: L::Drives,
        position: &SVector<f64, N>,
    ) -> State {
        self.around(drives, position, Order::First, |around| {
            around.with_velocities(state.clone())
        })
    }

    /// Gives `work` the mechanism about a place.
    pub(crate) fn around<R>(
        &self,
        drives: L::Drives,
        position: &SVector<f64, N>,
        order: Order,
        mut work: impl FnMut(&Around<'_, L, N>) -> R,
    ) -> R {
        let regular = Directions::at(&self.model, drives, position, |directions| {
            let done = work(&Around::new(self, drives, Some(directions), order));
            Ok::<R, SolveError<f64>>(done)
        });
        regular.unwrap_or_else(|_| work(&Around::new(self, drives, None, order)))
    }
}

/// The mechanism about a place. What several of its states need is computed once, where one asks for it.
pub(crate) struct Around<'a, L: Suspension<N>, const N: usize> {
    mechanism: &'a Mechanism<L, N>,
    drives: L::Drives,
    /// `None` where the mechanism locks.
    directions: Option<&'a Directions<'a, L, N>>,
    order: Order,
    /// The states with derivatives with respect to each drive, without the velocities of drives.
    along: Vec<OnceCell<Option<State>>>,
    /// The points' mixed second derivatives with respect to two drives, a row for each drive, up to itself.
    mixed: Vec<OnceCell<Option<Points>>>,
    /// See [`State::moved`].
    moved: OnceCell<Rc<[Moved]>>,
    /// Rates of all points that are not known.
    unknown: Points,
}

impl<'a, L: Suspension<N>, const N: usize> Around<'a, L, N> {
    fn new(
        mechanism: &'a Mechanism<L, N>,
        drives: L::Drives,
        directions: Option<&'a Directions<'a, L, N>>,
        order: Order,
    ) -> Self {
        let count = mechanism.names.drives.len();
        Self {
            mechanism,
            drives,
            directions,
            order,
            along: vec![OnceCell::new(); count],
            mixed: vec![OnceCell::new(); count * (count + 1) / 2],
            moved: OnceCell::new(),
            unknown: vec![Vector3::repeat(f64::NAN); mechanism.names.points.len()].into(),
        }
    }

    /// A state with the velocities of travel and steering.
    pub(crate) fn with_velocities(&self, state: State) -> State {
        let velocities = |drive: usize| {
            Some(Signal {
                value: self.along(drive)?.points.rate.clone(),
                rate: self.unknown.clone(),
                second_rate: self.unknown.clone(),
            })
        };
        State {
            velocities: self.of_moving_drives(velocities),
            moved: self.moved(),
            ..state
        }
    }

    /// The states that springs need: see [`State::moved`].
    fn moved(&self) -> Rc<[Moved]> {
        self.moved
            .get_or_init(|| self.along_travel().into())
            .clone()
    }

    fn along_travel(&self) -> Vec<Moved> {
        let names = &self.mechanism.names;
        if names.vehicle.springs.is_empty() {
            return Vec::new();
        }
        let alone = names.vehicle.travel.iter().map(|drive| vec![(*drive, 1.0)]);
        let pairs = Pair::all(&names.wheels).into_iter();
        let opposed = pairs.filter_map(|pair| {
            let [a, b] = pair.wheels.map(|wheel| names.wheels[wheel].travel);
            Some(vec![(a?, 1.0), (b?, -1.0)])
        });
        let state_along = |change: Vec<(usize, f64)>| {
            let parts = change.iter();
            let drives = parts.fold(L::Drives::from_values([]), |drives, (drive, part)| {
                drives.with(*drive, *part)
            });
            let points = self.directions?.points(drives);
            let state = self
                .mechanism
                .state(0.0, &self.drives, points.as_ref().ok()?);
            Some(Moved { change, state })
        };
        alone.chain(opposed).filter_map(state_along).collect()
    }

    /// The state with derivatives with respect to a drive; `None` where the mechanism locks.
    pub(crate) fn per(&self, drive: usize) -> Option<State> {
        Some(State {
            velocities: self.of_moving_drives(|of| self.velocities(of, drive)),
            moved: self.moved(),
            ..self.along(drive)?.clone()
        })
    }

    /// The velocities of the drives that move wheels or steer them.
    fn of_moving_drives(
        &self,
        velocities: impl Fn(usize) -> Option<Signal<Points>>,
    ) -> Vec<Option<Signal<Points>>> {
        let vehicle = &self.mechanism.names.vehicle;
        let of_one = |drive| {
            vehicle
                .is_moved_by(drive)
                .then(|| velocities(drive))
                .flatten()
        };
        (0..self.along.len()).map(of_one).collect()
    }

    fn along(&self, drive: usize) -> Option<&State> {
        let Self {
            mechanism, drives, ..
        } = self;
        let state = || {
            let points = self.directions?;
            let points = points.points(direction::<L, N>(&[drive]));
            Some(mechanism.state(0.0, drives, points.as_ref().ok()?))
        };
        self.along[drive].get_or_init(state).as_ref()
    }

    /// The velocities with respect to one drive, with their derivatives with respect to another or the same.
    fn velocities(&self, of: usize, per: usize) -> Option<Signal<Points>> {
        let points = &self.along(of)?.points;
        let rate = if of == per {
            &points.second_rate
        } else {
            self.mixed(of.min(per), of.max(per))?
        };
        let second_rate = match self.order {
            Order::First => self.unknown.clone(),
            Order::Second => self.spread(&self.third(of, per)?),
        };
        Some(Signal {
            value: points.rate.clone(),
            rate: rate.clone(),
            second_rate,
        })
    }

    /// The mixed second derivative of the points with respect to two drives.
    fn mixed(&self, one: usize, other: usize) -> Option<&Points> {
        let mixed = || {
            let both = direction::<L, N>(&[one, other]);
            let both = self.directions?.points(both);
            let [a, b] = [one, other].map(|drive| Some(&self.along(drive)?.points.second_rate));
            let squares = a?.iter().zip(b?.iter());
            let points = both.as_ref().ok()?.second_rate.values().zip(squares);
            Some(points.map(|(both, (a, b))| (both - a - b) / 2.0).collect())
        };
        let row = other * (other + 1) / 2;
        self.mixed[row + one].get_or_init(mixed).as_ref()
    }

    /// The third derivative of the unknowns, once with respect to one drive and twice to another or the same.
    fn third(&self, once: usize, twice: usize) -> Option<SVector<f64, N>> {
        let along = |change: L::Drives| {
            let jet = self.directions?.unknowns::<3>(change).ok()?;
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
    fn spread(&self, unknowns: &SVector<f64, N>) -> Points {
        let names = &self.mechanism.names;
        let free = (0..names.free).map(|point| unknowns.fixed_rows::<3>(3 * point).into_owned());
        let mut points = vec![Vector3::zeros(); names.chassis];
        points.extend(free);
        points.resize(names.points.len(), Vector3::repeat(f64::NAN));
        points.into()
    }
}

/// The change of some drives by one.
fn direction<L: Suspension<N>, const N: usize>(drives: &[usize]) -> L::Drives {
    let none = L::Drives::from_values([]);
    drives
        .iter()
        .fold(none, |change, drive| change.with(*drive, 1.0))
}
