//! A mechanism in motion, led by its drives or by a measure in place of one.

use std::ops::ControlFlow;

use suspension_core::path::Led;
use suspension_core::solve::report::Report;
use suspension_core::step::stepper::Stopped;
use suspension_core::{Inputs, Motion, Signal, Still, Values};

use crate::failure::Failure;
use crate::file::Instants;
use crate::mechanism::driven_linkage::Mechanism;
use crate::mechanism::lock::Lock;
use crate::mechanism::motion::drive_laws::{DriveLaws, advance, follow};
use crate::mechanism::motion::end::{End, Stop};
use crate::mechanism::motion::law::Law;
use crate::mechanism::motion::lead::Lead;
use crate::mechanism::state::State;
use crate::mechanism::suspension::Suspension;

/// Receives the state at one instant; may end the motion.
pub type OnState<'a> = dyn FnMut(State) -> Result<ControlFlow<()>, Failure> + 'a;

/// A mechanism on its way.
pub(crate) enum Moving<'a, const N: usize> {
    /// Its drives lead it.
    Driven(Motion<f64, N>),
    /// A measure leads it instead of a drive.
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
    /// Moves the mechanism from instant to instant. `instants` begin at the file's first instant. If the mechanism
    /// locks or the caller stops, that is the [`End`] and not an error.
    ///
    /// # Errors
    ///
    /// The error of `on_state`.
    pub fn move_through(
        &self,
        instants: &Instants,
        on_state: &mut OnState<'_>,
    ) -> Result<End, Failure> {
        let mut moving = self.moving();
        let [mut last, _] = instants.ends();
        for t in instants.iter() {
            match self.follow([last, t], &mut moving) {
                Ok(advanced) => {
                    let inputs = self.inputs(t, &moving);
                    let state = self.state_at(t, &inputs, &moving.motion(), &advanced);
                    if on_state(state)?.is_break() {
                        return Ok(End::Cut);
                    }
                }
                Err(stopped) => {
                    return Ok(End::Stopped(self.stop(t, &stopped, &moving)));
                }
            }
            last = t;
        }
        Ok(End::Complete)
    }

    /// The state at an instant of its motion.
    fn state_at(
        &self,
        t: f64,
        inputs: &Inputs<Still, L::Drives>,
        motion: &Motion<f64, N>,
        advanced: &Report<f64>,
    ) -> State {
        let drives = &inputs.drives.value;
        let state = State {
            iterations: advanced.iterations,
            residual: advanced.residual(),
            ..self.state(t, drives, &motion.points(&self.model, inputs))
        };
        self.with_velocities(state, *drives, &motion.position)
    }

    /// The motion at the first instant.
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

    /// The drives at time `t`, with a free drive at its value in the mechanism.
    pub(crate) fn inputs(&self, t: f64, moving: &Moving<'_, N>) -> Inputs<Still, L::Drives> {
        match moving {
            Moving::Driven(_) => self.drives.inputs(t),
            Moving::Led(lead, led) => lead.inputs(&self.model, &self.drives.inputs(t), led),
        }
    }

    /// Where and why the motion stopped on the way to the instant `asked`.
    pub(crate) fn stop(&self, asked: f64, stopped: &Stopped<f64>, moving: &Moving<'_, N>) -> Stop {
        let (names, unit) = (&self.names, self.unit);
        let at = |t: f64| self.drives_in_file(self.drives_at(t));
        let (drives_asked, cause) = match moving {
            Moving::Driven(last) => {
                let lock = self.lock(&self.drives, stopped, asked, last);
                let drives = names.drives_in_words(&at(asked), unit, None);
                (drives, self.lock_in_words(&lock))
            }
            Moving::Led(lead, _) => {
                let in_words = |t: f64| lead.in_words(names, &at(t), t, unit);
                let cause = stopped.refused.map_or_else(
                    || "the time is too large".to_owned(),
                    |(_, error)| lead.cause(names, &error, unit),
                );
                let reached = in_words(stopped.reached);
                (
                    in_words(asked),
                    format!("the mechanism goes no further than {reached} ({cause})"),
                )
            }
        };
        Stop {
            asked,
            drives_asked,
            reached: stopped.reached,
            cause,
            is_driven: matches!(moving, Moving::Driven(_)),
        }
    }

    /// The lock at which a motion by drives stopped, with `last` its last configuration.
    pub(crate) fn lock(
        &self,
        laws: &DriveLaws,
        stopped: &Stopped<f64>,
        asked: f64,
        last: &Motion<f64, N>,
    ) -> Lock {
        let given = |drives: &L::Drives| self.drives_in_file(drives.values());
        Lock::new(
            &self.model,
            &self.names,
            laws,
            stopped,
            asked,
            &last.position,
            given,
        )
    }

    /// Drives the mechanism from `drives` to values of some of the drives, in local coordinates, in one second.
    ///
    /// # Errors
    ///
    /// The way and the place where it stopped, for [`lock`](Self::lock).
    pub(crate) fn drive_to(
        &self,
        drives: &[f64],
        to: &[(usize, f64)],
        motion: &mut Motion<f64, N>,
    ) -> Result<Report<f64>, (DriveLaws, Stopped<f64>)> {
        let from = L::Drives::from_values(drives.iter().copied());
        let of_one = |change: L::Drives, (drive, value): &(usize, f64)| {
            change.with(*drive, value - drives[*drive])
        };
        let change = to.iter().fold(L::Drives::default(), of_one);
        let inputs = |t| Inputs::still(Signal::line(from, change, t));
        let followed = advance(&self.model, inputs, [0.0, 1.0], motion);
        followed.map_err(|stopped| {
            let ends = drives.iter().enumerate();
            let laws = DriveLaws::new(ends.map(|(index, from)| {
                let moved = to.iter().find(|(drive, _)| *drive == index);
                Law::line(*from, moved.map_or(*from, |(_, value)| *value))
            }));
            (laws, stopped)
        })
    }

    /// The lock on the way of one drive from the first instant to a value, in local coordinates, with the others
    /// held; `None` if the mechanism gets there.
    pub(crate) fn lock_before(&self, drive: usize, value: f64) -> Option<Lock> {
        let mut motion = self.start;
        let driven = self.drive_to(&self.first_drives(), &[(drive, value)], &mut motion);
        let (laws, stopped) = driven.err()?;
        Some(self.lock(&laws, &stopped, 1.0, &motion))
    }
}
