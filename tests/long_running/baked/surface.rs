//! Surfaces of two drives.

use std::sync::atomic::AtomicBool;

use nalgebra::Vector3;
use suspension::bake::{RequestedPoints, WantedSurface, bake_surface};
use suspension_core::baked::Surface;
use suspension_core::{Build, Inputs, Linkage, Motion, Signal, Still, Tracker};

use super::mixed;
use crate::double_wishbone::design;
use crate::double_wishbone::listing::{Drives, Model, Points};

/// Travel of 80 mm and steering of 40 mm at the rack, either way, from the design.
const TRAVEL: f64 = 0.08;
const RACK: f64 = 0.04;

/// The rates at which the drives arrive.
const RATES: Drives<f64> = Drives {
    bump: 0.3,
    steer: -0.2,
};
const SECOND_RATES: Drives<f64> = Drives {
    bump: 2.0,
    steer: 1.0,
};

/// Of travel either way, and all of the rack's.
fn wanted(held: Drives<f64>, travel: f64, (tolerance, smooth): (f64, bool)) -> WantedSurface {
    WantedSurface {
        drives: [0, 1],
        ranges: [
            [held.bump - travel, held.bump + travel],
            [held.steer - RACK, held.steer + RACK],
        ],
        tolerance,
        metre: 1.0,
        smooth,
        points: RequestedPoints::Wheel(0),
    }
}

fn check_surface(tolerance: f64, smooth: bool, velocity_within: f64) {
    const SEED: u64 = 5;
    let design = design();
    let model = Model::new(&design).expect("a double wishbone");
    let at_rest = Motion::at_rest(model.unknowns(&design));
    let held = model.drives_at(&design);
    let wanted = wanted(held, TRAVEL, (tolerance, smooth));
    let ranges = wanted.ranges;
    let baked = bake_surface(&model, &at_rest, held, &wanted, &AtomicBool::new(false))
        .expect("within the tolerance");
    assert!(baked.reached.position <= tolerance);
    let table = baked.table::<6>().expect("six outputs");
    let surface = Surface {
        ranges,
        patches_per_unit: baked.patches_per_unit(),
        across: baked.counts[1],
        patches: &table,
    };
    let mut motion = at_rest;
    let mut worst = [0.0_f64; 3];
    let mut last = held;
    for drives in places(ranges, SEED) {
        let inputs = |part: f64| on_the_way(last, drives, part);
        motion = Motion::at_rest(motion.position);
        Tracker::default()
            .advance(&model, inputs, 0.0, 1.0, &mut motion)
            .expect("regular");
        let points = motion.points(&model, &inputs(1.0));
        let found = surface.at([drives.bump, drives.steer]).expect("inside");
        let found = found.acceleration(
            [RATES.bump, RATES.steer],
            [SECOND_RATES.bump, SECOND_RATES.steer],
        );
        let exact = [&points.value, &points.rate, &points.second_rate];
        for (worst, (found, exact)) in worst.iter_mut().zip(found.iter().zip(exact)) {
            *worst = worst.max(difference(found, exact));
        }
        last = drives;
    }
    let (reached, counts) = (baked.reached, baked.counts);
    let [by_bump, by_steer] = reached.first;
    let velocity = by_bump * RATES.bump.abs() + by_steer * RATES.steer.abs();
    for (worst, bound) in worst.iter().zip([reached.position, velocity]) {
        assert!(*worst <= bound, "seed {SEED}: {worst:e} > {bound:e}");
        assert!(*worst > 0.2 * bound, "{worst:e} is far less than {bound:e}");
    }
    assert!(worst[1] <= velocity_within, "{worst:?}, {counts:?} patches");
    assert!(surface.at([ranges[0][0] - 1e-9, held.steer]).is_err());
    let outside = surface.at([held.bump, ranges[1][1] + 1e-9]);
    assert_eq!(outside.expect_err("outside").nearest, ranges[1][1]);
    eprintln!("{counts:?} patches, worst {worst:?}");
}

/// Two thousand places.
fn places(ranges: [[f64; 2]; 2], seed: u64) -> impl Iterator<Item = Drives<f64>> {
    let numbers: Vec<f64> = mixed(seed).take(4000).collect();
    (0..numbers.len() / 2).map(move |place| {
        let [bump, steer] = [0, 1].map(|way| {
            let [from, to] = ranges[way];
            (from + (to - from) * numbers[2 * place + way]).min(to)
        });
        Drives { bump, steer }
    })
}

/// A part of the straight way from one place to another.
fn on_the_way(from: Drives<f64>, to: Drives<f64>, part: f64) -> Inputs<Still, Drives<f64>> {
    Inputs::still(Signal {
        value: Drives {
            bump: from.bump + (to.bump - from.bump) * part,
            steer: from.steer + (to.steer - from.steer) * part,
        },
        rate: RATES,
        second_rate: SECOND_RATES,
    })
}

/// How far the wheel centre or the spin axis is off.
fn difference(found: &[f64; 6], exact: &Points<f64>) -> f64 {
    let [a, b, c, d, e, f] = *found;
    let centre = Vector3::new(a, b, c) - exact.axle_outer;
    let axis = Vector3::new(d, e, f) - (exact.axle_outer - exact.axle_inner) / 0.1;
    centre.norm().max(axis.norm())
}

#[test]
fn a_surface_of_travel_and_steering_is_within_its_stated_errors() {
    for (tolerance, velocity_within) in [(1e-4, 1e-2), (1e-6, 3e-4), (1e-8, 1e-5)] {
        check_surface(tolerance, true, velocity_within);
        check_surface(tolerance, false, 3.0 * velocity_within);
    }
}

#[test]
fn a_surface_beyond_the_reach_of_the_mechanism_is_refused() {
    let design = design();
    let model = Model::new(&design).expect("a double wishbone");
    let at_rest = Motion::at_rest(model.unknowns(&design));
    let held = model.drives_at(&design);
    let wanted = wanted(held, 1.0, (1e-4, true));
    let refused = bake_surface(&model, &at_rest, held, &wanted, &AtomicBool::new(false))
        .expect_err("out of reach");
    let message = refused.to_string();
    assert!(
        message.starts_with("the mechanism does not reach -0.67"),
        "{message}"
    );
}
