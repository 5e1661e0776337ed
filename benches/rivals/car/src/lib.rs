//! The drive of the example car with an engine's chassis and suspension in place of ours, and what it is off by.

mod design;
mod drive;
mod forces;
mod interface;

use std::error::Error;

use interface::{Design, Engine};
use suspension_car::drive::TICK;

/// Writes the car as it is built, for a number of steps in a tick and an inertia of wheels across their axes; not 0 where it
/// cannot be.
///
/// # Safety
///
/// `design` points to room for one.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn car_design(design: *mut Design, steps: u32, across: f64) -> i32 {
    let made = || Design::of(&forces::Led::new()?.car, TICK / f64::from(steps), across);
    told(made().map(|made| {
        // SAFETY: as above.
        unsafe { design.write(made) };
    }))
}

/// Drives an engine's car and ours, and prints a line of each; not 0 where something fails.
///
/// # Safety
///
/// `engine` points to one, whose functions are called with its `this` alone.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn car_drive(engine: *const Engine, steps: u32) -> i32 {
    // SAFETY: as above.
    told(drive::compare(unsafe { &*engine }, steps as usize))
}

fn told(done: Result<(), Box<dyn Error>>) -> i32 {
    match done {
        Ok(()) => 0,
        Err(error) => {
            eprintln!("error: {error}");
            1
        }
    }
}
