//! Tyre, road and strut against their definitions.

use nalgebra::Vector2;
use suspension_car::road::Road;
use suspension_car::saloon::{Axle, SALOON};
use suspension_car::tyre::Tyre;

#[test]
fn tyre_force_has_slip_stiffness_at_small_and_friction_at_large_slip() {
    let tyre: Tyre = SALOON.tyre;
    let load = tyre.nominal_load;
    for direction in [Vector2::x(), -Vector2::y(), Vector2::new(0.6, 0.8)] {
        let small = tyre.force(direction * 1e-7, load);
        let linear = direction * (-1e-7 * tyre.slip_stiffness * load);
        assert!(
            (small - linear).norm() < 1e-5 * linear.norm(),
            "{small} {linear}"
        );
        for slip in [0.2, 0.5, 3.0] {
            let sliding = tyre.force(direction * slip, load);
            assert!(
                (sliding + direction * (tyre.friction * load)).norm() < 1e-9,
                "{sliding}"
            );
        }
    }
    // The published cubic at half of the slip from which all of the tread slides: 7/8 of the friction.
    let half = 1.5 * tyre.friction / tyre.slip_stiffness;
    let force = tyre.force(Vector2::new(half, 0.0), load);
    assert!(
        (force.x + 0.875 * tyre.friction * load).abs() < 1e-9,
        "{force}"
    );
    // Twice the load has less than twice the friction.
    let sliding = tyre.force(Vector2::new(1.0, 0.0), 2.0 * load);
    assert!((sliding.x + 2.0 * 0.9 * load).abs() < 1e-9, "{sliding}");
}

#[test]
fn tyre_slip_settles_at_sliding_speed_over_rolling_speed() {
    let (tyre, sliding) = (SALOON.tyre, Vector2::new(0.1, -0.4));
    for speed in [1.0, 20.0, -20.0] {
        let mut slip = Vector2::zeros();
        for _ in 0..10_000 {
            slip = tyre.slip(slip, sliding, speed, 1e-3);
        }
        let most = 3.0 * tyre.friction / tyre.slip_stiffness;
        let settled = (sliding / f64::abs(speed)).cap_magnitude(most);
        assert!((slip - settled).norm() < 1e-9, "{slip} at {speed} m/s");
    }
}

#[test]
fn the_road_normal_is_perpendicular_to_the_slopes_of_its_height() {
    let road = Road::Bumpy {
        size: 0.02,
        from: 10.0,
    };
    for (x, y) in [
        (3.0, 1.0),
        (12.3, -0.7),
        (27.0, 5.0),
        (31.0, 0.0),
        (512.7, 33.3),
    ] {
        let height = |x, y| road.at(x, y).0;
        let slope = |far, near| (far - near) / 2e-6;
        let along = slope(height(x + 1e-6, y), height(x - 1e-6, y));
        let across = slope(height(x, y + 1e-6), height(x, y - 1e-6));
        let (_, normal) = road.at(x, y);
        assert!((normal.norm() - 1.0).abs() < 1e-15);
        assert!((normal.x / normal.z + along).abs() < 1e-8, "{x} {y}");
        assert!((normal.y / normal.z + across).abs() < 1e-8, "{x} {y}");
    }
}

#[test]
fn forces_of_spring_and_stops_are_derivatives_of_their_energy() {
    let strut = Axle::strut(&SALOON.axles[0], 3_000.0, 0.5);
    for (length, travel) in [(0.5, 0.0), (0.47, 0.05), (0.45, 0.09), (0.56, -0.1)] {
        let by_length =
            (strut.energy(length + 1e-6, travel) - strut.energy(length - 1e-6, travel)) / 2e-6;
        assert!((strut.force([length, 0.0]) + by_length).abs() < 1e-3);
        let by_travel =
            (strut.energy(length, travel + 1e-6) - strut.energy(length, travel - 1e-6)) / 2e-6;
        assert!((strut.stop_force(travel) + by_travel).abs() < 1e-3);
    }
    assert!((strut.force([0.5, 0.0]) - 3_000.0).abs() < 1e-9);
    assert!(strut.stop_force(0.07) < 0.0 && strut.stop_force(-0.07) > 0.0);
}
