//! Surfaces of two drives.

use std::sync::atomic::AtomicBool;

use nalgebra::Vector3;
use suspension::bake::{WantedSurface, Wish, bake_surface};
use suspension_core::baked::Surface;
use suspension_core::{Build, Inputs, Linkage, Motion, Signal, Tracker};

use super::mixed;
use crate::double_wishbone::design;
use crate::double_wishbone::listing::{Drives, Model};

/// Travel of 80 mm and steering of 40 mm at the rack, either way, from the design.
const TRAVEL: f64 = 0.08;
const RACK: f64 = 0.04;

fn check_surface(tolerance: f64, smooth: bool, velocity_within: f64) {
    const SEED: u64 = 5;
    let design = design();
    let model = Model::new(&design).expect("a double wishbone");
    let at_rest = Motion::at_rest(model.unknowns(&design));
    let held = model.drives_at(&design);
    let ranges = [
        [held.bump - TRAVEL, held.bump + TRAVEL],
        [held.steer - RACK, held.steer + RACK],
    ];
    let wanted = WantedSurface {
        drives: [0, 1],
        ranges,
        tolerance,
        metre: 1.0,
        smooth,
        wish: Wish::Wheel,
    };
    let baked = bake_surface(&model, &at_rest, held, &wanted, &AtomicBool::new(false))
        .expect("within the tolerance");
    assert!(baked.reached <= tolerance);
    let table = baked.table::<6>().expect("six outputs");
    let surface = Surface {
        ranges,
        patches_per_unit: baked.patches_per_unit(),
        across: baked.counts[1],
        patches: &table,
    };
    let mut motion = at_rest;
    let mut worst = [0.0_f64; 3];
    let numbers: Vec<f64> = mixed(SEED).take(4000).collect();
    let mut last = held;
    for pair in numbers.chunks_exact(2) {
        let [bump, steer] = [0, 1].map(|way| {
            let [from, to] = ranges[way];
            (from + (to - from) * pair[way]).min(to)
        });
        let drives = Drives { bump, steer };
        let inputs = |part: f64| {
            let rate = |from: f64, to: f64| to - from;
            Inputs::still(Signal {
                value: Drives {
                    bump: last.bump + rate(last.bump, bump) * part,
                    steer: last.steer + rate(last.steer, steer) * part,
                },
                rate: Drives {
                    bump: 0.3,
                    steer: -0.2,
                },
                second_rate: Drives {
                    bump: 2.0,
                    steer: 1.0,
                },
            })
        };
        let still = Motion::at_rest(motion.position);
        motion = still;
        Tracker::default()
            .advance(&model, inputs, 0.0, 1.0, &mut motion)
            .expect("regular");
        let points = motion.points(&model, &inputs(1.0));
        let found = surface.at([bump, steer]).expect("inside");
        let found = found.acceleration([0.3, -0.2], [2.0, 1.0]);
        for (order, exact) in [&points.value, &points.rate, &points.second_rate]
            .into_iter()
            .enumerate()
        {
            let axis = (exact.axle_outer - exact.axle_inner) / 0.1;
            let exact = [exact.axle_outer, axis];
            for (found, exact) in points_of(&found[order]).iter().zip(&exact) {
                worst[order] = worst[order].max((found - exact).norm());
            }
        }
        last = drives;
    }
    assert!(
        worst[0] <= baked.reached,
        "seed {SEED}: {worst:?} > {:e}",
        baked.reached
    );
    assert!(
        worst[0] > 0.2 * baked.reached,
        "{worst:?} is far less than {:e}",
        baked.reached
    );
    assert!(
        worst[1] <= velocity_within,
        "{worst:?}, {:?} patches",
        baked.counts
    );
    assert!(surface.at([ranges[0][0] - 1e-9, held.steer]).is_err());
    let outside = surface
        .at([held.bump, ranges[1][1] + 1e-9])
        .expect_err("outside");
    assert_eq!(outside.nearest, ranges[1][1]);
    eprintln!("{:?} patches, worst {worst:?}", baked.counts);
}

fn points_of(numbers: &[f64; 6]) -> [Vector3<f64>; 2] {
    let [a, b, c, d, e, f] = *numbers;
    [Vector3::new(a, b, c), Vector3::new(d, e, f)]
}

#[test]
fn a_surface_of_travel_and_steering_is_as_close_to_the_solver_as_it_says() {
    for (tolerance, velocity_within) in [(1e-4, 1e-2), (1e-6, 3e-4), (1e-8, 1e-5)] {
        check_surface(tolerance, true, velocity_within);
        check_surface(tolerance, false, 3.0 * velocity_within);
    }
}

#[test]
fn a_surface_beyond_the_mechanism_is_refused() {
    let design = design();
    let model = Model::new(&design).expect("a double wishbone");
    let at_rest = Motion::at_rest(model.unknowns(&design));
    let held = model.drives_at(&design);
    let wanted = WantedSurface {
        drives: [0, 1],
        ranges: [
            [held.bump - 1.0, held.bump + 1.0],
            [held.steer - RACK, held.steer + RACK],
        ],
        tolerance: 1e-4,
        metre: 1.0,
        smooth: true,
        wish: Wish::Wheel,
    };
    let refused = bake_surface(&model, &at_rest, held, &wanted, &AtomicBool::new(false))
        .expect_err("out of reach");
    let message = refused.to_string();
    assert!(
        message.starts_with("the mechanism does not reach -0.67"),
        "{message}"
    );
}
