//! A mechanism moved from instant to instant.

use std::ops::ControlFlow;

use suspension_core::solve::report::Report;
use suspension_core::{Inputs, Motion, Still};

use crate::failure::Failure;
use crate::mechanism::driven_linkage::Mechanism;
use crate::mechanism::motion::end::End;
use crate::mechanism::state::State;
use crate::mechanism::suspension::Suspension;
use suspension_motion_file::Instants;

/// Receives the state at one instant; may end the motion.
pub type OnState<'a> = dyn FnMut(State) -> Result<ControlFlow<()>, Failure> + 'a;

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
}
