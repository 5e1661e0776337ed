//! From place to place of a grid, away from the start, so that a lock on one side loses no other.

use std::sync::atomic::{AtomicBool, Ordering};

use suspension_core::{Motion, Values};

use crate::failure::Failure;
use crate::mechanism::around::Around;
use crate::mechanism::gradient::Gradient;
use crate::mechanism::grid::Grid;
use crate::mechanism::known::{Arrival, Known, Lists, Order};
use crate::mechanism::names::Suspension;
use crate::mechanism::positions::Positions;
use crate::mechanism::ready::Mechanism;
use crate::mechanism::state::State;
use crate::mechanism::words::advice;

/// What was read at the places of a grid.
#[derive(Clone, Debug)]
pub struct Visited<R> {
    /// In the order of the grid; `None` where the mechanism has no configuration.
    pub places: Vec<Option<R>>,
    pub(crate) end: VisitEnd,
}

/// What kept a visit from some places.
#[derive(Clone, Debug, Default)]
pub struct VisitEnd {
    /// Where the visit ended first along each axis, upwards and downwards.
    locks: Vec<AxisEnd>,
    interrupted: bool,
}

/// Where an axis of a grid ends.
#[derive(Clone, Debug)]
struct AxisEnd {
    level: usize,
    upwards: bool,
    in_words: String,
}

impl VisitEnd {
    /// Notes an end where it is the first of its axis and way.
    fn add(&mut self, level: usize, upwards: bool, in_words: impl FnOnce() -> String) {
        let is_this = |end: &AxisEnd| end.level == level && end.upwards == upwards;
        if !self.locks.iter().any(is_this) {
            self.locks.push(AxisEnd {
                level,
                upwards,
                in_words: in_words(),
            });
        }
    }
}

/// A place of a grid, of which states are made where one asks for them.
pub trait Place {
    /// The state.
    fn state(&self) -> State;

    /// The state with derivatives with respect to a drive; `None` where the mechanism locks.
    fn per(&self, drive: usize) -> Option<State>;

    /// The [`state`](Self::state) with first derivatives with respect to the drives from `first` on: quantities read so
    /// have these all at once.
    fn gradient<'a>(&self, state: &'a State, first: usize) -> Box<dyn Positions<Gradient> + 'a>;
}

/// Takes a place, by number.
pub type OnPlace<'a> = dyn FnMut(usize, &dyn Place) + 'a;

impl<R> Visited<R> {
    /// What remains to be said where places are missing.
    pub fn failure(&self, source: &str) -> Option<Failure> {
        let (all, missing) = self.counts();
        let written = match all - missing {
            0 => "none was written".to_owned(),
            1 => "the other one was written".to_owned(),
            others => format!("the {others} others were written"),
        };
        if self.end.interrupted {
            let are = if missing == 1 { "is" } else { "are" };
            return Some(Failure::Interrupted(format!(
                "{source}: interrupted; {missing} of {all} places {are} missing, {written}"
            )));
        }
        let why = self.out_of_reach(source)?;
        Some(Failure::Solver(format!("{source}: {why}; {written}")))
    }

    /// Why places are missing, where the mechanism locks, in words.
    pub fn out_of_reach(&self, source: &str) -> Option<String> {
        if self.end.locks.is_empty() {
            return None;
        }
        let (all, missing) = self.counts();
        let are = if missing == 1 { "is" } else { "are" };
        let locks = self.end.locks.iter().map(|end| end.in_words.as_str());
        let locks = locks.collect::<Vec<_>>().join("; also, ");
        Some(format!(
            "{missing} of {all} places {are} out of reach from the design position: {locks}; {}",
            advice(source)
        ))
    }

    /// How many places there are, and how many are missing.
    fn counts(&self) -> (usize, usize) {
        let missing = self.places.iter().filter(|place| place.is_none()).count();
        (self.places.len(), missing)
    }
}

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// Solves the mechanism at each place of a grid that it reaches; derivatives of quantities have the wanted order.
    pub(crate) fn visit_each(
        &self,
        grid: &Grid,
        order: Order,
        interrupted: &AtomicBool,
        on_place: &mut OnPlace<'_>,
    ) -> VisitEnd {
        let mut visitor = Visitor {
            mechanism: self,
            grid,
            order,
            interrupted,
            on_place,
            lists: Lists::of(&self.names),
            end: VisitEnd::default(),
        };
        let start = Reached {
            index: 0,
            drives: grid.start.clone(),
            motion: self.start,
            residual: 0.0,
            arrival: None,
        };
        visitor.along_axes(0, &start);
        visitor.end
    }
}

