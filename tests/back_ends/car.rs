//! A car in one listing: each of its corners moves as it does alone.

use nalgebra::Vector3;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_core::{Signal, Values};
use suspension_runtime::{Listing, catalogue};

const CAR: &str = include_str!("../data/car.linkage");

/// Each corner of the car: its name, how far it stands from where it does alone, and the side, on which y is mirrored.
const CORNERS: [(&str, f64, f64); 4] = [
    ("front_left", 0.0, 1.0),
    ("front_right", 0.0, -1.0),
    ("rear_left", -2.6, 1.0),
    ("rear_right", -2.6, -1.0),
];

const STEP: f64 = 1e-3;

/// The greatest differences of positions, velocities and accelerations, in m and s.
const TOLERANCES: [f64; 3] = [1e-13, 1e-11, 1e-9];

fn sine(mean: f64, amplitude: f64, rate: f64, t: f64) -> Signal<f64> {
    let (sine, cosine) = (rate * t).sin_cos();
    Signal {
        value: mean + amplitude * sine,
        rate: amplitude * rate * cosine,
        second_rate: -amplitude * rate * rate * sine,
    }
}

/// The height of the wheel and the lateral position of the rack of a corner.
fn motion(corner: usize, t: f64) -> [Signal<f64>; 2] {
    let rate = 9.0 + corner as f64;
    [sine(0.3, 0.05, rate, t), sine(0.34, 0.015, 1.3 * rate, t)]
}

/// Drives with another signal, times a sign, for the drive with this name.
fn with<D: Values<f64>>(
    drives: Signal<D>,
    (listing, name): (&Listing, &str),
    signal: &Signal<f64>,
    sign: f64,
) -> Signal<D> {
    let drive = listing.drive(name).expect(name);
    Signal {
        value: drives.value.with(drive, sign * signal.value),
        rate: drives.rate.with(drive, sign * signal.rate),
        second_rate: drives.second_rate.with(drive, sign * signal.second_rate),
    }
}

/// All points with their velocities and accelerations.
fn points(of: Signal<impl Values<Vector3<f64>>>) -> [Vec<Vector3<f64>>; 3] {
    [of.value, of.rate, of.second_rate].map(|points| points.values().collect())
}

/// The same points where a corner of the car has them.
fn in_the_car(points: [Vec<Vector3<f64>>; 3], x: f64, side: f64) -> [Vec<Vector3<f64>>; 3] {
    let mirrored = points.map(|points| {
        let image = |point: &Vector3<f64>| point.component_mul(&Vector3::new(1.0, side, 1.0));
        points.iter().map(image).collect::<Vec<_>>()
    });
    let [mut positions, velocities, accelerations] = mirrored;
    positions.iter_mut().for_each(|point| point.x += x);
    [positions, velocities, accelerations]
}

fn design(listing: &Listing) -> Vec<Vector3<f64>> {
    listing.design().expect("positions")
}

#[test]
fn each_corner_of_a_car_in_one_listing_moves_as_it_does_alone() {
    let car = Listing::parse(CAR).expect("a car");
    let corner = catalogue::listing("double_wishbone_pushrod").expect("a layout");
    let corner = Listing::parse(corner).expect("a corner");
    assert_eq!((car.size(), corner.size()), (108, 27));
    let count: usize = Kind::POINTS.map(|kind| corner.count(kind)).iter().sum();
    let names = (0..count).map(|place| corner.name(Part::Point(place)));
    let names: Vec<&str> = names.collect();
    let mut whole = car.corner::<120>(&design(&car)).expect("a car");
    let mut alone = [corner.corner::<30>(&design(&corner)).expect("a corner"); 4];
    for step in 1..=200 {
        let t = f64::from(step) * STEP;
        let mut drives = whole.drive_signal();
        for ((index, (prefix, _, side)), alone) in CORNERS.iter().enumerate().zip(&mut alone) {
            let [bump, steer] = motion(index, t);
            drives = with(drives, (&car, &format!("{prefix}_bump")), &bump, 1.0);
            drives = with(drives, (&car, &format!("{prefix}_steer")), &steer, *side);
            let of_one = with(alone.drive_signal(), (&corner, "bump"), &bump, 1.0);
            let of_one = with(of_one, (&corner, "steer"), &steer, 1.0);
            alone.step(STEP, of_one).expect("a step of a corner");
        }
        whole.step(STEP, drives).expect("a step of the car");
        let of_car = points(whole.points());
        for ((prefix, x, side), alone) in CORNERS.iter().zip(&alone) {
            let of_corner = in_the_car(points(alone.points()), *x, *side);
            for (place, name) in names.iter().enumerate() {
                let in_car = car.point(&format!("{prefix}_{name}")).expect(name);
                for (order, tolerance) in TOLERANCES.iter().enumerate() {
                    let off = (of_car[order][in_car] - of_corner[order][place]).amax();
                    assert!(
                        off < *tolerance,
                        "{prefix}_{name}, derivative {order}, {t} s: {off:e}"
                    );
                }
            }
        }
    }
}
