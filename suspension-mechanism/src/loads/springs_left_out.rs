//! Springs that a load case leaves out although they are stretched or twisted, and those that bear a load.

use crate::loads::Case;
use crate::mechanism::State;

/// The load of a spring, or its change, below which a report would show none, N or N m.
const SHOWN: f64 = 0.05;

impl Case {
    /// The springs by number that are stretched or twisted at a state, without a load in the case: they neither act by their
    /// rates nor are along a measure with a stated load or with that of a drive.
    pub fn left_out<'s>(&'s self, state: &'s State) -> impl Iterator<Item = usize> + 's {
        let has_load = |measure: usize| {
            let stated = self.along.iter().any(|(along, _)| *along == measure);
            stated || self.borne_by.iter().any(|(_, by)| *by == measure)
        };
        let springs = state.springs.iter().enumerate();
        let left_out = springs.filter(move |(number, spring)| {
            let is_stretched = (state.load_of(spring) - spring.load).abs() > SHOWN;
            is_stretched && !self.acting.contains(number) && !has_load(spring.measure)
        });
        left_out.map(|(number, _)| number)
    }

    /// The springs by number that act by their rates and have a load at a state.
    pub fn loaded<'s>(&'s self, state: &'s State) -> impl Iterator<Item = usize> + 's {
        let acting = self.acting.iter().copied();
        acting.filter(|spring| state.load_of(&state.springs[*spring]).abs() > SHOWN)
    }
}
