//! A state as quantities are read of it.

use std::cell::OnceCell;
use std::ops::Deref;

use crate::mechanism::State;
use crate::quantities::moving::{Along, Moving, Rolling, Wheel};

/// A state of one mechanism, with what several quantities are read from: computed once.
pub struct Seen<'a> {
    state: &'a State,
    wheel: OnceCell<Wheel>,
    travel: OnceCell<Option<Moving>>,
    steer: OnceCell<Option<Moving>>,
}

impl<'a> Seen<'a> {
    /// A state that nothing was read of yet.
    pub fn of(state: &'a State) -> Self {
        Self {
            state,
            wheel: OnceCell::new(),
            travel: OnceCell::new(),
            steer: OnceCell::new(),
        }
    }

    /// The mechanism's wheel.
    pub(super) fn wheel(&self, rolling: Rolling) -> &Wheel {
        self.wheel.get_or_init(|| Wheel::of(self.state, rolling))
    }

    /// Its carrier as a drive moves it.
    pub(super) fn moving(&self, along: Along, rolling: Rolling) -> Option<&Moving> {
        let cell = match along {
            Along::Travel => &self.travel,
            Along::Steer => &self.steer,
        };
        let wheel = self.wheel(rolling);
        let moving = cell.get_or_init(|| Moving::of(self.state, along, rolling.points, wheel));
        moving.as_ref()
    }
}

impl Deref for Seen<'_> {
    type Target = State;

    fn deref(&self) -> &State {
        self.state
    }
}
