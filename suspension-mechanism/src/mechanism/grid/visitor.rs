//! The way through the places of a grid: away from the start, so that a lock on one side does not lose places on
//! another; then from places that were reached to their neighbours.

use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::SVector;
use suspension_core::{Linkage, Motion, Values};

use crate::mechanism::derivatives::gradient::Gradient;
use crate::mechanism::derivatives::local_motion::LocalMotion;
use crate::mechanism::derivatives::place_data::{Arrival, DerivativeOrder, PlaceData, SharedRates};
use crate::mechanism::derivatives::positions::Positions;
use crate::mechanism::driven_linkage::Mechanism;
use crate::mechanism::grid::Grid;
use crate::mechanism::grid::place::{OnPlace, Place, VisitEnd};
use crate::mechanism::state::State;
use crate::mechanism::suspension::Suspension;

/// The mechanism on its way, at a place it has reached.
#[derive(Clone)]
struct Reached<const N: usize> {
    /// The place's number, as far as the axes before determine it.
    index: usize,
    drives: Vec<f64>,
    motion: Motion<f64, N>,
    residual: f64,
    arrival: Option<Arrival<N>>,
}

/// Takes the mechanism to all places.
struct Visitor<'a, 'r, L: Linkage<N>, const N: usize> {
    mechanism: &'a Mechanism<L, N>,
    grid: &'a Grid,
    order: DerivativeOrder,
    interrupted: &'a AtomicBool,
    on_place: &'a mut OnPlace<'r>,
    rates: SharedRates,
    /// The unknowns at each place that was reached.
    positions: Vec<Option<SVector<f64, N>>>,
    end: VisitEnd,
}

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// Solves the mechanism at each place of a grid that it reaches; derivatives of quantities have the requested
    /// order.
    pub(crate) fn visit_each(
        &self,
        grid: &Grid,
        order: DerivativeOrder,
        interrupted: &AtomicBool,
        on_place: &mut OnPlace<'_>,
    ) -> VisitEnd {
        let start = Reached {
            index: 0,
            drives: grid.start.clone(),
            motion: self.start,
            residual: 0.0,
            arrival: None,
        };
        let visitor = Visitor {
            mechanism: self,
            grid,
            order,
            interrupted,
            on_place,
            rates: SharedRates::new(&self.names),
            positions: vec![None; grid.places().unwrap_or_default()],
            end: VisitEnd::default(),
        };
        visitor.visit_from(&start)
    }
}

impl<L: Suspension<N>, const N: usize> Visitor<'_, '_, L, N> {
    fn visit_from(mut self, start: &Reached<N>) -> VisitEnd {
        self.visit_axes(0, start);
        if !self.end.locks.is_empty() {
            self.visit_neighbours();
        }
        if self.positions.iter().all(Option::is_some) {
            self.end.locks.clear();
        }
        self.end
    }

    /// Visits places that are out of reach along the axes from neighbours that were reached; not if two neighbours
    /// lead to different assemblies with the same drives.
    fn visit_neighbours(&mut self) {
        let places = 0..self.positions.len();
        let mut reached: Vec<usize> = places.filter(|at| self.positions[*at].is_some()).collect();
        let mut ways = Vec::new();
        while let Some(from) = reached.pop() {
            for to in self.grid.neighbours(from) {
                if self.is_interrupted() {
                    return;
                }
                if self.positions[to].is_some() {
                    continue;
                }
                if let Some(place) = self.reach(from, to) {
                    self.positions[to] = Some(place.motion.position);
                    ways.push([from, to]);
                    reached.push(to);
                }
            }
        }
        for [_, place] in &ways {
            if self.is_interrupted() {
                return;
            }
            if !self.is_one_assembly(*place) {
                for [_, place] in ways {
                    self.positions[place] = None;
                }
                return;
            }
        }
        // The way is followed once more, because the results of a place take more memory than its position.
        for [from, to] in ways {
            if self.is_interrupted() {
                return;
            }
            if let Some(place) = self.reach(from, to) {
                self.read_at(&place);
            }
        }
    }

    fn is_interrupted(&mut self) -> bool {
        self.end.interrupted |= self.interrupted.load(Ordering::Relaxed);
        self.end.interrupted
    }

