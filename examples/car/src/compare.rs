//! The levels of detail of a car compared: the time of a tick, and the errors.

use std::error::Error;
use std::path::Path;

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_core::wheel::camber;

use crate::car::Car;
use crate::chart::{self, Mark};
use crate::detail::Detail;
use crate::drive::{self, Parts, TICK, microseconds};
use crate::kinematics::{Drives, Kinematics};

/// The duration of the drive, s.
const SECONDS: f64 = 10.0;
/// The reference that shows the integrator's own error has steps shorter by this factor.
const FINER: usize = 8;

/// The errors of a detail.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// The largest error of a wheel centre at the same travel and rack, m.
    pub wheel: f64,
    /// The largest error of camber, rad.
    pub camber: f64,
    /// The root mean square error of the wheel loads in the drive, N.
    pub load: f64,
    /// The error of the chassis' position at the end, m.
    pub trajectory: f64,
}

/// A detail, its times and errors.
#[derive(Clone, Copy, Debug)]
pub struct Compared {
    /// Which.
    pub detail: Detail,
    /// Medians over the drive.
    pub parts: Parts,
    /// Against exact kinematics in the same steps.
    pub errors: Errors,
}

/// A record of a drive: the drives of the corners and their loads in each tick, and the position at the end.
struct Driven {
    drives: Vec<[Signal<Drives>; 4]>,
    loads: Vec<[f64; 4]>,
    end: Vector3<f64>,
    parts: Parts,
}

fn drive(detail: Detail, dt: f64) -> Result<Driven, Box<dyn Error>> {
    let mut car = drive::start(detail)?;
    let (mut drives, mut loads) = (Vec::new(), Vec::new());
    let parts = drive::drive(&mut car, SECONDS, dt, |_, car, controls| {
        drives.push(std::array::from_fn(|place| {
            car.corners[place].drives(&controls.rack_of(place))
        }));
        loads.push(loads_of(car));
    })?;
    let end = car.chassis.position;
    Ok(Driven {
        drives,
        loads,
        end,
        parts,
    })
}

fn loads_of(car: &Car) -> [f64; 4] {
    car.corners.each_ref().map(|corner| corner.ground.load)
}

/// Drives each detail.
///
/// # Errors
///
/// A refusal.
pub fn compare() -> Result<Vec<Compared>, Box<dyn Error>> {
    let exact = drive(Detail::Exact, TICK)?;
    let mut compared = Vec::new();
    for detail in Detail::ALL {
        let driven = drive(detail, TICK)?;
        let [wheel, camber] = along(detail, &exact.drives)?;
        let errors = Errors {
            wheel,
            camber,
            ..between(&driven, &exact, 1)
        };
        compared.push(Compared {
            detail,
            parts: driven.parts,
            errors,
        });
    }
    Ok(compared)
}

/// Returns the error of the integrator's step, with exact kinematics in both runs.
///
/// # Errors
///
/// A refusal.
pub fn step_error() -> Result<Errors, Box<dyn Error>> {
    let [coarse, fine] = [
        drive(Detail::Exact, TICK)?,
        drive(Detail::Exact, TICK / FINER as f64)?,
    ];
    Ok(between(&coarse, &fine, FINER))
}

/// Compares loads and positions, if the second run has `finer` ticks in one of the first.
fn between(one: &Driven, other: &Driven, finer: usize) -> Errors {
    let pairs = one.loads.iter().zip(other.loads.iter().step_by(finer));
    let squares =
        pairs.flat_map(|(one, other)| (0..4).map(|place| (one[place] - other[place]).powi(2)));
    Errors {
        load: (squares.sum::<f64>() / (4 * one.loads.len()) as f64).sqrt(),
        trajectory: (one.end - other.end).norm(),
        ..Errors::default()
    }
}

/// Wheel centre and camber at the drives of another drive.
fn along(detail: Detail, drives: &[[Signal<Drives>; 4]]) -> Result<[f64; 2], Box<dyn Error>> {
    let mut worst = [0.0_f64; 2];
    for place in 0..4 {
        let corner = |detail: Detail| detail.corner(place / 2);
        let mut pair: [Box<dyn Kinematics>; 2] = [corner(Detail::Exact)?, corner(detail)?];
        for drives in drives {
            let [exact, found] = pair
                .each_mut()
                .map(|corner| corner.step(TICK, &drives[place]));
            let (exact, found) = (exact?, found?);
            worst[0] = worst[0].max((exact.centre.value - found.centre.value).norm());
            worst[1] = worst[1].max((camber(&exact.axis) - camber(&found.axis)).abs());
        }
    }
    Ok(worst)
}

/// Prints the table and draws the chart.
///
/// # Errors
///
/// A refusal, or a file that cannot be written.
pub fn run(to: &Path) -> Result<(), Box<dyn Error>> {
    let compared = compare()?;
    let step = step_error()?;
    println!(
        "                 a tick  its kinematics  wheel centre  camber   loads, rms  place after {SECONDS} s"
    );
    println!("                 µs      µs              m             deg      N           m");
    for Compared {
        detail,
        parts,
        errors,
    } in &compared
    {
        row(detail.name(), parts, errors);
    }
    let [.., load, place] = step.shown();
    println!(
        "{:<16} {:38}  {:7}  {load:<10.1e}  {place:.1e}",
        "the step of 1 ms", "", ""
    );
    if let Some(folder) = to.parent() {
        std::fs::create_dir_all(folder)?;
    }
    let marks: Vec<Mark> = compared
        .iter()
        .map(
            |Compared {
                 detail,
                 parts,
                 errors,
             }| Mark {
                name: detail.name(),
                time: microseconds(parts.sum()),
                errors: errors.shown(),
            },
        )
        .collect();
    chart::draw(&marks, &step.shown(), to)?;
    println!("wrote {}", to.display());
    Ok(())
}

fn row(name: &str, parts: &Parts, errors: &Errors) {
    let [tick, kinematics] = [parts.sum(), parts.kinematics].map(microseconds);
    let [wheel, camber, load, place] = errors.shown();
    println!(
        "{name:<16} {tick:<6.2}  {kinematics:<14.2}  {wheel:<12.1e}  {camber:<7.1e}  {load:<10.1e}  {place:.1e}"
    );
}

impl Errors {
    /// Returns the errors in m, deg, N and m.
    pub fn shown(&self) -> [f64; 4] {
        [
            self.wheel,
            self.camber.to_degrees(),
            self.load,
            self.trajectory,
        ]
    }
}
