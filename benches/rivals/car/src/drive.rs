//! The drive, timed tick by tick, and its errors.

use std::error::Error;
use std::time::Instant;

use nalgebra::Vector3;
use suspension_car::car::Car;
use suspension_car::detail::Detail;
use suspension_car::drive::{self, TICK, median, microseconds};
use suspension_car::kinematics::Drives;
use suspension_core::Signal;
use suspension_core::wheel::camber;

use crate::forces::Led;
use crate::interface::{Engine, State};

const SECONDS: f64 = 10.0;
const TICKS: usize = 10_000;
/// The steps of the reference are shorter than a tick by this factor.
const FINER: usize = 8;

/// A corner at a tick: the drives of its left twin, position and orientation of the wheel on the chassis, and its load.
#[derive(Clone, Copy)]
struct Seen {
    drives: Drives,
    centre: Vector3<f64>,
    camber: f64,
    load: f64,
}

/// A drive.
struct Driven {
    ticks: Vec<[Seen; 4]>,
    end: Vector3<f64>,
    tick_us: f64,
}

/// Drives both, the engine in some steps a tick, and prints `name,us,wheel m,camber deg,load N,place m` of each.
pub fn compare(engine: &Engine, steps: usize) -> Result<(), Box<dyn Error>> {
    let reference = ours(TICK / FINER as f64)?;
    for (name, driven) in [("engine", led(engine, steps)?), ("ours", ours(TICK)?)] {
        let [wheel, camber] = off_the_linkage(&driven)?;
        let pairs = driven
            .ticks
            .iter()
            .zip(reference.ticks.iter().step_by(FINER));
        let squares =
            pairs.flat_map(|(one, other)| (0..4).map(|i| (one[i].load - other[i].load).powi(2)));
        let load = (squares.sum::<f64>() / (4 * driven.ticks.len()) as f64).sqrt();
        let place = (driven.end - reference.end).norm();
        println!(
            "{name},{:.3},{wheel:.2e},{:.2e},{load:.2e},{place:.2e}",
            driven.tick_us,
            camber.to_degrees()
        );
    }
    Ok(())
}

fn ours(dt: f64) -> Result<Driven, Box<dyn Error>> {
    let mut car = drive::start(Detail::Exact)?;
    let mut ticks = Vec::new();
    let parts = drive::drive(&mut car, SECONDS, dt, |_, car, controls| {
        ticks.push(seen(car, &controls.rack));
    })?;
    Ok(Driven {
        ticks,
        end: car.chassis.position,
        tick_us: microseconds(parts.sum()),
    })
}

fn led(engine: &Engine, steps: usize) -> Result<Driven, Box<dyn Error>> {
    let mut led = Led::new()?;
    let mut state = State::default();
    let (mut ticks, mut taken) = (Vec::new(), Vec::new());
    let dt = TICK / steps as f64;
    for step in 0..TICKS * steps {
        let began = Instant::now();
        // SAFETY: the functions of the engine receive the pointer that it gave with them.
        unsafe { (engine.look)(engine.this, &mut state) };
        led.follow(&state);
        let looked = Instant::now();
        let time = step as f64 * dt;
        let controls = led.controls(time);
        let [rack, next] = [controls.rack, led.controls(time + dt).rack]
            .map(|rack| [rack.value, rack.rate, rack.second_rate]);
        let resumed = Instant::now();
        let forces = led.forces(&controls, dt);
        let felt = Instant::now();
        if step % steps == 0 {
            ticks.push(seen(&led.car, &controls.rack));
        }
        let stepping = Instant::now();
        // SAFETY: as above.
        unsafe { (engine.step)(engine.this, &forces, &rack, &next) };
        taken.push((looked - began) + (felt - resumed) + stepping.elapsed());
    }
    // SAFETY: as above.
    unsafe { (engine.look)(engine.this, &mut state) };
    led.follow(&state);
    Ok(Driven {
        ticks,
        end: led.car.chassis.position,
        tick_us: microseconds(median(taken)) * steps as f64,
    })
}

fn seen(car: &Car, rack: &Signal<f64>) -> [Seen; 4] {
    std::array::from_fn(|place| {
        let corner = &car.corners[place];
        let right = place % 2 == 1;
        let rack = if right { -rack.value } else { rack.value };
        let mut centre = corner.hub.centre.value;
        if right {
            centre.y = -centre.y;
        }
        Seen {
            drives: Drives {
                travel: corner.travel,
                rack: if place < 2 { rack } else { 0.0 },
            },
            centre,
            camber: camber(&corner.outboard()),
            load: corner.ground.load,
        }
    })
}

/// Wheel centre and camber, the largest errors against a linkage at the same travel and rack.
fn off_the_linkage(driven: &Driven) -> Result<[f64; 2], Box<dyn Error>> {
    let car = drive::start(Detail::Exact)?;
    let mut worst = [0.0_f64; 2];
    for place in 0..4 {
        let mut left = Detail::Exact.corner(place / 2)?;
        let design = left.step(TICK, &Signal::default())?.centre.value;
        let origin = car.corners[place & 2].hub.centre.value - design;
        for seen in &driven.ticks {
            let seen = &seen[place];
            let hub = left.step(TICK, &Signal::still(seen.drives))?;
            worst[0] = worst[0].max((hub.centre.value + origin - seen.centre).norm());
            worst[1] = worst[1].max((camber(&hub.axis) - seen.camber).abs());
        }
    }
    Ok(worst)
}
