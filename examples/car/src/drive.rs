//! The scripted drive, and the time of the parts of its ticks.

use std::error::Error;
use std::time::{Duration, Instant};

use crate::car::{Car, Controls};
use crate::detail::Detail;
use crate::driver::Driver;
use crate::road::Road;
use crate::saloon::SALOON;

/// A tick, s.
pub const TICK: f64 = 1e-3;

/// A step of steering on a flat road, then bumps, at 20 m/s.
pub const DRIVER: Driver = Driver {
    speed: 20.0,
    rack: 0.006,
    from: 1.0,
    ramp: 0.3,
    hold: 2.0,
};
/// The car comes to the bumps after three seconds and a half.
pub const ROAD: Road = Road::Bumpy {
    size: 0.02,
    from: 65.0,
};

/// Returns the saloon at the start of the drive.
///
/// # Errors
///
/// Those of the detail.
pub fn start(detail: Detail) -> Result<Car, Box<dyn Error>> {
    Ok(Car::new(&SALOON, detail)?.rolling(DRIVER.speed))
}

/// The times of a tick's parts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Parts {
    /// Kinematics of the four corners.
    pub kinematics: Duration,
    /// Tyres and road.
    pub tyres: Duration,
    /// Equations of motion and integration.
    pub motion: Duration,
}

/// Drives a car for some seconds. Calls `each` in every tick with the car after its kinematics, the time and the controls.
/// Returns medians of the times of the ticks.
///
/// # Errors
///
/// A refusal of the kinematics, with its time.
pub fn drive(
    car: &mut Car,
    seconds: f64,
    dt: f64,
    mut each: impl FnMut(f64, &Car, &Controls),
) -> Result<Parts, Box<dyn Error>> {
    let ticks = (seconds / dt).round() as usize;
    let mut taken = [(); 3].map(|()| Vec::with_capacity(ticks));
    for tick in 0..ticks {
        let time = tick as f64 * dt;
        let controls = DRIVER.controls(time, car);
        let began = Instant::now();
        car.look(dt, &controls)
            .map_err(|stopped| format!("after {time:.3} s, {stopped}"))?;
        let looked = Instant::now();
        let frame = car.touch(dt, &ROAD);
        let touched = Instant::now();
        each(time, car, &controls);
        let resumed = Instant::now();
        car.advance(dt, &frame, &controls);
        taken[0].push(looked - began);
        taken[1].push(touched - looked);
        taken[2].push(resumed.elapsed());
    }
    let [kinematics, tyres, motion] = taken.map(median);
    Ok(Parts {
        kinematics,
        tyres,
        motion,
    })
}

/// The median, zero of nothing.
pub fn median(mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    times.get(times.len() / 2).copied().unwrap_or_default()
}

/// A time in µs.
pub fn microseconds(time: Duration) -> f64 {
    1e6 * time.as_secs_f64()
}

impl Parts {
    /// The whole tick.
    pub fn sum(&self) -> Duration {
        self.kinematics + self.tyres + self.motion
    }
}
