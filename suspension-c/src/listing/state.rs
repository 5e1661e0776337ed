//! The state of a moving suspension as numbers of the caller.
#![allow(unsafe_code, reason = "names for the linker")]

use super::objects::Corner;
use super::placed::Placed;
use super::text::{Number, check_count};
use crate::failure::answer;
use crate::pointer::{Create, In, InOut, Object, Out};
use crate::status::Status;

crate::functions! { "susp":
    /// Makes an independent copy of a suspension in its present state, on the heap. Without the heap
    /// `susp_corner_read_state` and `susp_corner_set_state` copy the state into a suspension of the same
    /// hardpoints that is already there.
    fn corner_copy(corner: In<Corner>, copy: Create<Corner>) -> Status {
        answer(|| {
            let (corner, copy) = (corner.object()?, copy.get()?);
            copy.write(Object::on_heap(corner.copied()));
            Ok(())
        })
    }

    /// The count of numbers in a state, STATE. All suspensions of a listing have the same.
    fn corner_state_count(corner: In<Corner>, count: Out<usize>) -> Status {
        answer(|| {
            let (corner, count) = (corner.object()?, count.get()?);
            count.write(corner.moving().state_count());
            Ok(())
        })
    }

    /// The state of a suspension, `state[STATE]`, to be kept in memory or in a file, for example before a
    /// lock: time, drives and unknowns with their rates.
    fn corner_read_state(corner: In<Corner>, state: Out<Number>, count: usize) -> Status {
        answer(|| {
            let (corner, state) = (corner.object()?, state.many(count)?);
            check_count(count, corner.moving().state_count())?;
            corner.moving().read_state(state);
            Ok(())
        })
    }

    /// Returns a suspension to a state of its own, or of another with the same listing and hardpoints. The
    /// same steps then give the same points, bit by bit. Nothing tests whether the state belongs to the
    /// listing and the hardpoints; SUSP_ERROR_ARGUMENT if a number is not finite.
    fn corner_set_state(corner: InOut<Corner>, state: In<Number>, count: usize) -> Status {
        answer(|| {
            let (moving, _) = corner.object().map(Placed::parts_mut)?;
            let state = state.many(count)?;
            check_count(count, moving.state_count())?;
            if !state.iter().all(|number| number.is_finite()) {
                return Err(Status::Argument);
            }
            moving.set_state(state);
            Ok(())
        })
    }
}
