//! The motion of a mechanism about a place: its states with velocities, and with derivatives with respect to its drives.

mod wheel_movements;

use std::cell::OnceCell;
use std::rc::Rc;

use nalgebra::SVector;
use suspension_core::directions::Directions;
use suspension_core::{Motion, Signal, SolveError, Values};

use crate::mechanism::derivatives::gradient::{DRIVES_AT_ONCE, Graded};
use crate::mechanism::derivatives::place_data::{DerivativeOrder, PlaceData, SharedRates};
use crate::mechanism::derivatives::point_derivatives::{AlongDrive, Derivatives};
use crate::mechanism::driven_linkage::Mechanism;
use crate::mechanism::motion::drive_laws::inputs_at_rest;
use crate::mechanism::points::Points;
use crate::mechanism::state::{Moved, State};
use crate::mechanism::suspension::Suspension;

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// A state at a position with the velocities of travel and steering there.
    pub(crate) fn with_velocities(
        &self,
        state: State,
        drives: L::Drives,
        position: &SVector<f64, N>,
    ) -> State {
        let rates = SharedRates::new(&self.names);
        let given = PlaceData {
            order: DerivativeOrder::First,
            rates: &rates,
            arrival: None,
        };
        self.read_place(drives, position, given, |here| {
            here.with_velocities(state.clone())
        })
    }

    /// Passes to `work` the motion of the mechanism about a place.
    pub(crate) fn read_place<R>(
        &self,
        drives: L::Drives,
        position: &SVector<f64, N>,
        given: PlaceData<'_, N>,
        mut work: impl FnMut(&LocalMotion<'_, L, N>) -> R,
    ) -> R {
        let regular = Directions::at(&self.model, drives, position, |directions| {
            let places = self.listed(directions.position());
            let here = LocalMotion::new(self, drives, places, Some(directions), given);
            Ok::<R, SolveError<f64>>(work(&here))
        });
        regular.unwrap_or_else(|_| {
            let points = Motion::at_rest(*position).points(&self.model, &inputs_at_rest(drives));
            let places = self.listed(&points.value);
            work(&LocalMotion::new(self, drives, places, None, given))
        })
    }
}

/// A mechanism that can move about a place. Data that several of its states need are computed once, on demand.
pub(crate) struct LocalMotion<'a, L: Suspension<N>, const N: usize> {
    mechanism: &'a Mechanism<L, N>,
    drives: L::Drives,
    places: Points,
    /// `None` if the mechanism locks.
    directions: Option<&'a Directions<'a, L, N>>,
    given: PlaceData<'a, N>,
    derivatives: Derivatives<'a, L, N>,
    /// See [`State::moved`].
    moved: OnceCell<Rc<[Moved]>>,
}

impl<'a, L: Suspension<N>, const N: usize> LocalMotion<'a, L, N> {
    fn new(
        mechanism: &'a Mechanism<L, N>,
        drives: L::Drives,
        places: Points,
        directions: Option<&'a Directions<'a, L, N>>,
        given: PlaceData<'a, N>,
    ) -> Self {
        Self {
            mechanism,
            drives,
            places,
            directions,
            given,
            derivatives: Derivatives::new(mechanism, directions, given.arrival),
            moved: OnceCell::new(),
        }
    }

    /// The state at rest, with the velocities of travel and steering.
    pub(crate) fn state(&self) -> State {
        let places = &self.places;
        let points = Signal {
            value: places.clone(),
            rate: self.given.rates.still.clone(),
            second_rate: self.given.rates.still.clone(),
        };
        let measures = self.measures(|| [L::Points::from_values([]); 2]);
        self.with_velocities(self.mechanism.state_of(0.0, &self.drives, points, measures))
    }

    /// A state with the velocities of travel and steering.
    pub(crate) fn with_velocities(&self, state: State) -> State {
        let velocities = |drive: usize| {
            Some(Signal {
                value: self.derivatives.along(drive)?.points.clone(),
                rate: self.given.rates.unknown.clone(),
                second_rate: self.given.rates.unknown.clone(),
            })
        };
        State {
            velocities: self.for_each_moving_drive(velocities),
            moved: self.moved(),
            ..state
        }
    }

    /// The measures of the linkage, for points with these rates.
    fn measures(&self, rates: impl FnOnce() -> [L::Points; 2]) -> Signal<Vec<f64>> {
        if self.mechanism.names.measures.is_empty() {
            return Signal::default();
        }
        let [rate, second_rate] = rates();
        self.mechanism.measured(&Signal {
            value: L::Points::from_values(self.places.iter().copied()),
            rate,
            second_rate,
        })
    }

    /// The states that springs and masses need: see [`State::moved`].
    fn moved(&self) -> Rc<[Moved]> {
        self.moved
            .get_or_init(|| self.travel_movements().into())
            .clone()
    }

    /// The state with derivatives with respect to a drive; `None` if the mechanism locks.
    pub(crate) fn per(&self, drive: usize) -> Option<State> {
        let AlongDrive { direction, points } = self.derivatives.along(drive)?;
        let second = self.derivatives.second(drive, drive)?;
        let points = Signal {
            value: self.places.clone(),
            rate: points.clone(),
            second_rate: second.clone(),
        };
        let measures = self.measures(|| {
            let second_rates = second.iter().copied();
            [direction.points, L::Points::from_values(second_rates)]
        });
        let state = self.mechanism.state_of(0.0, &self.drives, points, measures);
        Some(State {
            velocities: self.for_each_moving_drive(|of| self.velocities(of, drive)),
            moved: self.moved(),
            ..state
        })
    }

    /// The [`state`](Self::state) with first derivatives with respect to the drives from `first` on.
    pub(crate) fn gradient<'s>(&self, state: &'s State, first: usize) -> Graded<'s> {
        let drives: [usize; DRIVES_AT_ONCE] = std::array::from_fn(|index| first + index);
        let known = |points: Option<&Points>| points.unwrap_or(&self.given.rates.unknown).clone();
        let measures = |drive: usize| {
            let rates = &self.derivatives.along(drive)?.direction.points;
            Some(self.measures(|| [*rates; 2]).rate)
        };
        let unknown = || vec![f64::NAN; state.measures.value.len()];
        Graded {
            state,
            points: drives
                .map(|drive| known(self.derivatives.along(drive).map(|along| &along.points))),
            measures: drives.map(|drive| measures(drive).unwrap_or_else(unknown)),
            velocities: self.for_each_moving_drive(|of| {
                Some(drives.map(|drive| known(self.derivatives.second(of, drive))))
            }),
        }
    }

    /// A value for each drive that moves or steers wheels.
    fn for_each_moving_drive<V>(&self, velocities: impl Fn(usize) -> Option<V>) -> Vec<Option<V>> {
        let vehicle = &self.mechanism.names.vehicle;
        let of_one = |drive| {
            vehicle
                .is_moved_by(drive)
                .then(|| velocities(drive))
                .flatten()
        };
        (0..self.mechanism.names.drives.len()).map(of_one).collect()
    }

    /// The velocities with respect to one drive, with their derivatives with respect to another drive or the same.
    fn velocities(&self, of: usize, per: usize) -> Option<Signal<Points>> {
        let second_rate = match self.given.order {
            DerivativeOrder::First => self.given.rates.unknown.clone(),
            DerivativeOrder::Second => self.derivatives.spread(&self.derivatives.third(of, per)?),
        };
        Some(Signal {
            value: self.derivatives.along(of)?.points.clone(),
            rate: self.derivatives.second(of, per)?.clone(),
            second_rate,
        })
    }
}
