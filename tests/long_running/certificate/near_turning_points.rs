//! The published mechanism at its turning points, where two assemblies meet, and beyond.

use fastrand::Rng;
use nalgebra::SVector;
use suspension_core::certificate::Certifier;
use suspension_core::linkages::five_link::{Drives, Model};
use suspension_core::{Inputs, Linkage, Motion, Signal, Still, Tangent, Tracker};

use super::judge::{judge, proof};
use super::random::{Counts, power_of_ten, sign, sum_of_cases, uniform};
use super::refine::Refiner;
use crate::support;

/// Turning points, rad (extended system, 40 digits), and the side on which the mechanism moves.
const TURNING_POINTS: [(f64, f64); 2] = [
    (0.662_460_552_146_186_5, 1.0),
    (2.178_426_263_359_593, -1.0),
];

/// Distance from a turning point, rad, that its last digit makes uncertain.
const UNCERTAIN: f64 = 1e-15;

fn inputs(theta: f64, rate: f64) -> Inputs<Still, Drives<f64>> {
    Inputs::still(Signal {
        value: Drives { theta },
        rate: Drives { theta: rate },
        second_rate: Drives::default(),
    })
}

/// The two branches near a turning point: `middle +- across sqrt(distance)` at a distance in rad.
#[derive(Clone, Copy)]
struct Fold {
    theta: f64,
    inside: f64,
    middle: SVector<f64, 15>,
    across: SVector<f64, 15>,
}

impl Fold {
    fn find(model: &Model<f64>, start: &Motion<f64, 15>, (theta, inside): (f64, f64)) -> Self {
        let distance = 1e-6;
        let near = theta + inside * distance;
        let mut motion = *start;
        let towards = |t: f64| inputs(0.7 + (near - 0.7) * t, near - 0.7);
        let tracker = Tracker::default();
        tracker
            .step(model, &towards(0.0), 0.0, &mut motion)
            .expect("regular");
        tracker
            .advance(model, towards, 0.0, 1.0, &mut motion)
            .expect("no lock before");
        let at = motion.position;
        let slope = Tangent::new(model, &inputs(near, inside), &at)
            .expect("regular")
            .velocity();
        Self {
            theta,
            inside,
            middle: at - slope * (2.0 * distance),
            across: slope * (2.0 * distance.sqrt()),
        }
    }

    fn on_branch(&self, side: f64, distance: f64) -> SVector<f64, 15> {
        self.middle + self.across * (side * distance.sqrt())
    }
}

/// Ten places at one drive value.
fn case(
    certifier: &Certifier<Model<f64>, 15>,
    refiner: &Refiner<Model<f64>, 15>,
    model: &Model<f64>,
    folds: &[Fold],
    seed: u64,
    rng: &mut Rng,
) -> Counts {
    let fold = folds[rng.usize(..folds.len())];
    let theta = fold.theta + sign(rng) * fold.theta * power_of_ten(rng, -16.0..-2.0);
    let distance = fold.inside * (theta - fold.theta);
    let roots: Vec<_> = if distance > UNCERTAIN {
        [1.0, -1.0]
            .map(|side| {
                let near = fold.on_branch(side, distance);
                let root = refiner.root(model.fixed(), &Drives { theta }, &near);
                root.unwrap_or_else(|| {
                    panic!("seed {seed}: no root at {distance:e} from the turning point")
                })
            })
            .into()
    } else {
        Vec::new()
    };
    let mut counts = Counts::default();
    for _ in 0..10 {
        let mut q = match roots.get(rng.usize(..2)) {
            Some(root) => root.map(|entry| entry.nearest()),
            None => fold.on_branch(sign(rng), power_of_ten(rng, -16.0..-2.0)),
        };
        if rng.u8(0..3) > 0 {
            let by = power_of_ten(rng, -16.0..-1.0);
            q += SVector::from_fn(|_, _| uniform(rng, -by..by));
        }
        let certificate = certifier.certify(&inputs(theta, 0.0), &q);
        counts += judge(
            proof(&certificate),
            &q,
            &roots,
            ("theta", theta, "seed", seed),
        );
    }
    counts
}

fn folds(model: &Model<f64>) -> [Fold; 2] {
    let motions = support::motions(
        model,
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    TURNING_POINTS.map(|point| Fold::find(model, &motions[0], point))
}

/// How near to a turning point, rad, a root that is exact to rounding is proved.
const PROVED_TO: f64 = 5e-13;

#[test]
fn proofs_near_turning_points_reach_as_far_as_rounding_allows() {
    let model = support::five_link_model();
    let (certifier, refiner) = (Certifier::new(&model), Refiner::new(&model));
    for fold in folds(&model) {
        for exponent in 2..15 {
            let theta = fold.theta + fold.inside * 10.0_f64.powi(-exponent);
            let distance = fold.inside * (theta - fold.theta);
            let near = fold.on_branch(1.0, distance);
            let root = refiner.root(model.fixed(), &Drives { theta }, &near);
            let q = root.expect("a root").map(|entry| entry.nearest());
            let certificate = certifier.certify(&inputs(theta, 0.0), &q);
            println!("{distance:.1e} rad: {certificate:?}");
            assert!(certificate.is_proved() || distance < PROVED_TO);
        }
    }
}

/// A million with those of [`near_singular`](super::near_singular).
#[test]
fn no_proof_is_false_near_turning_points() {
    let model = support::five_link_model();
    let folds = folds(&model);
    let (certifier, refiner) = (Certifier::new(&model), Refiner::new(&model));
    let cases = 10_000;
    let counts = sum_of_cases(cases, |seed, rng| {
        case(&certifier, &refiner, &model, &folds, seed, rng)
    });
    println!("ten places at each of seeds 0..{cases}: {counts:?}");
    assert!(counts.proved > counts.cases / 10 && counts.refused > counts.cases / 4);
}
