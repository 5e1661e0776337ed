//! Paths of the drives from one input to another.

use nalgebra::{SVector, Vector3};
use suspension_core::linkages::double_wishbone::{Corner, Drives};
use suspension_core::linkages::five_link;
use suspension_core::{Inputs, Motion, Signal, Tracker, Values, linkage};

use crate::support;

linkage! {
    mod five_link_rack in "../../../suspension-core/src/linkages/five_link_rack.linkage";
}

/// However far apart two inputs, sub-steps lead from one to the other, at rest or not.
#[test]
fn sub_steps_lead_between_distant_inputs() {
    let model: five_link::Model<f64> = support::five_link_model();
    let inputs = support::five_link_inputs::<f64>;
    let motions = support::motions(&model, &support::five_link_rough(), inputs);
    let tracker = Tracker::default();
    let join = |from: usize, to: usize, dt: f64| {
        let [first, last] = [from, to].map(|instant| inputs(support::INSTANTS[instant]));
        let mut motion = motions[from];
        let advanced = tracker
            .step_between(&model, [&first, &last], dt, &mut motion)
            .expect("a configuration within reach");
        let off: SVector<f64, 15> = motion.position - motions[to].position;
        assert!(off.amax() < 1e-13, "{from} to {to}: {} m", off.amax());
        let off = motion.acceleration - motions[to].acceleration;
        let size = motions[to].acceleration.amax();
        assert!(off.amax() < 1e-10 * size, "the rates are those of the end");
        advanced.steps
    };
    for (from, to) in [(0, 8), (8, 0), (2, 5), (7, 1), (3, 3)] {
        let dt = support::INSTANTS[to] - support::INSTANTS[from];
        let dt = if dt == 0.0 { 1e-3 } else { dt };
        let steps = [dt, 1e-3].map(|dt| join(from, to, dt));
        println!("from instant {from} to {to}: {steps:?} sub-steps");
    }
    let locked = Inputs::still(Signal {
        value: five_link::Drives { theta: 3.0 },
        ..Signal::default()
    });
    let mut motion = motions[0];
    let ends = [&inputs(0.0), &locked];
    let stopped = tracker.step_between(&model, ends, 1.0, &mut motion);
    assert!(stopped.is_err_and(|stopped| stopped.reached < 1.0));
    assert_eq!(motion, motions[0]);
}

/// Travel of 50 mm at 3 Hz.
fn in_travel(start: Drives<f64>, t: f64) -> Signal<Drives<f64>> {
    let frequency = std::f64::consts::TAU * 3.0;
    let (sine, cosine) = (frequency * t).sin_cos();
    let travel = |bump: f64| Drives { bump, steer: 0.0 };
    Signal {
        value: Drives {
            bump: start.bump + 0.05 * sine,
            ..start
        },
        rate: travel(0.05 * frequency * cosine),
        second_rate: travel(-0.05 * frequency * frequency * sine),
    }
}

/// One tick whose rate is wrong is accepted, as its value is right; the cubic from there leads past a lock and back.
#[test]
fn one_wrong_rate_does_not_make_later_steps_fail() {
    for (dt, rate) in [(1.0 / 60.0, 150.0), (1e-3, 2500.0), (1e-3, 1e6)] {
        let mut corner: Corner = Corner::design().expect("a design");
        let rest = Signal::still(corner.drives());
        let mut wrong = rest;
        wrong.rate.bump = rate;
        corner.step(dt, wrong).expect("the value is right");
        for _ in 0..10 {
            corner.step(dt, rest).expect("the design position, at rest");
        }
        assert!(corner.motion().velocity.amax() < 1e-12);
    }
}

/// However long a program was stopped, its next step reaches the drives.
#[test]
fn a_step_after_a_long_stall_reaches_the_drives() {
    const TICK: f64 = 1.0 / 60.0;
    for stall in [0.1, 0.5, 1.0, 2.0, 5.0] {
        for trial in 0..40 {
            let mut corner: Corner = Corner::design().expect("a design");
            let start = corner.drives();
            let before = (30 + trial) as f64 * TICK;
            let after = before + stall + 0.0007 * f64::from(trial);
            corner.step(TICK, in_travel(start, 0.0)).expect("a tick");
            corner
                .step(before, in_travel(start, before))
                .expect("a tick");
            corner
                .step(after - before, in_travel(start, after))
                .expect("a tick");
            let mut direct: Corner = Corner::design().expect("a design");
            let drives_after = in_travel(start, after);
            direct.step(1.0, drives_after).expect("a configuration");
            let off = corner.motion().position - direct.motion().position;
            assert!(
                off.amax() < 1e-12,
                "{stall} s, trial {trial}: {} m",
                off.amax()
            );
        }
    }
}

/// A step beside a lock, the chassis moving, whose cubic locks: the straight way from rest must not lead past the lock into another
/// assembly. Found by a search over 100,000 random starts; the numbers are bits of the step's length, the sign of the
/// determinant, the motion, and drives and chassis points at both ends with their rates.
#[test]
fn a_straight_path_from_rest_beside_a_lock_stays_in_the_assembly() {
    let bits = include_str!("../../data/beside_a_lock.txt").lines();
    let bits = bits.map(|line| u64::from_str_radix(line, 16).expect("hexadecimal digits"));
    let mut numbers = bits.map(f64::from_bits);
    let mut next = || numbers.next().expect("a number");
    let (dt, sign) = (next(), next());
    let corner: five_link_rack::Corner = five_link_rack::Corner::design().expect("a design");
    let mut vector = || SVector::from_fn(|_, _| next());
    let start = Motion {
        position: vector(),
        velocity: vector(),
        acceleration: vector(),
        positive_determinant: Some(sign > 0.0),
    };
    let mut drives = || five_link_rack::Drives {
        bump: next(),
        steer: next(),
    };
    let drives: [Signal<_>; 2] = std::array::from_fn(|_| Signal {
        value: drives(),
        rate: drives(),
        second_rate: drives(),
    });
    let mut points = || {
        let count = five_link_rack::Listing::PARTS.chassis.len();
        let points: Vec<_> = (0..count)
            .map(|_| Vector3::from_fn(|_, _| next()))
            .collect();
        five_link_rack::Fixed::from_values(points)
    };
    let chassis: [Signal<_>; 2] = std::array::from_fn(|_| Signal {
        value: points(),
        rate: points(),
        second_rate: points(),
    });
    let [from, to] = [0, 1].map(|end| Inputs {
        chassis: chassis[end],
        drives: drives[end],
    });
    let tracker = Tracker::default();
    let mut motion = start;
    let stepped = tracker.step_between(corner.model(), [&from, &to], dt, &mut motion);
    stepped.expect("a configuration within reach");
    assert_eq!(motion.positive_determinant, start.positive_determinant);
    let mut cubic = start;
    let alone = tracker.advance_between(corner.model(), &mut from.clone(), &to, dt, &mut cubic);
    assert!(alone.is_err(), "the straight way is what is tested");
}
