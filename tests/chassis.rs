//! A chassis that moves: the same motion in chassis axes and in the world's.

use nalgebra::{Isometry3, SVector, Vector3};
use suspension_core::chassis::RigidMotion;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::listing::{Kind, Part};
use suspension_core::{Bounded, Inputs, Linkage, Motion, Newton, Signal, Still, Tangent, Values};

use crate::support;

type Carried = [SVector<f64, 15>; 3];

/// A chassis that heaves, yaws, rolls and accelerates.
fn chassis() -> RigidMotion<f64> {
    RigidMotion {
        pose: Isometry3::new(Vector3::new(0.3, -0.2, 0.5), Vector3::new(0.1, -0.2, 0.4)),
        velocity: Vector3::new(1.0, 0.4, -0.7),
        omega: Vector3::new(0.3, -0.5, 0.2),
        acceleration: Vector3::new(-0.6, 2.0, 1.1),
        alpha: Vector3::new(1.0, -0.8, 0.9),
    }
}

/// Position, velocity and acceleration of the unknowns carried into the world.
fn carry(chassis: &RigidMotion<f64>, motion: &Motion<f64, 15>) -> Carried {
    let mut carried: Carried = [SVector::zeros(); 3];
    for index in 0..5 {
        let rows = |v: &SVector<f64, 15>| v.fixed_rows::<3>(3 * index).into_owned();
        let point = chassis.carry(Signal {
            value: rows(&motion.position),
            rate: rows(&motion.velocity),
            second_rate: rows(&motion.acceleration),
        });
        for (all, one) in carried
            .iter_mut()
            .zip([point.value, point.rate, point.second_rate])
        {
            all.fixed_rows_mut::<3>(3 * index).copy_from(&one);
        }
    }
    carried
}

/// The driving angle that has the coordinate `z6 - z1 = length cos(theta)` and its rates.
fn angle(z: Signal<f64>, length: f64) -> Signal<f64> {
    let value = (z.value / length).acos();
    let slope = -length * value.sin();
    let rate = z.rate / slope;
    let second_rate = (z.second_rate + length * value.cos() * rate * rate) / slope;
    Signal {
        value,
        rate,
        second_rate,
    }
}

/// Solves in world axes, with moving chassis points and the drive transformed to these axes.
fn in_the_world<L>(
    model: &L,
    chassis: Signal<L::Fixed>,
    drive: Signal<f64>,
    start: SVector<f64, 15>,
) -> Carried
where
    L: Linkage<15, Scalar = f64>,
{
    let drives = |value| L::Drives::from_values([value]);
    let drives = Signal {
        value: drives(drive.value),
        rate: drives(drive.rate),
        second_rate: drives(drive.second_rate),
    };
    let inputs = Inputs { chassis, drives };
    let mut position = start;
    Newton::near_by()
        .solve(model, &inputs, &mut position)
        .expect("a start near by");
    let tangent = Tangent::new(model, &inputs, &position).expect("regular");
    let velocity = tangent.velocity();
    [position, velocity, tangent.acceleration(&velocity)]
}

fn assert_invariant<L>(model: &L, motions: &[Motion<f64, 15>], first_point: &str)
where
    L: Linkage<15, Scalar = f64>,
{
    let chassis = chassis();
    let anchors = chassis.anchors(model.fixed());
    for motion in motions {
        let expected = carry(&chassis, motion);
        let mut anchors_of_model = 0..model.count(Kind::ChassisPoint);
        let anchor = anchors_of_model
            .find(|point| model.name(Part::Point(*point)) == first_point)
            .expect("p1");
        let of_anchor = |f: &L::Fixed| f.values().nth(anchor).expect("p1").z;
        let z = |order: usize, fixed: &L::Fixed| expected[order][2] - of_anchor(fixed);
        let drive = angle(
            Signal {
                value: z(0, &anchors.value),
                rate: z(1, &anchors.rate),
                second_rate: z(2, &anchors.second_rate),
            },
            support::length("d6_1"),
        );
        let start = expected[0].map(|x| x + 1e-4);
        let found = in_the_world(model, anchors, drive, start);
        for ((found, expected), bound) in found.iter().zip(expected).zip([2e-14, 1e-12, 1e-10]) {
            let difference = (found - expected).amax();
            assert!(difference <= bound, "{difference:e} > {bound:e}");
        }
    }
}

