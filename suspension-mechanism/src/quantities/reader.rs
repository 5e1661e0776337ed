//! What reads quantities of one state.

use std::cell::OnceCell;
use std::ops::Deref;

use crate::mechanism::State;
use crate::quantities::in_roll::InRoll;
use crate::quantities::wheel::{Along, Moving, Rolling, Wheel};

/// Reads quantities of one state of a mechanism: what several of them need is computed once.
pub struct Reader<'a> {
    state: &'a State,
    first: Cells,
}

/// What was computed of a wheel, and of the wheels behind it.
#[derive(Default)]
struct Cells {
    wheel: OnceCell<Wheel>,
    travel: OnceCell<Option<Moving>>,
    steer: OnceCell<Option<Moving>>,
    /// Of a left wheel, its axle.
    in_roll: OnceCell<Option<InRoll>>,
    next: OnceCell<Box<Cells>>,
}

impl<'a> Reader<'a> {
    /// Of a state.
    pub fn of(state: &'a State) -> Self {
        Self {
            state,
            first: Cells::default(),
        }
    }

    /// A wheel.
    pub(super) fn wheel(&self, rolling: Rolling) -> &Wheel {
        let wheel = &self.cells(rolling).wheel;
        wheel.get_or_init(|| Wheel::of(self.state, rolling))
    }

    /// Its carrier as a drive moves it.
    pub(super) fn moving(&self, along: Along, rolling: Rolling) -> Option<&Moving> {
        let cells = self.cells(rolling);
        let cell = match along {
            Along::Travel => &cells.travel,
            Along::Steer => &cells.steer,
        };
        let moving = || self.moved_by(rolling.drive(along)?, rolling);
        cell.get_or_init(moving).as_ref()
    }

    /// The same of any drive of travel or steering, computed anew.
    pub(super) fn moved_by(&self, drive: usize, rolling: Rolling) -> Option<Moving> {
        Moving::of(self.state, drive, rolling.points, self.wheel(rolling))
    }

    /// An axle, its left wheel and its right one, as it rolls.
    pub(super) fn in_roll(&self, axle: [Rolling; 2]) -> Option<&InRoll> {
        let [left, _] = axle;
        let wheels = axle.map(|rolling| (rolling, self.wheel(rolling)));
        let in_roll = || InRoll::of(wheels, |rolling, drive| self.moved_by(drive, rolling));
        self.cells(left).in_roll.get_or_init(in_roll).as_ref()
    }

    fn cells(&self, rolling: Rolling) -> &Cells {
        let mut cells = &self.first;
        for _ in 0..rolling.number {
            cells = cells.next.get_or_init(Box::default);
        }
        cells
    }
}

impl Deref for Reader<'_> {
    type Target = State;

    fn deref(&self) -> &State {
        self.state
    }
}
