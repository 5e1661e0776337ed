//! A double wishbone with two drives, one of which moves a chassis point, on a moving chassis.

use nalgebra::Vector3;
use suspension_core::linkage::Named;
use suspension_core::path::{Continuation, Curve, End, Leader, Led, measured};
use suspension_core::{Build, Inputs, Linkage, Motion, Newton, Signal, Tangent, Values, assemble};

suspension_core::linkage! {
    /// Front-left double wishbone.
    mod double_wishbone {
        fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
        free:  lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;
        link lower_fore: lower_front -> lower_ball;
        link lower_aft:  lower_rear  -> lower_ball;
        link upper_fore: upper_front -> upper_ball;
        link upper_aft:  upper_rear  -> upper_ball;
        link tie_rod:    rack        -> tie_ball;
        body upright:    lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;
        drive bump:  axle_outer.z;
        drive steer: rack.y;
        measure height: axle_outer.z;
        measure damper: length(upper_front -> lower_ball);
        measure across: tie_ball.y;
    }
}

use double_wishbone::{Drives, Fixed, Model, Points};

/// The index of the drive of the rack.
const STEER: usize = 1;

fn design() -> Points<f64> {
    let at = Vector3::new;
    Points {
        lower_front: at(0.20, 0.35, 0.16),
        lower_rear: at(-0.20, 0.35, 0.16),
        upper_front: at(0.15, 0.42, 0.42),
        upper_rear: at(-0.15, 0.42, 0.42),
        rack: at(0.11, 0.34, 0.20),
        lower_ball: at(0.005, 0.70, 0.17),
        upper_ball: at(-0.015, 0.66, 0.44),
        tie_ball: at(0.12, 0.68, 0.21),
        axle_inner: at(0.0, 0.65, 0.30),
        axle_outer: at(0.0, 0.75, 0.30),
    }
}

fn model() -> Model<f64> {
    Model::new(&design()).expect("a double wishbone")
}

fn still(drives: Drives<f64>) -> Signal<Drives<f64>> {
    Signal {
        value: drives,
        rate: Drives::default(),
        second_rate: Drives::default(),
    }
}

#[test]
fn the_curve_of_the_rack_turns_where_the_tie_rod_is_in_line() {
    let model = model();
    let start = model.drives_at(&design());
    let inputs = Inputs::still(still(start));
    let q = model.unknowns(&design());
    for increasing in [true, false] {
        let curve = Curve::new(&model, &inputs, STEER).expect("a drive");
        let path = Continuation::default().path(curve, &q, increasing);
        let stretches: Vec<_> = path
            .expect("a regular start")
            .collect::<Result<_, _>>()
            .expect("a regular curve");
        for stretch in &stretches {
            let at = &stretch.place.configuration;
            let drives = Drives {
                steer: at.drive,
                ..start
            };
            let fixed = model.drive_anchors(*model.fixed(), &drives);
            let residual = model.residual(&at.unknowns, &fixed, &drives).amax();
            assert!(residual <= 16.0 * f64::EPSILON);
        }
        let end = stretches.last().and_then(|stretch| stretch.end);
        assert!(
            matches!(end, Some(End::Closed { gap }) if gap <= 1e-12),
            "{end:?}"
        );
        let turning = stretches.iter().find_map(|stretch| stretch.turning);
        let turning = turning.expect("steered as far as it goes").place;
        assert_eq!(turning.value > start.steer, increasing);
        // The rack moves along y: no more of it reaches the ball where the rod's pull has no
        // moment, to first order in the position.
        let beyond = (turning.value - start.steer) * 1e-6;
        let mut q = turning.configuration.unknowns;
        let drives = Drives {
            steer: turning.value + beyond,
            ..start
        };
        let found = Newton::near_by().solve(&model, &Inputs::still(still(drives)), &mut q);
        assert!(found.is_err(), "goes on beyond {}", turning.value);
    }
}

/// Everything swings: chassis points, each in its own way, bump and steer.
fn swinging(model: &Model<f64>, start: Drives<f64>) -> Inputs<Signal<Fixed<f64>>, Drives<f64>> {
    let mut number = 0.0;
    let mut rates = |size: f64| {
        Fixed::from_fn(|_| {
            number += 1.0_f64;
            Vector3::new(number.sin(), (2.0 * number).cos(), (3.0 * number).sin()) * size
        })
    };
    Inputs {
        chassis: Signal {
            value: *model.fixed(),
            rate: rates(0.1),
            second_rate: rates(1.0),
        },
        drives: Signal {
            value: Drives {
                bump: start.bump + 0.02,
                steer: start.steer - 0.01,
            },
            rate: Drives {
                bump: 0.3,
                steer: -0.2,
            },
            second_rate: Drives {
                bump: -1.0,
                steer: 2.0,
            },
        },
    }
}

#[test]
fn a_motion_led_by_a_measure_equals_the_driven_motion() {
    let model = model();
    let start = model.drives_at(&design());
    let inputs = swinging(&model, start);
    let mut q = model.unknowns(&design());
    assemble(&Newton::from_afar(), &model, &inputs, &mut q).expect("assembles");
    let tangent = Tangent::new(&model, &inputs, &q).expect("regular");
    let expected: Motion<f64, 15> = tangent.motion().expect("finite");
    let points = expected.points(&model, &inputs);
    for (drive, measure) in [(0, 0), (0, 1), (STEER, 2)] {
        let quantity = measured(&model, measure).expect("a measure");
        let target = quantity(&points);
        let beside = model.unknowns(&design());
        let curve = Curve::new(&model, &inputs, drive).expect("a drive");
        let mut led = Led::at_rest(&curve, &q).expect("regular");
        // The freed drive's own signal has no effect.
        let mut ignored = inputs;
        let freed = if drive == 0 { "bump" } else { "steer" };
        for part in [&mut ignored.drives.rate, &mut ignored.drives.second_rate] {
            *part = Drives::from_fn(|name| match name {
                _ if name == freed => 9.0,
                "bump" => part.bump,
                _ => part.steer,
            });
        }
        led.configuration.value.unknowns += (beside - q) * 0.1;
        Leader::default()
            .step(&model, &ignored, quantity, &target, 0.0, &mut led)
            .expect("near by");
        let found = led.configuration;
        let off = [
            (found.value.unknowns - expected.position).amax(),
            (found.rate.unknowns - expected.velocity).amax(),
            (found.second_rate.unknowns - expected.acceleration).amax(),
        ];
        assert!(
            off[0] <= 1e-14 && off[1] <= 1e-12 && off[2] <= 1e-10,
            "{freed} by {measure}: {off:?}"
        );
        let signal = led.drive(&model, &ignored);
        let of = |drives: Drives<f64>| drives.values().nth(drive).expect("a drive");
        assert!((signal.value - of(inputs.drives.value)).abs() <= 1e-14);
        assert!((signal.rate - of(inputs.drives.rate)).abs() <= 1e-12);
        assert!((signal.second_rate - of(inputs.drives.second_rate)).abs() <= 1e-10);
        let led_points = led.points(&model, &inputs);
        let apart = led_points
            .second_rate
            .values()
            .zip(points.second_rate.values());
        for (a, b) in apart {
            assert!((a - b).amax() <= 1e-10, "{a} {b}");
        }
    }
}
