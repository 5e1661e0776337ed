//! The wheel's contact point, its steering axis and its instant centres.

use std::f64::consts::FRAC_PI_6;

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_core::linkages::double_wishbone_pushrod::{Corner, Drives};
use suspension_core::signal::Number;
use suspension_core::wheel::{Carrier, Heading, SteeringAxis, camber, contact, toe};

const RADIUS: f64 = 0.3;

type Of<N> = [Vector3<N>; 4];

/// Formulas of a spin axis and a kingpin: lower and upper ball joint, inner end of the axle, wheel centre.
fn formulas<N: Number>([lower, upper, inner, centre]: Of<N>, radius: N) -> [N; 8] {
    let axis = centre - inner;
    let (heading, ground) = (Heading::of(&axis), contact(&centre, &axis, radius));
    let kingpin = SteeringAxis::through([lower, upper]);
    [
        ground.x,
        ground.y,
        ground.z,
        kingpin.inboard_of(&ground, &heading),
        kingpin.ahead_of(&ground, &heading),
        kingpin.inboard_of(&centre, &heading),
        camber(&axis),
        toe(&axis),
    ]
}

#[test]
fn the_contact_point_of_a_cambered_wheel_is_offset_sideways() {
    // The top leans outboard by 30 degrees.
    let axis = Vector3::new(0.0, FRAC_PI_6.cos(), -FRAC_PI_6.sin());
    let at = contact(&Vector3::new(1.0, 0.7, RADIUS), &axis, RADIUS);
    let expected = Vector3::new(1.0, 0.7 - RADIUS * 0.5, RADIUS * (1.0 - FRAC_PI_6.cos()));
    assert!((at - expected).norm() < 1e-15, "{at}");
}

#[test]
fn kingpin_quantities_are_equal_on_both_sides() {
    for side in [1.0, -1.0] {
        let mirror = |[x, y, z]: [f64; 3]| Vector3::new(x, side * y, z);
        let [lower, upper, inner, centre] = [
            [0.02, 0.66, 0.1],
            [-0.02, 0.62, 0.5],
            [0.0, 0.6, RADIUS],
            [0.0, 0.75, RADIUS],
        ]
        .map(mirror);
        let heading = Heading::of(&(centre - inner));
        assert_eq!(heading.forward, Vector3::x());
        let kingpin = SteeringAxis::through([lower, upper]);
        let ground = contact(&centre, &(centre - inner), RADIUS);
        // 40 mm of lean over 400 mm of height, from 100 mm down to the ground.
        assert!((kingpin.inboard_of(&ground, &heading) - (0.75 - 0.67)).abs() < 1e-15);
        assert!((kingpin.ahead_of(&ground, &heading) - 0.03).abs() < 1e-15);
        assert!((kingpin.inboard_of(&centre, &heading) - (0.75 - 0.64)).abs() < 1e-15);
    }
}

#[test]
fn the_screw_axis_of_a_rotation_about_a_line_is_the_line() {
    let (point, direction) = (Vector3::new(0.1, 0.6, 0.2), Vector3::new(-0.1, -0.2, 1.0));
    let centre = Vector3::new(0.0, 0.75, RADIUS);
    for turn in [0.3, -2.0] {
        let omega = direction * turn;
        let screw = SteeringAxis::of_screw(&centre, &omega.cross(&(centre - point)), &omega);
        assert!(screw.direction.normalize().dot(&direction.normalize()) > 1.0 - 1e-15);
        assert!((screw.at_height(point.z) - point).norm() < 1e-15);
    }
}

#[test]
fn instant_centres_and_roll_centre_of_a_swing_axle_are_at_its_pivot() {
    // A swing axle turns about a line along x.
    let pivot = Vector3::new(0.0, 0.1, 0.25);
    for side in [1.0, -1.0] {
        let mirror = |v: Vector3<f64>| Vector3::new(v.x, side * v.y, v.z);
        let centre = mirror(Vector3::new(0.0, 0.75, RADIUS));
        let omega = Vector3::new(1.5 * side, 0.0, 0.0);
        let carrier = Carrier {
            centre,
            velocity: omega.cross(&(centre - mirror(pivot))),
            omega,
        };
        let front = carrier.front_view(&mirror(Vector3::y()));
        assert!((front.across - side * 0.1).abs() < 1e-15 && (front.z - 0.25).abs() < 1e-15);
        assert!((front.arm - 0.65).abs() < 1e-15);
        let ground = Vector3::new(0.0, centre.y, 0.0);
        // On the line from the contact point through the pivot.
        let expected = 0.25 * 0.75 / 0.65;
        assert!((carrier.roll_centre(&ground) - expected).abs() < 1e-15);
    }
    // A trailing arm turns about a line along y.
    let (pivot, omega) = (Vector3::new(0.5, 0.7, 0.35), Vector3::new(0.0, 2.0, 0.0));
    let centre = Vector3::new(0.0, 0.75, RADIUS);
    let carrier = Carrier {
        centre,
        velocity: omega.cross(&(centre - pivot)),
        omega,
    };
    let side = carrier.side_view();
    assert!((side.across - 0.5).abs() < 1e-15 && (side.z - 0.35).abs() < 1e-15);
    assert!((side.arm + 0.5).abs() < 1e-15, "it lies ahead");
}

#[test]
fn derivatives_of_wheel_quantities_agree_with_differences() {
    const H: f64 = 3e-4;
    let of = |bump: f64, steer: f64| {
        let mut corner: Corner = Corner::design().expect("a regular design");
        let start = corner.drives();
        let to = Drives {
            bump: start.bump + bump,
            steer: start.steer + steer,
        };
        corner.step(0.1, Signal::still(to)).expect("within reach");
        corner
    };
    for change in [[1.0, 0.0], [0.0, 1.0], [0.6, -0.3]] {
        let [bump, steer] = change;
        let per = of(0.03, 0.012)
            .per(Drives { bump, steer })
            .expect("regular")
            .points;
        let signals = [
            per.map(|points| points.lower_ball),
            per.map(|points| points.upper_ball),
            per.map(|points| points.axle),
            per.map(|points| points.wheel_centre),
        ];
        let signals = signals.each_ref().map(Signal::components);
        let analytic = formulas(signals, Signal::still(RADIUS));
        let near = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| {
            let points = of(0.03 + k * H * bump, 0.012 + k * H * steer)
                .points()
                .value;
            let four = [
                points.lower_ball,
                points.upper_ball,
                points.axle,
                points.wheel_centre,
            ];
            formulas(four, RADIUS)
        });
        for (index, signal) in analytic.iter().enumerate() {
            let [a, b, c, d, e] = near.map(|values| values[index]);
            assert!((signal.value - c).abs() < 1e-15, "{index}");
            let first = (8.0 * (d - b) - (e - a)) / (12.0 * H);
            assert!(
                (signal.rate - first).abs() < 2e-9,
                "{index}: {} {first}",
                signal.rate
            );
            let second = (16.0 * (b + d) - (a + e) - 30.0 * c) / (12.0 * H * H);
            let off = (signal.second_rate - second).abs();
            assert!(off < 2e-7, "{index}: {} {second}", signal.second_rate);
        }
    }
}
