//! A place of a grid, and the reasons for which a visit skips some places.

use crate::mechanism::derivatives::gradient::Gradient;
use crate::mechanism::derivatives::positions::Positions;
use crate::mechanism::state::State;

/// The reasons why a visit did not reach some places.
#[derive(Clone, Debug, Default)]
pub struct VisitEnd {
    /// The first end of the visit along each axis, upwards and downwards.
    pub(super) locks: Vec<AxisEnd>,
    pub(super) interrupted: bool,
}

/// The end of an axis of a grid.
#[derive(Clone, Debug)]
pub(super) struct AxisEnd {
    level: usize,
    upwards: bool,
    pub(super) in_words: String,
    /// What to do, made of the file's name.
    pub(super) remedy: fn(&str) -> String,
}

impl VisitEnd {
    /// Notes an end if it is the first on its axis in its direction.
    pub(super) fn add(
        &mut self,
        level: usize,
        upwards: bool,
        words: impl FnOnce() -> (String, fn(&str) -> String),
    ) {
        let is_this = |end: &AxisEnd| end.level == level && end.upwards == upwards;
        if !self.locks.iter().any(is_this) {
            let (in_words, remedy) = words();
            self.locks.push(AxisEnd {
                level,
                upwards,
                in_words,
                remedy,
            });
        }
    }
}

/// A place of a grid, whose states are made on demand.
pub trait Place {
    /// The state.
    fn state(&self) -> State;

    /// The state with derivatives with respect to a drive; `None` if the mechanism locks.
    fn per(&self, drive: usize) -> Option<State>;

    /// The [`state`](Self::state) with first derivatives with respect to the drives from `first` on: quantities that
    /// are read from it get all these derivatives at once.
    fn gradient<'a>(&self, state: &'a State, first: usize) -> Box<dyn Positions<Gradient> + 'a>;
}

/// Receives a place, by number.
pub type OnPlace<'a> = dyn FnMut(usize, &dyn Place) + 'a;
