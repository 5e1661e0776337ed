//! A check of whether a file's own motion can be reached, for commands that work from the design position.

use std::sync::atomic::AtomicBool;

use crate::failure::Failure;
use crate::interrupt::unless_set;
use crate::mechanism::{End, Instants};
use crate::prepare::loaded::Loaded;

/// The number of instants at which an interrupt is checked on the way.
const LOOKS: usize = 101;

impl Loaded<'_> {
    /// A description of where and why the file's own motion ends before its last instant; `None` if it does not, or
    /// if the user interrupts.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] with a place if the file is wrong.
    pub fn own_motion_ends(&self, interrupted: &AtomicBool) -> Result<Option<String>, Failure> {
        let mechanism = self.within_reach()?;
        if let Some(why) = &mechanism.out_of_reach {
            return Ok(Some(why.clone()));
        }
        let [first, last] = mechanism.instants.ends();
        let moved = |instants: &Instants| {
            mechanism.move_through(instants, &mut |_| Ok(unless_set(interrupted)))
        };
        let End::Stopped(seen) = moved(&Instants::dense(first, last, LOOKS))? else {
            return Ok(None);
        };
        // The instant at which `motion` stops; steps between the file's instants may pass what was seen.
        let stop = match moved(&mechanism.instants)? {
            End::Stopped(stop) => stop,
            End::Complete => seen,
            End::Cut => return Ok(None),
        };
        let name = self.source.name();
        Ok(Some(format!("{name}: {}", stop.in_words(name))))
    }
}