/// The mechanism on its way, at a place.
#[derive(Clone)]
struct Reached<const N: usize> {
    /// The place's number, as far as the axes before tell it.
    index: usize,
    drives: Vec<f64>,
    motion: Motion<f64, N>,
    residual: f64,
    arrival: Option<Arrival<N>>,
}

struct Visitor<'a, 'r, L: suspension_core::Linkage<N>, const N: usize> {
    mechanism: &'a Mechanism<L, N>,
    grid: &'a Grid,
    order: Order,
    interrupted: &'a AtomicBool,
    on_place: &'a mut OnPlace<'r>,
    lists: Lists,
    end: VisitEnd,
}

impl<L: Suspension<N>, const N: usize> Visitor<'_, '_, L, N> {
    /// Visits the places along the axes from `level` on, both ways from `here`.
    fn along_axes(&mut self, level: usize, here: &Reached<N>) {
        let grid = self.grid;
        let Some(axis) = grid.axes.get(level) else {
            self.read_at(here);
            return;
        };
        // The drives of an axis move together: the first tells the way.
        let above_here = |index: &usize| {
            let first = axis[*index].first();
            first.map_or(0.0, |(drive, value)| value - here.drives[*drive])
        };
        let mut order: Vec<usize> = (0..axis.len()).collect();
        order.sort_by(|a, b| above_here(a).total_cmp(&above_here(b)));
        let is_below = |index: &usize| above_here(index) < 0.0;
        let (mut below, above): (Vec<usize>, Vec<usize>) = order.into_iter().partition(is_below);
        below.reverse();
        for (upwards, way) in [(true, above), (false, below)] {
            let mut place = here.clone();
            place.motion = Motion {
                positive_determinant: here.motion.positive_determinant,
                ..Motion::at_rest(here.motion.position)
            };
            for index in way {
                if self.interrupted.load(Ordering::Relaxed) {
                    self.end.interrupted = true;
                    return;
                }
                let mechanism = self.mechanism;
                match mechanism.drive_to(&place.drives, &axis[index], &mut place.motion) {
                    Ok(report) => place.residual = report.residual(),
                    Err((laws, stopped)) => {
                        self.end.add(level, upwards, || {
                            let lock = mechanism.lock(&laws, &stopped, 1.0, &place.motion);
                            mechanism.lock_in_words(&lock)
                        });
                        break;
                    }
                }
                let change = |(drive, value): &(usize, f64)| (*drive, value - place.drives[*drive]);
                let changes: Vec<_> = axis[index].iter().map(change).collect();
                place.arrival = Arrival::of(&place.motion, &changes);
                for (drive, value) in &axis[index] {
                    place.drives[*drive] = *value;
                }
                place.index = here.index * axis.len() + index;
                self.along_axes(level + 1, &place);
            }
        }
    }

    fn read_at(&mut self, reached: &Reached<N>) {
        let drives = L::Drives::from_values(reached.drives.iter().copied());
        let position = &reached.motion.position;
        let mechanism = self.mechanism;
        let on_place = |around: &Around<'_, L, N>| {
            let here = Here {
                around,
                residual: reached.residual,
            };
            (self.on_place)(reached.index, &here);
        };
        let known = Known {
            order: self.order,
            lists: &self.lists,
            arrival: reached.arrival.as_ref(),
        };
        mechanism.around(drives, position, known, on_place);
    }
}

/// What is read of a place.
struct Here<'a, L: Suspension<N>, const N: usize> {
    around: &'a Around<'a, L, N>,
    residual: f64,
}

impl<L: Suspension<N>, const N: usize> Place for Here<'_, L, N> {
    fn state(&self) -> State {
        State {
            residual: self.residual,
            ..self.around.state()
        }
    }

    fn per(&self, drive: usize) -> Option<State> {
        Some(State {
            residual: self.residual,
            ..self.around.per(drive)?
        })
    }

    fn gradient<'a>(&self, state: &'a State, first: usize) -> Box<dyn Positions<Gradient> + 'a> {
        Box::new(self.around.gradient(state, first))
    }
}
