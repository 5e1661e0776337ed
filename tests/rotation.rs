//! Angular velocity, acceleration and pose of a body, and the wheel's spin.

use nalgebra::{Isometry3, Vector3};
use suspension_core::Signal;
use suspension_core::body::{
    angular_acceleration, angular_acceleration_eq10, angular_velocity, angular_velocity_eq9,
    angular_velocity_of, pose,
};
use suspension_core::chassis::RigidMotion;
use suspension_core::model::constraint::{Carried, Frame};
use suspension_core::wheel::{
    Spin, camber, camber_to_ground, caster, kingpin_angle, toe, wheel_angular_acceleration,
    wheel_angular_velocity,
};

use crate::support;

/// Three points of a body (m), crooked on purpose.
fn body() -> [Vector3<f64>; 3] {
    [
        Vector3::new(-1.2, 0.18, 0.26),
        Vector3::new(-1.11, -0.01, 0.3),
        Vector3::new(-1.1, -0.02, 0.22),
    ]
}

fn turning(omega: Vector3<f64>, alpha: Vector3<f64>) -> [[Vector3<f64>; 3]; 3] {
    let motion = RigidMotion {
        pose: Isometry3::identity(),
        velocity: Vector3::new(0.3, -1.0, 2.0),
        omega,
        acceleration: Vector3::new(-4.0, 0.2, 1.0),
        alpha,
    };
    let carried = body().map(|value| {
        motion.carry(Signal {
            value,
            rate: Vector3::zeros(),
            second_rate: Vector3::zeros(),
        })
    });
    [
        carried.map(|p| p.value),
        carried.map(|p| p.rate),
        carried.map(|p| p.second_rate),
    ]
}

fn assert_rotation(omega: Vector3<f64>, alpha: Vector3<f64>) {
    let [at, velocities, accelerations] = turning(omega, alpha);
    let found = angular_velocity(&at, &velocities).expect("a triangle");
    assert!(
        (found - omega).norm() <= 1e-11 * omega.norm(),
        "{found} instead of {omega}"
    );
    let found = angular_acceleration(&at, &found, &accelerations).expect("a triangle");
    assert!(
        (found - alpha).norm() <= 1e-11 * alpha.norm(),
        "{found} instead of {alpha}"
    );
    let signals = |values: [Vector3<f64>; 3], rates: [Vector3<f64>; 3]| {
        std::array::from_fn(|point| {
            let signal = Signal {
                value: values[point],
                rate: rates[point],
                second_rate: Vector3::repeat(f64::NAN),
            };
            signal.components()
        })
    };
    let found = angular_velocity_of(
        &signals(at, velocities),
        &signals(velocities, accelerations),
    );
    let (value, rate) = (found.map(|part| part.value), found.map(|part| part.rate));
    assert!(
        (value - omega).norm() <= 1e-11 * omega.norm(),
        "{value} instead of {omega}"
    );
    assert!(
        (rate - alpha).norm() <= 1e-11 * alpha.norm(),
        "{rate} instead of {alpha}"
    );
}

#[test]
fn eq9_and_eq10_agree_where_they_are_defined() {
    let (omega, alpha) = (
        Vector3::new(-3.47, -0.36, 0.43),
        Vector3::new(18.7, 1.4, -7.7),
    );
    assert_rotation(omega, alpha);
    let [at, velocities, accelerations] = turning(omega, alpha);
    let found = angular_velocity_eq9(&at, &velocities).expect("omega . n is not zero");
    assert!((found - omega).norm() < 1e-12 * omega.norm());
    let found = angular_acceleration_eq10(&at, &omega, &accelerations);
    let found = found.expect("alpha . n is not zero");
    assert!((found - alpha).norm() < 1e-11 * alpha.norm());
}

#[test]
fn the_fit_is_exact_where_eq10_is_zero_over_zero() {
    let [a, b, c] = body();
    let omega = Vector3::new(-3.47, -0.36, 0.43);
    for (along_u, along_v) in [(1.0, 0.0), (0.0, 1.0), (3.0, -2.0), (1e-3, 5.0)] {
        let alpha = ((b - a) * along_u + (c - a) * along_v) * 20.0;
        assert_rotation(omega, alpha);
        let [at, velocities, accelerations] = turning(omega, alpha);
        assert!(angular_velocity_eq9(&at, &velocities).is_ok());
        assert!(angular_acceleration_eq10(&at, &omega, &accelerations).is_err());
    }
}

#[test]
fn the_fit_is_exact_where_eq9_is_zero_over_zero() {
    let [a, b, c] = body();
    let alpha = Vector3::new(2.0, -5.0, 1.0);
    // In the plane of the three points: along either edge, or any mixture of the two.
    for (along_u, along_v) in [(1.0, 0.0), (0.0, 1.0), (3.0, -2.0), (1e-3, 5.0)] {
        let omega = (b - a) * along_u + (c - a) * along_v;
        assert_rotation(omega, alpha);
        let [at, velocities, accelerations] = turning(omega, alpha);
        assert!(angular_velocity_eq9(&at, &velocities).is_err());
        let found = angular_acceleration_eq10(&at, &omega, &accelerations);
        let found = found.expect("it asks where alpha lies, not omega");
        assert!((found - alpha).norm() < 1e-11 * alpha.norm());
    }
    assert!(
        angular_velocity_eq9(&body(), &[Vector3::zeros(); 3]).is_err(),
        "a body at rest"
    );
}

