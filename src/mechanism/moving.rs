//! A mechanism on its way, by its drives or by a measure in place of one.

use suspension_core::path::Led;
use suspension_core::{Inputs, Motion, Report, Still, Stopped};

use crate::mechanism::drives::follow;
use crate::mechanism::end::Stop;
use crate::mechanism::lead::Lead;
use crate::mechanism::locking::turning_drive;
use crate::mechanism::misfit::Misfit;
use crate::mechanism::names::Suspension;
use crate::mechanism::ready::Mechanism;

/// A mechanism on its way.
pub(crate) enum Moving<'a, const N: usize> {
    /// By its drives.
    Driven(Motion<f64, N>),
    /// By a measure in place of one.
    Led(&'a Lead<N>, Led<f64, N>),
}

impl<const N: usize> Moving<'_, N> {
    /// The unknowns' motion.
    pub(crate) fn motion(&self) -> Motion<f64, N> {
        match self {
            Self::Driven(motion) => *motion,
            Self::Led(_, led) => led.motion(),
        }
    }
}

impl<L: Suspension<N>, const N: usize> Mechanism<L, N> {
    /// At the first instant.
    pub(crate) fn moving(&self) -> Moving<'_, N> {
        match &self.lead {
            Some(lead) => Moving::Led(lead, lead.start),
            None => Moving::Driven(self.start),
        }
    }

    /// Follows the motion from one time to another, in as many steps as it takes.
    pub(crate) fn follow(
        &self,
        times: [f64; 2],
        moving: &mut Moving<'_, N>,
    ) -> Result<Report<f64>, Stopped<f64>> {
        match moving {
            Moving::Driven(motion) => follow(&self.model, &self.drives, times, motion),
            Moving::Led(lead, led) => lead.follow(&self.model, &self.drives, times, led),
        }
    }

    /// The drives at time `t`, a free one as the mechanism has it.
    pub(crate) fn inputs(&self, t: f64, moving: &Moving<'_, N>) -> Inputs<Still, L::Drives> {
        match moving {
            Moving::Driven(_) => self.drives.inputs(t),
            Moving::Led(lead, led) => lead.inputs(&self.model, &self.drives.inputs(t), led),
        }
    }

    /// Where and why the motion stopped on the way to the instant `asked`.
    pub(crate) fn stop(&self, asked: f64, stopped: &Stopped<f64>, moving: &Moving<'_, N>) -> Stop {
        let at = |t: f64| self.given(&self.drives.inputs::<L::Drives>(t).drives.value);
        let (names, unit) = (&self.names, self.unit);
        let drives = |t: f64| match moving {
            Moving::Driven(_) => names.drives_in_words(&at(t), unit, None),
            Moving::Led(lead, _) => lead.in_words(names, &at(t), t, unit),
        };
        let cause = |(_, error)| match moving {
            Moving::Driven(_) => names.cause(&error),
            Moving::Led(lead, _) => lead.cause(names, &error, unit),
        };
        let turns = match moving {
            Moving::Driven(last) => {
                let there = self.drives.inputs(stopped.reached);
                turning_drive(&self.model, &there, &last.position)
            }
            Moving::Led(..) => None,
        };
        let misfit = match moving {
            Moving::Driven(last) => {
                let times = [stopped.reached, asked];
                Misfit::between(&self.model, &self.drives, times, &last.position)
            }
            Moving::Led(..) => None,
        };
        Stop {
            asked,
            drives_asked: drives(asked),
            reached: stopped.reached,
            drives_reached: drives(stopped.reached),
            cause: stopped
                .refused
                .map_or_else(|| "the time is too far away".to_owned(), cause),
            turns: turns.map(|drive| names.drives[drive].name.clone()),
            misfit: misfit.and_then(|misfit| misfit.in_words(unit)),
        }
    }
}
