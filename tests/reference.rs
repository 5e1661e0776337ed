//! Against the published mechanism solved in 40-digit arithmetic.

mod support;

use support::Reference;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::wheel::CarrierRotation;
use suspension_core::{Build, Linkage, Motion};

/// Largest differences from the reference: position, velocity, acceleration.
fn differences(motions: &[Motion<f64, 15>]) -> [f64; 3] {
    let reference = Reference::load();
    let mut worst = [0.0_f64; 3];
    for (instant, motion) in motions.iter().enumerate() {
        let ours = [motion.position, motion.velocity, motion.acceleration];
        for ((worst, ours), kind) in worst.iter_mut().zip(ours).zip(["", "v", "a"]) {
            *worst = worst.max((ours - reference.unknowns(instant, kind)).amax());
        }
        println!(
            "{instant} {:?}",
            ["", "v", "a"].map(|k| {
                let o = match k {
                    "" => motion.position,
                    "v" => motion.velocity,
                    _ => motion.acceleration,
                };
                (o - reference.unknowns(instant, k)).amax()
            })
        );
    }
    worst
}

#[test]
fn scratch() {
    let m = support::motions(
        &support::attia_model(),
        &support::attia_rough(),
        support::attia_inputs,
    );
    println!("{:?}", differences(&m));
    let m = support::motions(
        &support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    println!("{:?}", differences(&m));
}
