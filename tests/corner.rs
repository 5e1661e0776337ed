//! `Corner`: a suspension with its motion, drives and time in one value.

mod beside;
mod drives;
mod no_length;
mod singular;
mod stored;
mod wheel_rates;

use nalgebra::Vector3;
use suspension_core::linkage::Designed;
use suspension_core::linkages::double_wishbone_pushrod::{Corner, Drives, Lengths, Model, Points};
use suspension_core::{Build, Signal, Values};
use suspension_runtime::Listing;

fn design() -> Corner {
    Corner::design().expect("a regular design")
}

/// Some way from the design, by bump and rack.
fn moved(bump: f64, steer: f64) -> Corner {
    let mut corner = design();
    let start = corner.drives();
    let to = Drives {
        bump: start.bump + bump,
        steer: start.steer + steer,
    };
    corner.step(0.1, Signal::still(to)).expect("within reach");
    corner
}

#[test]
fn a_corner_at_the_design_is_at_rest_at_the_stated_points() {
    let stated: Points<f64> = Model::design();
    let corner = design();
    let points = corner.points();
    for (point, at) in points.value.values().zip(stated.values()) {
        assert!((point - at).norm() < 1e-15);
    }
    assert_eq!(points.rate, Points::default());
    assert_eq!(corner.drives().bump, stated.wheel_centre.z);
    assert_eq!(corner.time(), 0.0);
    assert!(corner.wheel().is_some() && corner.kingpin().is_some());
}

#[test]
fn a_negative_time_step_leads_back() {
    let mut corner = moved(0.02, 0.005);
    let (drives, before) = (corner.drives(), corner.points());
    let signal = |time: f64| {
        let rate = Drives {
            bump: 0.7,
            steer: -0.2,
        };
        Signal::line(drives, rate, time)
    };
    corner.step(0.02, signal(0.02)).expect("within reach");
    corner.step(-0.02, signal(0.0)).expect("within reach");
    let points = corner.points();
    for (point, at) in points.value.values().zip(before.value.values()) {
        assert!((point - at).norm() < 1e-15);
    }
    assert!((corner.time() - 0.1).abs() < 1e-15);
    assert!((points.rate.wheel_centre.z - 0.7).abs() < 1e-12);
}

#[test]
fn derivatives_per_drive_agree_with_differences() {
    const H: f64 = 1e-3;
    let corner = moved(0.03, 0.01);
    for change in [
        Drives {
            bump: 1.0,
            steer: 0.0,
        },
        Drives {
            bump: 0.0,
            steer: 1.0,
        },
    ] {
        let per = corner.per(change).expect("regular");
        let along = |h: f64| {
            let corner = moved(0.03 + h * change.bump, 0.01 + h * change.steer);
            [
                corner.measures().value.damper,
                corner.measures().value.bar_arm,
            ]
        };
        let values = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| along(k * H));
        let analytic = [
            [per.measures.rate.damper, per.measures.second_rate.damper],
            [per.measures.rate.bar_arm, per.measures.second_rate.bar_arm],
        ];
        for (measure, [first, second]) in analytic.into_iter().enumerate() {
            let [a, b, c, d, e] = values.map(|measures| measures[measure]);
            let difference = (8.0 * (d - b) - (e - a)) / (12.0 * H);
            assert!((first - difference).abs() < 1e-8, "{first} {difference}");
            let difference = (16.0 * (b + d) - (a + e) - 30.0 * c) / (12.0 * H * H);
            assert!((second - difference).abs() < 1e-6, "{second} {difference}");
        }
    }
}

#[test]
fn an_advance_names_the_lock_and_stops_before() {
    let mut corner = design();
    let start = corner.drives();
    let rate = Drives {
        bump: 1.0,
        steer: 0.0,
    };
    let stopped = corner.advance(2.0, |time| Signal::line(start, rate, time));
    let message = stopped
        .expect_err("the wheel does not rise by two metres")
        .to_string();
    assert!(message.starts_with("stopped at time 0."), "{message}");
    assert!(message.contains('`'), "a name: {message}");
    let time = corner.time();
    assert!(time > 0.05 && time < 1.0, "{time}");
    assert!((corner.drives().bump - start.bump - time).abs() < 1e-15);
    assert!((corner.points().value.wheel_centre.z - corner.drives().bump).abs() < 1e-12);
}

/// The rocker locks where the pushrod can press it no further, the steering where the tie rod can: `suspension range`
/// names these links. The smallest pivot is that of the drop link, which hangs on the rocker and does not lock.
#[test]
fn a_lock_names_what_moves_there() {
    for (drive, moves) in [
        (
            [0.5, 0.0],
            ["pushrod_upper", "damper_outer", "bar_end"].as_slice(),
        ),
        ([0.0, 0.3], ["tie_ball", "wheel_centre"].as_slice()),
    ] {
        let mut corner = design();
        let start = corner.drives();
        let [bump, steer] = drive;
        let far = Drives {
            bump: start.bump + bump,
            steer: start.steer + steer,
        };
        let stopped = corner.step(1.0, Signal::still(far));
        let told = stopped.expect_err("beyond a lock").to_string();
        let named = |point: &&str| told.contains(&format!("unknown `{point}."));
        assert!(moves.iter().any(named), "{moves:?}: {told}");
    }
}

