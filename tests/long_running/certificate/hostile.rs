//! A NaN, or a number out of all proportion, is not proved, and the reason is given.

use nalgebra::{SVector, Vector3};
use suspension_core::certificate::{Certificate, Certifier, Unproved};
use suspension_core::linkages::five_link::{Drives, Fixed, Model};
use suspension_core::listing::Parts;
use suspension_core::signal::ChassisMotion;
use suspension_core::{Inputs, Linkage, Motion, Signal, SolveError, Values};

use crate::support;

/// Time of the configuration, s.
const INSTANT: f64 = 1.0;

fn regular() -> (Model<f64>, Motion<f64, 15>) {
    let model = support::five_link_model();
    let motions = support::motions(
        &model,
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    (model, motions[4])
}

fn reason<C: ChassisMotion<Fixed<f64>>>(
    model: &Model<f64>,
    inputs: &Inputs<C, Drives<f64>>,
    q: &SVector<f64, 15>,
) -> Unproved<f64> {
    match Certifier::new(model).certify(inputs, q) {
        Certificate::Unproved { why } => why,
        proved => panic!("{proved:?}"),
    }
}

const NO_NUMBERS: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

fn is_not_finite(why: &Unproved<f64>) -> bool {
    matches!(
        why,
        Unproved::NoBounds {
            cause: SolveError::NotFinite { .. }
        }
    )
}

#[test]
fn a_non_finite_position_or_drive_is_not_proved() {
    let (model, motion) = regular();
    let inputs = support::five_link_inputs(INSTANT);
    for odd in NO_NUMBERS {
        for unknown in 0..15 {
            let mut q = motion.position;
            q[unknown] = odd;
            let why = reason(&model, &inputs, &q);
            assert!(is_not_finite(&why), "{odd} in {unknown}: {why}");
        }
        let mut drives = inputs.drives;
        drives.value.theta = odd;
        let why = reason(&model, &Inputs::still(drives), &motion.position);
        let Unproved::NoBounds { cause } = why else {
            panic!("{why}")
        };
        assert_eq!(cause.part().map(|part| model.name(part)), Some("theta"));
        for anchor in 0..5 {
            let mut chassis = inputs.chassis.signal(model.fixed());
            let mut at = 0;
            let rest = *model.fixed();
            let points = rest.values();
            chassis.value = Fixed::from_values(points.map(|point| {
                at += 1;
                if at == anchor + 1 {
                    point + Vector3::y() * odd
                } else {
                    point
                }
            }));
            let why = reason(
                &model,
                &Inputs {
                    chassis,
                    drives: inputs.drives,
                },
                &motion.position,
            );
            assert!(is_not_finite(&why), "{odd} in anchor {anchor}: {why}");
        }
    }
}

#[test]
fn a_position_out_of_proportion_is_not_proved() {
    let (model, motion) = regular();
    let inputs = support::five_link_inputs(INSTANT);
    for size in [1e300, 1e160, 1e80, 1e20, 1e6, 1e2, 1e-2, 1e-20, 1e-310, 0.0] {
        let mut q = motion.position;
        q[7] = size;
        println!("{size:e}: {}", reason(&model, &inputs, &q));
        let why = reason(&model, &inputs, &SVector::repeat(size));
        println!("all {size:e}: {why}");
        let mut drives = inputs.drives;
        drives.value.theta = size;
        println!(
            "theta {size:e}: {}",
            reason(&model, &Inputs::still(drives), &motion.position)
        );
    }
    // A driving angle is not known beyond a thousand turns, whatever is stored.
    let turns = inputs.drives.value.theta + std::f64::consts::TAU * 1e4;
    let mut drives = inputs.drives;
    drives.value.theta = turns;
    let why = reason(&model, &Inputs::still(drives), &motion.position);
    assert!(is_not_finite(&why), "{why}");
}

#[test]
fn each_reason_for_a_failed_proof_is_reported() {
    let (model, motion) = regular();
    let inputs = support::five_link_inputs(INSTANT);
    let off = motion.position.add_scalar(1e-2);
    let why = reason(&model, &inputs, &off);
    assert!(
        matches!(why, Unproved::TooFar { correction, bound } if correction >= bound && bound > 0.0),
        "{why}"
    );
    let why = reason(&model, &inputs, &SVector::repeat(0.1));
    assert!(
        matches!(
            why,
            Unproved::NoBounds {
                cause: SolveError::Singular { .. }
            }
        ),
        "{why}"
    );
    println!("{}", reason(&model, &inputs, &off));
}

/// Rates do not enter, whatever they are.
#[test]
fn a_proof_does_not_depend_on_rates() {
    let (model, motion) = regular();
    let mut inputs = support::five_link_inputs(INSTANT);
    let plain = Certifier::new(&model).certify(&inputs, &motion.position);
    inputs.drives.rate = Drives { theta: f64::NAN };
    assert_eq!(
        Certifier::new(&model).certify(&inputs, &motion.position),
        plain
    );
    let signal: Signal<Fixed<f64>> = inputs.chassis.signal(model.fixed());
    let moving = Inputs {
        chassis: signal,
        drives: inputs.drives,
    };
    assert_eq!(
        Certifier::new(&model).certify(&moving, &motion.position),
        plain
    );
}
