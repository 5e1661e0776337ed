//! The car in the air: only its weight acts on it, so its momenta are known.

use nalgebra::Vector3;
use suspension_car::car::{Car, Controls};
use suspension_car::detail::Detail;
use suspension_car::road::Road;
use suspension_car::saloon::{GRAVITY, SALOON};

/// Momentum, and angular momentum about the world's origin, in world axes, of the chassis, the masses in the wheel centres and the
/// wheels' spins.
fn momenta(car: &Car) -> [Vector3<f64>; 2] {
    let chassis = &car.chassis;
    let world = chassis.attitude;
    let momentum = chassis.velocity * SALOON.sprung_mass;
    let spinning = SALOON.inertia_matrix() * chassis.turning;
    let mut momenta = [
        momentum,
        chassis.position.cross(&momentum) + world * spinning,
    ];
    for (place, corner) in car.corners.iter().enumerate() {
        let (axle, centre) = (&SALOON.axles[place / 2], corner.hub.centre);
        let at = chassis.position + world * centre.value;
        let rate = chassis.turning.cross(&centre.value) + centre.rate;
        let momentum = (chassis.velocity + world * rate) * axle.unsprung_mass;
        momenta[0] += momentum;
        momenta[1] +=
            at.cross(&momentum) + world * corner.hub.axis * (axle.spin_inertia * corner.spin);
    }
    momenta
}

/// The errors of both momenta after a quarter of a second in which the car tumbles while its wheels spin and drop.
fn errors(dt: f64) -> [f64; 2] {
    let mut car = Car::new(&SALOON, Detail::Exact)
        .expect("the design")
        .rolling(30.0);
    car.chassis.position.z = 10.0;
    car.chassis.turning = Vector3::new(1.0, -0.7, 0.5);
    let controls = Controls::default();
    car.look(dt, &controls).expect("a motion");
    let [momentum, angular] = momenta(&car);
    let mass = SALOON.sprung_mass
        + 2.0
            * SALOON
                .axles
                .map(|axle| axle.unsprung_mass)
                .iter()
                .sum::<f64>();
    let weight = Vector3::new(0.0, 0.0, -mass * GRAVITY);
    let mut moment = Vector3::zeros();
    let ticks = (0.25 / dt).round() as usize;
    for _ in 0..ticks {
        moment += centre_of_mass(&car).cross(&weight) * dt;
        car.tick(dt, &Road::Flat, &controls).expect("a motion");
    }
    car.look(dt, &controls).expect("a motion");
    let [after, angular_after] = momenta(&car);
    let gained = [weight * (ticks as f64 * dt), moment];
    [
        after - momentum - gained[0],
        angular_after - angular - gained[1],
    ]
    .map(|error| error.norm())
}

fn centre_of_mass(car: &Car) -> Vector3<f64> {
    let (mut sum, mut mass) = (
        car.chassis.position * SALOON.sprung_mass,
        SALOON.sprung_mass,
    );
    for (place, corner) in car.corners.iter().enumerate() {
        let unsprung = SALOON.axles[place / 2].unsprung_mass;
        sum += (car.chassis.position + car.chassis.attitude * corner.hub.centre.value) * unsprung;
        mass += unsprung;
    }
    sum / mass
}

#[test]
fn errors_of_momentum_and_angular_momentum_are_of_first_order() {
    let [coarse, middle, fine] = [1e-3, 5e-4, 2.5e-4].map(errors);
    for kind in 0..2 {
        for [long, short] in [[coarse, middle], [middle, fine]] {
            let ratio = long[kind] / short[kind];
            assert!(
                (1.8..2.2).contains(&ratio),
                "{coarse:?} {middle:?} {fine:?}"
            );
        }
    }
}