#[test]
fn a_refused_step_leaves_the_corner_unchanged() {
    let mut corner = moved(0.02, 0.0);
    let before = (corner.time(), corner.drives(), *corner.motion());
    let far = Drives {
        steer: 1.2,
        ..corner.drives()
    };
    corner
        .step(1e-3, Signal::still(far))
        .expect_err("beyond the reach of the tie rod");
    assert_eq!((corner.time(), corner.drives(), *corner.motion()), before);
}

/// The motion of a step from rest to rest, written as a function of time, stops at the same lock.
#[test]
fn step_towards_drives_out_of_reach_stops_at_the_lock() {
    const DT: f64 = 0.5;
    let (mut corner, mut led) = (design(), design());
    let start = corner.drives();
    let rise = |bump| Drives { bump, steer: 0.0 };
    let far = Drives {
        bump: start.bump + 1.0,
        ..start
    };
    let stopped = corner.step_towards(DT, Signal::still(far));
    let stopped = stopped.expect_err("the wheel does not rise by a metre");
    let cubic = |time: f64| {
        let s = time / DT;
        Signal {
            value: Drives {
                bump: start.bump + s * s * (3.0 - 2.0 * s),
                ..start
            },
            rate: rise(6.0 * s * (1.0 - s) / DT),
            second_rate: rise(6.0 * (1.0 - 2.0 * s) / (DT * DT)),
        }
    };
    led.advance(DT, cubic).expect_err("the same");
    assert_eq!(corner.time(), stopped.error.reached);
    assert!((corner.time() - led.time()).abs() < 1e-9);
    assert!((corner.drives().bump - led.drives().bump).abs() < 1e-9);
    let points = corner.points();
    let expected = cubic(corner.time());
    assert!((points.value.wheel_centre.z - expected.value.bump).abs() < 1e-12);
    assert!((points.rate.wheel_centre.z - expected.rate.bump).abs() < 1e-12);
    assert!((points.second_rate.wheel_centre.z - expected.second_rate.bump).abs() < 1e-10);
}

/// Whatever goes on, a failure states the time on the clock, that of the lock.
#[test]
fn failures_state_the_time_on_the_clock() {
    const START: f64 = 8.0;
    let mut corner = design();
    let here = Signal::still(corner.drives());
    corner.step(START, here).expect("a pause");
    let far = Drives {
        bump: corner.drives().bump + 1.0,
        ..corner.drives()
    };
    let refused = corner.step(0.5, Signal::still(far)).expect_err("a lock");
    let mut goes = corner;
    let stopped = goes.step_towards(0.5, Signal::still(far));
    let stopped = stopped.expect_err("a lock").error;
    assert_eq!(stopped.reached, goes.time());
    assert_eq!(refused.error.reached, stopped.reached);
    assert!((START + 0.05..START + 0.45).contains(&stopped.reached));
    assert!(
        refused.to_string().starts_with("stopped at time 8."),
        "{refused}"
    );
    let not_finite = Drives {
        bump: f64::NAN,
        ..far
    };
    let refused = corner
        .step(0.5, Signal::still(not_finite))
        .expect_err("NaN");
    assert_eq!(refused.error.reached, START);
}

#[test]
fn a_corner_with_a_changed_length_is_assembled() {
    let points = Model::design();
    let model = Model::new(&points).expect("a regular design");
    let mut lengths: Lengths<f64> = model.lengths();
    lengths.tie_rod += 0.005;
    let model = model.with_lengths(&lengths).expect("closed bodies");
    let corner = Corner::assembled(model, &points).expect("near by");
    let at = corner.points().value;
    assert!(((at.tie_ball - at.rack).norm() - lengths.tie_rod).abs() < 1e-14);
    assert_eq!(corner.drives().bump, points.wheel_centre.z);
    assert!((at.wheel_centre.z - points.wheel_centre.z).abs() < 1e-14);

    lengths.tie_rod += 2.0;
    let model = model.with_lengths(&lengths).expect("closed bodies");
    let refused = Corner::assembled(model, &points).expect_err("too long");
    assert!(refused.to_string().contains('`'), "a name: {refused}");
}

#[test]
fn a_listing_read_at_run_time_gives_the_same_corner() {
    let listings = suspension_core::linkages::LISTINGS;
    let (_, text) = listings
        .iter()
        .find(|(name, _)| *name == "double_wishbone_pushrod")
        .expect("in the catalogue");
    let listing = Listing::parse(text).expect("a listing");
    let hardpoints: Vec<Vector3<f64>> = listing.design().expect("all points are stated");
    let mut read = listing.corner::<30>(&hardpoints).expect("a geometry");
    let mut written = design();
    let start = written.drives();
    let rate = Drives {
        bump: 0.05,
        steer: 0.01,
    };
    let at = |time: f64| Signal::line(start, rate, time);
    written.advance(1.0, at).expect("within reach");
    read.advance(1.0, |time| {
        at(time).map(|drives| Values::from_values(drives.values()))
    })
    .expect("within reach");
    let [written, read] = [
        written.points(),
        read.points()
            .map(|points| Points::from_values(points.values())),
    ];
    assert_eq!(written, read);
}

/// A program whose `main` returns the error prints it so.
#[test]
fn the_debug_text_of_a_failure_is_its_message() {
    let mut corner = design();
    let far = Drives {
        bump: 9.0,
        ..corner.drives()
    };
    let failure = corner
        .step(1.0, Signal::still(far))
        .expect_err("out of reach");
    assert_eq!(format!("{failure:?}"), failure.to_string());
}
