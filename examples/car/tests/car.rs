//! The car at rest, its energy, its symmetry.

use nalgebra::{UnitQuaternion, Vector3};
use suspension_car::car::{Car, Controls};
use suspension_car::detail::Detail;
use suspension_car::driver::Driver;
use suspension_car::road::Road;
use suspension_car::saloon::SALOON;

const DT: f64 = 1e-3;
const BUMPS: Road = Road::Bumpy {
    size: 0.02,
    from: 0.0,
};

fn rolling() -> Car {
    Car::new(&SALOON, Detail::Exact)
        .expect("the design")
        .rolling(10.0)
}

#[test]
fn at_rest_the_car_has_its_static_wheel_loads() {
    let mut car = rolling();
    car.chassis.position.z += 0.02;
    car.chassis.attitude = UnitQuaternion::from_euler_angles(0.01, -0.02, 0.0);
    for _ in 0..8_000 {
        car.tick(DT, &Road::Flat, &Controls::default())
            .expect("a motion");
    }
    // Sprung mass 1236 kg, 1.28 m behind the front axle and 1.42 m ahead of the rear one; 42 kg and 40 kg in the wheels.
    let front = (1236.0 * 1.42 / 2.70 / 2.0 + 42.0) * 9.81;
    let rear = (1236.0 * 1.28 / 2.70 / 2.0 + 40.0) * 9.81;
    for (corner, load) in car.corners.iter().zip([front, front, rear, rear]) {
        assert!(
            (corner.ground.load - load).abs() < 0.05,
            "{} N, not {load} N",
            corner.ground.load
        );
        assert!(corner.travel.abs() < 1e-5, "{} m", corner.travel);
    }
}

/// The largest error of the energy balance in a second, in which the car falls on its springs in a turn, is driven, then
/// braked.
fn energy_error(dt: f64) -> f64 {
    let mut car = rolling();
    car.chassis.position.z += 0.02;
    car.chassis.turning = Vector3::new(1.0, 0.3, 0.2);
    let (mut start, mut came_in, mut worst) = (None, 0.0, 0.0_f64);
    let ticks = (1.0 / dt).round() as usize;
    for tick in 0..ticks {
        let controls = if 2 * tick < ticks {
            Controls {
                drive: 400.0,
                ..Controls::default()
            }
        } else {
            Controls {
                brake: [600.0, 300.0],
                ..Controls::default()
            }
        };
        car.look(dt, &controls).expect("a motion");
        let frame = car.touch(dt, &Road::Flat);
        let energy = car.energy(&frame);
        worst = worst.max((energy - *start.get_or_insert(energy) - came_in).abs());
        came_in += car.power(dt, &frame, &controls) * dt;
        car.advance(dt, &frame, &controls);
    }
    worst
}

#[test]
fn the_energy_error_of_the_car_is_of_first_order_in_the_step() {
    let errors = [2e-4, 1e-4, 5e-5].map(energy_error);
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((1.8..2.2).contains(&ratio), "{errors:?} J");
    }
}

#[test]
fn a_symmetric_manoeuvre_keeps_the_car_symmetric() {
    let mut car = rolling();
    car.chassis.position.z += 0.03;
    for tick in 0..5_000 {
        let controls = Controls {
            drive: if tick < 1_000 { 500.0 } else { 0.0 },
            ..Controls::default()
        };
        car.tick(DT, &Road::Flat, &controls).expect("a motion");
    }
    assert!(
        car.chassis.position.y.abs() < 1e-12,
        "{} m",
        car.chassis.position.y
    );
    for axle in car.corners.chunks(2) {
        let difference = (axle[0].travel - axle[1].travel).abs();
        assert!(difference < 1e-13, "{difference} m");
    }
}

#[test]
fn mirrored_steering_gives_the_mirrored_motion_of_the_car() {
    let [left, right] = [0.006, -0.006].map(|rack| {
        let driver = Driver {
            speed: 15.0,
            rack,
            from: 0.2,
            ramp: 0.3,
            hold: 1.0,
        };
        let mut car = rolling();
        for tick in 0..5_000 {
            let controls = driver.controls(f64::from(tick) * DT, &car);
            car.tick(DT, &Road::Flat, &controls).expect("a motion");
        }
        car
    });
    let [left_position, right_position] = [&left, &right].map(|car| car.chassis.position);
    assert!(
        left_position.y.abs() > 5.0,
        "the car turns: {} m",
        left_position.y
    );
    let image = Vector3::new(right_position.x, -right_position.y, right_position.z);
    assert!(
        (left_position - image).norm() < 1e-9,
        "{left_position} and {image}"
    );
    for place in 0..4 {
        let difference = left.corners[place].ground.load - right.corners[place ^ 1].ground.load;
        assert!(difference.abs() < 1e-5, "{difference} N");
    }
}

#[test]
fn every_detail_drives_30_s_over_bumps_and_turns_without_a_refusal() {
    let driver = Driver {
        speed: 20.0,
        rack: 0.006,
        from: 1.0,
        ramp: 0.3,
        hold: 2.0,
    };
    for detail in Detail::ALL {
        let mut car = Car::new(&SALOON, detail).expect("the design").rolling(20.0);
        for tick in 0..30_000 {
            let controls = driver.controls(f64::from(tick) * DT, &car);
            if let Err(refused) = car.tick(DT, &BUMPS, &controls) {
                panic!("{} at {tick} ms: {refused}", detail.name());
            }
        }
        assert!(car.chassis.velocity.norm() > 15.0, "it drives on");
    }
}

#[test]
fn after_a_named_refusal_the_car_drives_on_with_constant_ratios() {
    let mut car = Car::new(&SALOON, Detail::Baked)
        .expect("the design")
        .rolling(20.0);
    car.corners[1].travel = 0.13;
    let controls = Controls::default();
    let stopped = car
        .tick(DT, &Road::Flat, &controls)
        .expect_err("the table ends at 0.12 m");
    assert_eq!(
        stopped.to_string(),
        "front_right: travel 0.1300 m, rack 0.0000 m: outside the baked range; bake a larger one"
    );
    let mut constant = Detail::Constant.corners().expect("a linkage");
    car.change(&mut constant, &controls).expect("anywhere");
    for _ in 0..1_000 {
        car.tick(DT, &Road::Flat, &controls).expect("a motion");
    }
    assert!(car.corners[1].travel < 0.05, "{} m", car.corners[1].travel);
}