#[test]
fn results_are_invariant_under_rigid_motion_of_the_chassis() {
    let model: attia2003::Model<f64> = support::attia_model();
    let motions = support::motions(&model, &support::attia_rough(), support::attia_inputs);
    assert_invariant(&model, &motions, "p1");
    let model: five_link::Model<f64> = support::five_link_model();
    let motions = support::motions(
        &model,
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    assert_invariant(&model, &motions, "lower_front_inner");
}

/// The paper's chassis heave: all points rise with it, and the drive is unchanged.
#[test]
fn heave_of_the_chassis_adds_to_every_point() {
    let model: attia2003::Model<f64> = support::attia_model();
    let motions = support::motions(&model, &support::attia_rough(), support::attia_inputs);
    let heave = Signal {
        value: 0.05,
        rate: -0.4,
        second_rate: 3.0,
    };
    let up = |fixed: &attia2003::Fixed<f64>, z: f64| fixed.map(|point| point + Vector3::z() * z);
    let still = attia2003::Fixed::default();
    let chassis = Signal {
        value: up(model.fixed(), heave.value),
        rate: up(&still, heave.rate),
        second_rate: up(&still, heave.second_rate),
    };
    for (motion, t) in motions.iter().zip(support::INSTANTS) {
        let found = in_the_world(&model, chassis, support::theta(t), motion.position);
        let expected = [motion.position, motion.velocity, motion.acceleration];
        let rises = [heave.value, heave.rate, heave.second_rate];
        for ((found, expected), rise) in found.iter().zip(expected).zip(rises) {
            for (row, (found, expected)) in found.iter().zip(expected.iter()).enumerate() {
                let rise = if row % 3 == 2 { rise } else { 0.0 };
                assert!((found - expected - rise).abs() < 1e-11);
            }
        }
    }
}

/// A chassis that turns about an axis through its origin, ever faster, while that origin flies.
fn flying(t: f64) -> RigidMotion<f64> {
    let (axis, angle) = (Vector3::new(0.3, -0.5, 0.8), 0.4 * t + 0.5 * t * t);
    let (velocity, acceleration) = (Vector3::new(1.0, 0.4, -0.7), Vector3::new(-0.6, 2.0, 1.1));
    RigidMotion {
        pose: Isometry3::new(velocity * t + acceleration * (0.5 * t * t), axis * angle),
        velocity: velocity + acceleration * t,
        omega: axis * (0.4 + t),
        acceleration,
        alpha: axis,
    }
}

/// Steps of fixed cost in world axes against those in chassis axes, carried into the world.
fn assert_steps_invariant<L>(
    model: &L,
    start: Motion<f64, 15>,
    inputs: fn(f64) -> Inputs<Still, L::Drives>,
) where
    L: Linkage<15, Scalar = f64>,
{
    const STEP: f64 = 1e-3;
    let bounded = Bounded::<f64, 2>::new();
    let mut at_home = start;
    let [position, velocity, acceleration] = carry(&flying(0.0), &start);
    let mut abroad = Motion {
        position,
        velocity,
        acceleration,
        positive_determinant: None,
    };
    let mut worst = [0.0_f64; 3];
    for step in 1..=1000 {
        let t = f64::from(step) * STEP;
        bounded
            .step(model, &inputs(t), STEP, &mut at_home)
            .unwrap_or_else(|error| panic!("in chassis axes at {t} s: {error}"));
        let chassis = flying(t);
        let expected = carry(&chassis, &at_home);
        let chassis = chassis.anchors(model.fixed());
        let first = |fixed: &L::Fixed| fixed.values().next().expect("an anchor").z;
        let drive = angle(
            Signal {
                value: expected[0][2] - first(&chassis.value),
                rate: expected[1][2] - first(&chassis.rate),
                second_rate: expected[2][2] - first(&chassis.second_rate),
            },
            support::length("d6_1"),
        );
        let drives = |value| L::Drives::from_values([value]);
        let drives = Signal {
            value: drives(drive.value),
            rate: drives(drive.rate),
            second_rate: drives(drive.second_rate),
        };
        bounded
            .step(model, &Inputs { chassis, drives }, STEP, &mut abroad)
            .unwrap_or_else(|error| panic!("in the world at {t} s: {error}"));
        let found = [abroad.position, abroad.velocity, abroad.acceleration];
        for ((worst, found), expected) in worst.iter_mut().zip(found).zip(expected) {
            *worst = worst.max((found - expected).amax());
        }
    }
    println!("largest differences: {worst:?}");
    for (found, bound) in worst.into_iter().zip([1e-13, 1e-11, 1e-9]) {
        assert!(found <= bound, "{found:e} > {bound:e}");
    }
}

#[test]
fn bounded_steps_are_invariant_under_rigid_motion_of_the_chassis() {
    let model: attia2003::Model<f64> = support::attia_model();
    let start = support::motions(&model, &support::attia_rough(), support::attia_inputs)[0];
    assert_steps_invariant(&model, start, support::attia_inputs);
    let model: five_link::Model<f64> = support::five_link_model();
    let (rough, inputs) = (support::five_link_rough(), support::five_link_inputs);
    let start = support::motions(&model, &rough, inputs)[0];
    assert_steps_invariant(&model, start, inputs);
}
