//! The quarter car against closed forms.

mod support;

use nalgebra::{Matrix2, Vector2};
use suspension_car::kinematics::{Kinematics, exact};
use suspension_car::linkages::front;
use suspension_car::quarter::Quarter;
use suspension_car::saloon::{Axle, GRAVITY, SALOON};
use suspension_car::tyre::Tyre;

const SPRUNG: f64 = 325.0;
const UNDAMPED: (Axle, Tyre) = (
    Axle {
        damping: 0.0,
        ..SALOON.axles[0]
    },
    Tyre {
        damping: 0.0,
        ..SALOON.tyre
    },
);

fn quarter(axle: &Axle, tyre: Tyre) -> Quarter<impl Kinematics> {
    let corner = exact::<front::Model<f64>, _>().expect("a linkage");
    Quarter::new(corner, SPRUNG, axle, tyre).expect("the design")
}

#[test]
fn a_quarter_car_at_rest_stays_at_rest() {
    let mut car = quarter(&SALOON.axles[0], SALOON.tyre);
    for _ in 0..1000 {
        car.tick(1e-3).expect("rest");
    }
    assert!(car.position.amax() < 1e-12, "{}", car.position);
}

/// The largest error of the energy balance in a second of falling from 20 mm.
fn energy_error((axle, tyre): (Axle, Tyre), dt: f64) -> f64 {
    let mut car = quarter(&axle, tyre);
    car.position.x = 0.02;
    car.look(dt).expect("the design");
    let start = car.energy();
    let (mut taken, mut worst) = (0.0, 0.0_f64);
    for _ in 0..(1.0 / dt).round() as usize {
        taken += 0.5 * car.power() * dt;
        car.tick(dt).expect("a motion");
        car.look(dt).expect("a motion");
        taken += 0.5 * car.power() * dt;
        worst = worst.max((car.energy() - start - taken).abs());
    }
    worst
}

#[test]
fn the_energy_error_of_the_quarter_car_is_of_first_order() {
    for car in [UNDAMPED, (SALOON.axles[0], SALOON.tyre)] {
        let errors = [1e-3, 5e-4, 2.5e-4].map(|dt| energy_error(car, dt));
        for pair in errors.windows(2) {
            let ratio = pair[0] / pair[1];
            assert!((1.8..2.2).contains(&ratio), "{errors:?} J");
        }
    }
}

/// Masses and stiffnesses of the textbook's quarter car from the motion ratios of the library's front door. The last two terms
/// of the wheel's stiffness are those of the loads: the motion ratio changes, and the wheel leans.
fn linear_model() -> [Matrix2<f64>; 2] {
    let corner: front::Corner = front::Corner::design().expect("the design");
    let per_bump = front::Drives {
        bump: 1.0,
        steer: 0.0,
    };
    let per = corner.per(per_bump).expect("regular");
    let (axle, tyre) = UNDAMPED;
    let centre = per.points.rate.wheel_centre;
    let (ratio, change) = (per.measures.rate.strut, per.measures.second_rate.strut);
    let camber_gain = (centre - per.points.rate.axle).z / 0.1;
    let load = (SPRUNG + axle.unsprung_mass) * GRAVITY;
    let radius = tyre.radius - load / tyre.stiffness;
    let spring_force = SPRUNG * GRAVITY / -ratio;
    let wheel_rate = axle.stiffness * ratio * ratio
        - spring_force * change
        - load * radius * camber_gain * camber_gain;
    let unsprung = axle.unsprung_mass;
    [
        Matrix2::new(
            SPRUNG + unsprung,
            unsprung,
            unsprung,
            unsprung * centre.norm_squared(),
        ),
        Matrix2::repeat(tyre.stiffness) + Matrix2::from_diagonal(&Vector2::new(0.0, wheel_rate)),
    ]
}

#[test]
fn the_quarter_car_vibrates_at_the_frequencies_of_the_linear_model() {
    const DT: f64 = 1e-4;
    let [mass, stiffness] = linear_model();
    for (frequency, shape) in support::modes(mass, stiffness) {
        let mut car = quarter(&UNDAMPED.0, UNDAMPED.1);
        car.position = shape * 1e-4;
        let mut samples = Vec::new();
        for _ in 0..40_000 {
            car.tick(DT).expect("a motion");
            samples.push(car.position.y);
        }
        let found = support::frequency(&samples, DT);
        assert!(
            (found / frequency - 1.0).abs() < 1e-3,
            "{found} Hz, not {frequency} Hz"
        );
    }
}
