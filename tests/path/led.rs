//! Motions led by another quantity than the drive.

use nalgebra::Vector3;
use suspension_core::path::{Leader, Led, Place};
use suspension_core::{
    Build, HasWheel, Inputs, Linkage, Motion, Named as _, Signal, SolveError, Still, Tangent,
};

use super::case::{Case, attia, five_link};
use crate::support::{INSTANTS, Reference, theta};

/// The height of the wheel centre with its rates.
fn height<P: HasWheel<f64>>(points: &Signal<P>) -> Signal<f64> {
    let z = |points: &P| points.wheel()[1].z;
    Signal {
        value: z(&points.value),
        rate: z(&points.rate),
        second_rate: z(&points.second_rate),
    }
}

fn still(value: f64) -> Signal<f64> {
    Signal {
        value,
        rate: 0.0,
        second_rate: 0.0,
    }
}

#[test]
fn look() {
    let case = attia::<f64>();
    let curve = case.curve();
    for stretch in case.path(true) {
        let p = &stretch.place;
        let pts = curve.points(&p.configuration);
        println!("{:.6} {:.6}", p.value, pts.wheel()[1].z);
    }
}

/// Led by the height of the wheel centre in the reference's motion, everything else is as in the
/// reference.
fn as_the_reference<L>(case: &Case<f64, L>, motions: &[Motion<f64, 15>])
where
    L: Build<15, Scalar = f64, Points: HasWheel<f64>>,
{
    let mut led = Led::at_rest(&case.curve(), &case.q).expect("regular");
    let inputs = (case.inputs)(0.0);
    let mut last = 0.0;
    for (instant, expected) in INSTANTS.iter().zip(motions) {
        let at = (case.inputs)(*instant);
        let target = height(&expected.points(&case.model, &at));
        let from = height(&led.points(&case.model, &inputs)).value;
        for part in 1..=20 {
            let part = f64::from(part) / 20.0;
            let mut on_the_way = still(from + (target.value - from) * part);
            if part == 1.0 {
                on_the_way = target;
            }
            let dt = if led.increases.is_none() { 0.0 } else { 0.0 };
            Leader::default()
                .step(&case.model, &inputs, height, &on_the_way, dt, &mut led)
                .expect("a regular motion");
        }
        let off = |a: &nalgebra::SVector<f64, 15>, b: nalgebra::SVector<f64, 15>| (a - b).amax();
        let found = led.configuration;
        println!(
            "{instant} {:e} {:e} {:e}",
            off(&found.value.unknowns, expected.position),
            off(&found.rate.unknowns, expected.velocity),
            off(&found.second_rate.unknowns, expected.acceleration)
        );
        let drive = led.drive(&case.model, &inputs);
        let expected = theta(*instant);
        println!(
            "  {:e} {:e} {:e}",
            drive.value - expected.value,
            drive.rate - expected.rate,
            drive.second_rate - expected.second_rate
        );
        last = *instant;
    }
}

#[test]
fn rates_are_those_of_the_reference() {
    let reference = Reference::load();
    let motions: Vec<_> = (0..INSTANTS.len())
        .map(|i| Motion {
            position: reference.unknowns(i, ""),
            velocity: reference.unknowns(i, "v"),
            acceleration: reference.unknowns(i, "a"),
            positive_determinant: None,
        })
        .collect();
    as_the_reference(&attia(), &motions);
    as_the_reference(&five_link(), &motions);
}
