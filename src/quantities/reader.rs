//! What reads quantities of one state.

use std::cell::OnceCell;
use std::ops::Deref;

use crate::mechanism::State;
use crate::quantities::wheel::{Along, Moving, Rolling, Wheel};

/// Reads quantities of one state of a mechanism: what several of them need is computed once.
pub struct Reader<'a> {
    state: &'a State,
    wheel: OnceCell<Wheel>,
    travel: OnceCell<Option<Moving>>,
    steer: OnceCell<Option<Moving>>,
}

impl<'a> Reader<'a> {
    /// Of a state.
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

impl Deref for Reader<'_> {
    type Target = State;

    fn deref(&self) -> &State {
        self.state
    }
}