/// At every instant of the 40-digit reference: three points of the knuckle whose plane the angular
/// velocity lies in, carried with points 6, 7 and 8, whose rates are the reference's.
#[test]
fn the_fit_matches_the_reference_where_eq9_is_zero_over_zero() {
    let reference = support::Reference::load();
    for instant in 0..support::INSTANTS.len() {
        let [omega, alpha] = ["omega_", "alpha_"].map(|name| reference.vector(instant, name));
        let [at, rate, second_rate] = ["", "v", "a"].map(|kind| {
            let [a, b, c] =
                ["p6", "p7", "p8"].map(|p| reference.vector(instant, &format!("{p}_{kind}")));
            Frame::new(a, b, c)
        });
        for (along_u, along_v) in [(1.0, 0.0), (0.0, 1.0), (0.3, -2.0)] {
            let edges = [omega.normalize() * 0.1, at.u * along_u + at.v * along_v];
            let points = [at.origin, at.origin + edges[0], at.origin + edges[1]];
            let carried = points.map(|point| Carried::new(point, &at).expect("a triangle"));
            let velocities = carried.map(|point| point.velocity(&at, &rate));
            let accelerations = carried.map(|point| point.acceleration(&at, &rate, &second_rate));
            assert!(angular_velocity_eq9(&points, &velocities).is_err());
            let found = angular_velocity(&points, &velocities).expect("a triangle");
            let off = (found - omega).norm() / omega.norm();
            assert!(off <= 1e-11, "instant {instant}: omega off by {off:e}");
            let found = angular_acceleration(&points, &found, &accelerations).expect("a triangle");
            let off = (found - alpha).norm() / alpha.norm();
            assert!(off <= 1e-11, "instant {instant}: alpha off by {off:e}");
        }
    }
}

#[test]
fn collinear_points_have_no_rotation() {
    let [a, b, _] = body();
    let line = [a, b, a + (b - a) * 2.0];
    assert!(angular_velocity(&line, &body()).is_none());
    assert!(pose(&line, &body()).is_none());
}

#[test]
fn pose_carries_the_design_to_the_current_points() {
    let motion = Isometry3::new(Vector3::new(0.1, 0.7, -0.3), Vector3::new(1.0, -2.0, 0.5));
    let now = body()
        .map(|point| motion * nalgebra::Point3::from(point))
        .map(|p| p.coords);
    let found = pose(&body(), &now).expect("triangles");
    assert!((found.to_homogeneous() - motion.to_homogeneous()).amax() < 1e-13);
}

/// The wheel's spin adds to the knuckle's rate, and swinging the axis round adds to its
/// acceleration: against the derivative of the wheel's angular velocity in time.
#[test]
fn wheel_spin_about_a_swinging_axis_adds_to_rate_and_acceleration() {
    let knuckle = Vector3::new(0.4, -0.2, 0.9);
    let spin = Spin {
        rate: 50.0,
        second_rate: -8.0,
    };
    let axis = Vector3::new(0.02, 0.995, -0.05).normalize();
    let at = |t: f64| {
        let axis = nalgebra::Rotation3::new(knuckle * t) * axis;
        let now = Spin {
            rate: spin.rate + spin.second_rate * t,
            ..spin
        };
        wheel_angular_velocity(&knuckle, &axis, &now)
    };
    let h = 1e-5;
    let expected = (at(h) - at(-h)) / (2.0 * h);
    let found = wheel_angular_acceleration(&Vector3::zeros(), &knuckle, &axis, &spin);
    assert!(
        (found - expected).norm() < 1e-6,
        "{found} instead of {expected}"
    );
}

/// Signs of the angles on both sides of a vehicle (ISO 8855: x forward, y left, z up).
#[test]
fn signs_of_wheel_angles_mean_the_same_on_both_sides() {
    for side in [1.0, -1.0] {
        let top_outboard = Vector3::new(0.0, side, -0.1);
        assert!(camber(&top_outboard) > 0.0 && camber_to_ground(&top_outboard) > 0.0);
        let toed_in = Vector3::new(0.1, side, 0.0);
        assert!(toe(&toed_in) > 0.0 && camber(&toed_in) == 0.0);
        let top_inboard_and_rearwards = Vector3::new(-0.1, -0.2 * side, 1.0);
        let spin_axis = Vector3::new(0.0, side, 0.0);
        assert!(
            (kingpin_angle(&top_inboard_and_rearwards, &spin_axis) - 0.2_f64.atan()).abs() < 1e-15
        );
        assert!((caster(&top_inboard_and_rearwards) - 0.1_f64.atan()).abs() < 1e-15);
    }
    // A knuckle laid over beyond the horizontal keeps its quadrant.
    let upside_down = Vector3::new(0.0, -1.0, -0.5);
    assert!(kingpin_angle(&upside_down, &Vector3::y()) > std::f64::consts::FRAC_PI_2);
}
