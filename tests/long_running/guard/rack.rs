//! Jumps of a driven chassis point.

use suspension_core::step::tracker::Between;
use suspension_core::{Build, Inputs, Linkage, Motion, Signal, Still, Tracker, Values};

use super::random::Random;
use crate::double_wishbone;
use crate::double_wishbone::listing::{Drives, Fixed, Model, Points};

fn design(random: &mut Random, size: f64) -> Points<f64> {
    let points = double_wishbone::design();
    Points::from_values(points.values().map(|point| point + random.vector(size)))
}

/// The rack at a place, moving at a rate.
fn inputs<C: Copy>(chassis: C, bump: f64, [steer, rate]: [f64; 2]) -> Inputs<C, Drives<f64>> {
    Inputs {
        chassis,
        drives: Signal {
            value: Drives { bump, steer },
            rate: Drives {
                bump: 0.0,
                steer: rate,
            },
            second_rate: Drives::default(),
        },
    }
}

/// How many jumps in steps of length `dt` led to the right configuration, and how many were refused, of 20 in each of the designs.
fn jumps<C>(dt: f64, designs: usize, chassis: impl Fn(&Model<f64>) -> C) -> [usize; 2]
where
    C: Between<f64, Fixed<f64>>,
{
    let mut random = Random(5);
    let tracker = Tracker::default();
    let mut ends = [0, 0];
    for case in 0..designs {
        let design = design(&mut random, [0.02, 0.1, 0.2][case % 3]);
        let Ok(model) = Model::new(&design) else {
            continue;
        };
        let chassis = chassis(&model);
        let Drives { bump, steer } = model.drives_at(&design);
        let at = |steer: f64, rate: f64| inputs(chassis, bump, [steer, rate]);
        let mut start = Motion::at_rest(model.unknowns(&design));
        let set_off = tracker.step(&model, &at(steer, 0.0), 0.0, &mut start);
        if set_off.is_err() {
            continue;
        }
        // To where the tie rod has the other side, or nearly, with the ball where it is; or near by.
        let other_side = 2.0 * (design.tie_ball.y - design.rack.y);
        for index in 0..20 {
            let jump = if index % 2 == 0 { other_side } else { 0.0 };
            let jump = jump + (random.uniform() - 0.5) * 0.04;
            let mut motion = start;
            let between = [&at(steer, 0.0), &at(steer + jump, 0.0)];
            match tracker.step_between(&model, between, dt, &mut motion) {
                Ok(_) => {
                    let mut truth = start;
                    let way = |t: f64| at(steer + jump * t, jump);
                    tracker
                        .advance(&model, way, 0.0, 1.0, &mut truth)
                        .expect("no configuration, and yet a success");
                    let off = (motion.position - truth.position).amax();
                    assert!(off < 1e-7, "another assembly, {off} m away, case {case}");
                    ends[0] += 1;
                }
                Err(_) => {
                    assert_eq!(motion, start);
                    ends[1] += 1;
                }
            }
        }
    }
    ends
}

/// A link whose chassis end jumps to the link's other side leaves the free points where they are,
/// though the mechanism may lock on the way.
#[test]
fn no_jump_of_a_rack_passes_a_lock() {
    for (dt, designs, least) in [(1.0, 300, [2500, 1500]), (0.0, 60, [150, 600])] {
        let still = jumps(dt, designs, |_| Still);
        let moving = jumps(dt, designs, |model| Signal {
            value: *model.fixed(),
            rate: Fixed::default(),
            second_rate: Fixed::default(),
        });
        for [right, refused] in [still, moving] {
            println!("{dt} s: {right} right, {refused} refused");
            assert!(right > least[0] && refused > least[1], "{right}, {refused}");
        }
    }
}
