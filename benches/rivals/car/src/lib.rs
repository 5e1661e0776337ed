//! The drive of the example car with an engine's chassis and suspension in place of ours, and the differences.

mod design;
mod drive;
mod forces;
mod interface;

use std::error::Error;

use interface::{Design, Engine};
use suspension_car::drive::TICK;

/// Writes the design of the car for a number of steps per tick and an inertia of wheels across their axes; returns a value
/// other than 0 if this fails.
///
/// # Safety
///
/// `design` points to memory for a design.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn car_design(design: *mut Design, steps: u32, across: f64) -> i32 {
    let made = || Design::of(&forces::Led::new()?.car, TICK / f64::from(steps), across);
    told(made().map(|made| {
        // SAFETY: as above.
        unsafe { design.write(made) };
    }))
}

/// Drives an engine's car and ours, and prints a line for each; returns a value other than 0 if this fails.
///
/// # Safety
///
/// `engine` points to an engine, whose functions are called only with its `this`.
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
