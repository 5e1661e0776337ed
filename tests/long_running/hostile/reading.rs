//! Wheel, body and baked curves of NaN, infinite, huge or tiny numbers.

use nalgebra::{Isometry3, Vector3};
use suspension_core::baked::Curve;
use suspension_core::body::{angular_acceleration, angular_velocity, pose};
use suspension_core::chassis::RigidMotion;
use suspension_core::linkage::HasWheel;
use suspension_core::linkages::five_link::Points;
use suspension_core::wheel::{CarrierRotation, Wheel};
use suspension_core::{Real, Signal};

use crate::support::five_link_rough;

const NONE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// A turning body of any size has its angular velocity and acceleration.
fn turns<T: Real>(size: f64, tolerance: f64) {
    let vector = |x: f64, y: f64, z: f64| Vector3::new(x, y, z).map(T::constant);
    let [omega, alpha] = [vector(-3.5, -0.4, 0.4), vector(18.7, 1.4, -7.7)];
    let motion = RigidMotion {
        pose: Isometry3::identity(),
        velocity: vector(0.3, -1.0, 2.0) * T::constant(size),
        omega,
        acceleration: vector(-4.0, 0.2, 1.0) * T::constant(size),
        alpha,
    };
    let body = [
        vector(-1.2, 0.18, 0.26),
        vector(-1.11, -0.01, 0.3),
        vector(-1.1, -0.02, 0.22),
    ];
    let carried = body.map(|point| {
        motion.carry(Signal {
            value: point * T::constant(size),
            rate: Vector3::zeros(),
            second_rate: Vector3::zeros(),
        })
    });
    let at = carried.map(|point| point.value);
    let found = angular_velocity(&at, &carried.map(|point| point.rate)).expect("a triangle");
    assert!(
        (found - omega).norm() <= T::constant(tolerance) * omega.norm(),
        "{size:e}: {found}"
    );
    let found = angular_acceleration(&at, &found, &carried.map(|point| point.second_rate));
    let found = found.expect("a triangle");
    assert!(
        (found - alpha).norm() <= T::constant(tolerance) * alpha.norm(),
        "{size:e}: {found}"
    );
}

#[test]
fn a_body_of_any_size_has_its_angular_velocity() {
    for size in [1e-60, 1e-12, 1e-3, 1.0, 1e6, 1e60] {
        turns::<f64>(size, 1e-11);
    }
    for size in [1e-8, 1e-3, 1.0, 1e6, 1e8] {
        turns::<f32>(size, 1e-3);
    }
}

#[test]
fn a_non_finite_rate_gives_no_rotation() {
    let points = five_link_rough::<f64>();
    let body = [
        points.lower_front_outer,
        points.upper_front_outer,
        points.upper_rear_outer,
    ];
    for bad in NONE {
        let mut rates = body;
        rates[1].y = bad;
        assert!(angular_velocity(&body, &rates).is_none());
        assert!(angular_velocity(&rates, &body).is_none());
        assert!(angular_acceleration(&body, &Vector3::x(), &rates).is_none());
        assert!(pose(&body, &rates).is_none() && pose(&rates, &body).is_none());
        let mut rate = points;
        rate.upper_front_outer.x = bad;
        let signal = Signal {
            value: points,
            rate,
            second_rate: points,
        };
        assert!(CarrierRotation::of(&signal.map(|points| points.carrier())).is_none());
    }
}

#[test]
fn an_invalid_wheel_is_not_read() {
    let wheel = |centre: Vector3<f64>| {
        Wheel::of(
            Points {
                wheel_centre: centre,
                ..five_link_rough()
            }
            .wheel(),
        )
    };
    let inner = five_link_rough::<f64>().upper_rear_outer;
    assert!(wheel(inner).is_none());
    for bad in NONE.into_iter().chain([1e300]) {
        assert!(
            wheel(Vector3::new(inner.x, bad, inner.z)).is_none(),
            "{bad}"
        );
    }
}

#[test]
fn a_baked_curve_refuses_non_finite_and_outside_values() {
    let curve = Curve::<f64, 1, 2> {
        range: [0.0, 1.0],
        segments_per_unit: 2.0,
        segments: &[[[0.0], [1.0]], [[1.0], [1.0]]],
    };
    for bad in NONE.into_iter().chain([1e300, -5e-324]) {
        assert!(
            curve
                .at(bad)
                .is_err_and(|outside| [0.0, 1.0].contains(&outside.nearest))
        );
    }
    let empty = Curve::<f64, 1, 2> {
        segments: &[],
        ..curve
    };
    assert!(empty.at(0.5).is_err());
}