    /// Whether all neighbours that lead to a place lead to the assembly that was reached there.
    fn is_one_assembly(&self, place: usize) -> bool {
        /// The largest distance that rounding alone may cause, as a fraction of the mechanism's size.
        const APART: f64 = 1e-6;
        let mut neighbours = self.grid.neighbours(place);
        neighbours.all(|from| {
            let there = self
                .reach(from, place)
                .map(|reached| reached.motion.position);
            let pair = there.zip(self.positions[place]);
            pair.is_none_or(|(one, other)| {
                (one - other).amax() < APART * self.mechanism.model.size()
            })
        })
    }

    /// A place, reached from another one that was reached before; `None` if there is no way.
    fn reach(&self, from: usize, to: usize) -> Option<Reached<N>> {
        let position = self.positions[from]?;
        let [before, drives] = [from, to].map(|place| self.grid.drives_at(place));
        let moved = (0..).zip(drives.iter().copied());
        let moved = moved.filter(|(drive, value)| *value != before[*drive]);
        let moved: Vec<(usize, f64)> = moved.collect();
        let mut motion = Motion {
            position,
            ..self.mechanism.start.stopped()
        };
        let report = self.mechanism.drive_to(&before, &moved, &mut motion).ok()?;
        let changes = moved
            .iter()
            .map(|(drive, value)| (*drive, value - before[*drive]));
        let changes: Vec<_> = changes.collect();
        Some(Reached {
            index: to,
            drives,
            arrival: Arrival::new(&motion, &changes),
            motion,
            residual: report.residual(),
        })
    }

    /// Visits the places along the axes from `level` on, in both directions from `here`.
    fn visit_axes(&mut self, level: usize, here: &Reached<N>) {
        let grid = self.grid;
        let Some(axis) = grid.axes.get(level) else {
            self.read_at(here);
            return;
        };
        let [above, below] = grid.outwards(axis, &here.drives);
        for (upwards, way) in [(true, above), (false, below)] {
            let mut place = here.clone();
            place.motion = place.motion.stopped();
            for index in way {
                if self.is_interrupted() {
                    return;
                }
                let mechanism = self.mechanism;
                let moved = grid.moved(&axis[index], &here.drives);
                match mechanism.drive_to(&place.drives, &moved, &mut place.motion) {
                    Ok(report) => place.residual = report.residual(),
                    Err((laws, stopped)) => {
                        self.end.add(level, upwards, || {
                            let lock = mechanism.lock(&laws, &stopped, 1.0, &place.motion);
                            let remedy = lock.remedy(&mechanism.design);
                            (mechanism.lock_in_words(&lock), remedy)
                        });
                        break;
                    }
                }
                let change = |(drive, value): &(usize, f64)| (*drive, value - place.drives[*drive]);
                let changes: Vec<_> = moved.iter().map(change).collect();
                place.arrival = Arrival::new(&place.motion, &changes);
                for (drive, value) in moved {
                    place.drives[drive] = value;
                }
                place.index = here.index * axis.len() + index;
                self.visit_axes(level + 1, &place);
            }
        }
    }

    fn read_at(&mut self, reached: &Reached<N>) {
        let drives = L::Drives::from_values(reached.drives.iter().copied());
        let position = &reached.motion.position;
        self.positions[reached.index] = Some(*position);
        let mechanism = self.mechanism;
        let on_place = |motion: &LocalMotion<'_, L, N>| {
            let here = Here {
                motion,
                residual: reached.residual,
            };
            (self.on_place)(reached.index, &here);
        };
        let given = PlaceData {
            order: self.order,
            rates: &self.rates,
            arrival: reached.arrival.as_ref(),
        };
        mechanism.read_place(drives, position, given, on_place);
    }
}

/// The results read at a place.
struct Here<'a, L: Suspension<N>, const N: usize> {
    motion: &'a LocalMotion<'a, L, N>,
    residual: f64,
}

impl<L: Suspension<N>, const N: usize> Place for Here<'_, L, N> {
    fn state(&self) -> State {
        State {
            residual: self.residual,
            ..self.motion.state()
        }
    }

    fn per(&self, drive: usize) -> Option<State> {
        Some(State {
            residual: self.residual,
            ..self.motion.per(drive)?
        })
    }

    fn gradient<'a>(&self, state: &'a State, first: usize) -> Box<dyn Positions<Gradient> + 'a> {
        Box::new(self.motion.gradient(state, first))
    }
}
