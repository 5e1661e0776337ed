//! Sixteen cars in a scene: the nearer, the finer.

use std::error::Error;
use std::time::{Duration, Instant};

use crate::car::Car;
use crate::detail::Detail;
use crate::drive::{self, DRIVER, ROAD, TICK, median, microseconds};

/// The number of cars by detail: the player's, those next to it, those in sight, those far away.
const MIXED: [(Detail, usize); 4] = [
    (Detail::Exact, 1),
    (Detail::Bounded, 3),
    (Detail::Baked, 8),
    (Detail::Constant, 4),
];
/// The number of all cars.
const CARS: usize = 16;
/// Ticks that are timed.
const TICKS: usize = 10_000;
/// The distance between cars, m.
const GAP: f64 = 4.0;

/// The median time of a tick of all cars, side by side on the same road.
fn time(details: &[Detail]) -> Result<Duration, Box<dyn Error>> {
    let mut cars = Vec::new();
    for (lane, detail) in details.iter().enumerate() {
        let mut car = drive::start(*detail)?;
        car.chassis.position.y = GAP * lane as f64;
        cars.push(car);
    }
    let mut times = Vec::with_capacity(TICKS);
    for tick in 0..TICKS {
        let began = Instant::now();
        for car in &mut cars {
            one(car, tick as f64 * TICK)?;
        }
        times.push(began.elapsed());
    }
    Ok(median(times))
}

fn one(car: &mut Car, time: f64) -> Result<(), Box<dyn Error>> {
    let controls = DRIVER.controls(time, car);
    Ok(car.tick(TICK, &ROAD, &controls)?)
}

/// Prints the table.
///
/// # Errors
///
/// A refusal.
pub fn run() -> Result<(), Box<dyn Error>> {
    println!("{CARS} cars, one core, median of {TICKS} ticks of 1 ms");
    let mixed: Vec<Detail> = MIXED
        .iter()
        .flat_map(|(detail, cars)| vec![*detail; *cars])
        .collect();
    let names: Vec<String> = MIXED
        .iter()
        .map(|(detail, cars)| format!("{cars} {}", detail.name()))
        .collect();
    show(&names.join(", "), time(&mixed)?);
    for detail in Detail::ALL {
        show(&format!("all {}", detail.name()), time(&[detail; CARS])?);
    }
    Ok(())
}

fn show(what: &str, time: Duration) {
    let part = 100.0 * time.as_secs_f64() / TICK;
    let time = microseconds(time);
    println!("{what:<58} {time:5.1} µs a tick, {part:4.1} % of real time");
}
