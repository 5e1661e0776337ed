//! Random geometries near the published one: a step of fixed cost is the step to tolerance.
//! Failing cases print their values.

use nalgebra::Vector3;
use proptest::prelude::*;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{
    Bounded, Build, Inputs, Motion, Newton, Signal, Still, Tracker, Values, assemble,
};

use crate::inverse_norm;
use crate::support::{self, differences};

const STEP: f64 = 1e-3;

/// Steps that both made, and those that one or both refused.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    compared: usize,
    refused: usize,
}

/// The allowance for rounding errors of the motion where the Jacobian's inverse has the norm `inverse`.
fn bounds(inverse: f64, motion: &Motion<f64, 15>) -> [f64; 3] {
    let position = 64.0 * f64::EPSILON * inverse;
    let speed = 1.0 + motion.velocity.amax();
    let velocity = 4.0 * position * inverse * speed;
    [position, velocity, 4.0 * velocity * inverse * speed]
}

/// Steps through a tenth of a second from a displaced design, each step from the same motion.
fn compare<L: Build<15, Scalar = f64, Listing: Default>>(
    rough: &L::Points,
    by: &[f64],
    speed: f64,
) -> Result<Counts, TestCaseError> {
    let mut counts = Counts::default();
    let displaced = rough.values().zip(by.chunks_exact(3));
    let design = L::Points::from_values(
        displaced.map(|(point, by)| point + Vector3::new(by[0], by[1], by[2])),
    );
    let Ok(model) = L::of(L::Listing::default(), &design) else {
        return Ok(counts);
    };
    let start = model.drives_at(&design);
    let inputs = |t: f64| -> Inputs<Still, L::Drives> {
        Inputs::still(Signal {
            value: start.map(|start| start + speed * t),
            rate: start.map(|_| speed),
            second_rate: start.map(|_| 0.0),
        })
    };
    let mut q = model.unknowns(&design);
    let mut motion = Motion::at_rest(q);
    let tracker = Tracker::default();
    if assemble(&Newton::from_afar(), &model, &inputs(0.0), &mut q).is_err()
        || tracker
            .step(&model, &inputs(0.0), 0.0, &mut motion)
            .is_err()
    {
        return Ok(counts);
    }
    for step in 1..=20 {
        let inputs = inputs(f64::from(step) * STEP);
        let mut bounded = motion;
        let stepped = Bounded::<f64, 3>::new().step(&model, &inputs, STEP, &mut bounded);
        let before = motion;
        let tracked = tracker.step(&model, &inputs, STEP, &mut motion);
        match (stepped, tracked) {
            (Ok(settled), Ok(_)) => {
                prop_assert!(settled.residual() <= settled.tolerance());
                let jacobian = model.jacobian(&motion.position, model.fixed());
                let inverse = inverse_norm(&jacobian).expect("regular");
                let found = differences(&bounded, &motion);
                for (found, bound) in found.into_iter().zip(bounds(inverse, &motion)) {
                    prop_assert!(
                        found <= bound,
                        "{found:e} > {bound:e} at |1/J| = {inverse:e}"
                    );
                }
                counts.compared += 1;
            }
            (stepped, tracked) => {
                if stepped.is_err() {
                    prop_assert_eq!(bounded, before);
                }
                counts.refused += 1;
                if tracked.is_err() {
                    return Ok(counts);
                }
            }
        }
    }
    Ok(counts)
}

#[test]
fn a_bounded_step_agrees_with_the_step_to_tolerance() {
    let config = crate::config(500);
    let all = std::cell::Cell::new(Counts::default());
    let cases = (prop::collection::vec(-0.03_f64..0.03, 33), -1.0_f64..1.0);
    proptest!(config, |((by, speed) in cases)| {
        let listed = compare::<attia2003::Model<f64>>(&support::attia_rough(), &by, speed)?;
        let rigid = compare::<five_link::Model<f64>>(&support::five_link_rough(), &by, speed)?;
        let sum = all.get();
        all.set(Counts {
            compared: sum.compared + listed.compared + rigid.compared,
            refused: sum.refused + listed.refused + rigid.refused,
        });
    });
    let all = all.get();
    println!("{all:?}");
    assert!(
        all.compared > 10_000 && 20 * all.refused < all.compared,
        "{all:?}"
    );
}
