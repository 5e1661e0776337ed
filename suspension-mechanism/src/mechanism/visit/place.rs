//! A place of a grid, and the reasons for which a visit skips some places.

use crate::mechanism::gradient::Gradient;
use crate::mechanism::positions::Positions;
use crate::mechanism::state::State;

/// What kept a visit from some places.
#[derive(Clone, Debug, Default)]
pub struct VisitEnd {
    /// Where the visit ended first along each axis, upwards and downwards.
    pub(super) locks: Vec<AxisEnd>,
    pub(super) interrupted: bool,
}

/// Where an axis of a grid ends.
#[derive(Clone, Debug)]
pub(super) struct AxisEnd {
    level: usize,
    upwards: bool,
    pub(super) in_words: String,
}

impl VisitEnd {
    /// Notes an end where it is the first of its axis and way.
    pub(super) fn add(&mut self, level: usize, upwards: bool, in_words: impl FnOnce() -> String) {
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
