//! Random geometries: what `f64` does, `f32` does within its rounding, or refuses where the
//! linkage is nearly singular.

use nalgebra::{SVector, Vector3};
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{Build, Inputs, Linkage, Motion, Real, Signal, Still, Values};

use super::case::{Built, Tested, WAYS, Way, single};
use crate::inverse_norm;

const SEED: u64 = 20_261_121;
const GEOMETRIES: usize = 40;
const STEPS: usize = 100;
const STEP: f64 = 1e-3;

/// The outcomes of the steps of all geometries.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    accepted: usize,
    /// Refused by `f32` alone.
    refused: usize,
    /// The smallest norm of the Jacobian's inverse in these.
    firmest: f64,
    /// The largest error, as a multiple of that norm times rounding.
    worst: f64,
}

fn turning<T: Real, D: Values<T> + Default>(theta: f64, rate: f64) -> Inputs<Still, D> {
    Inputs::still(Signal {
        value: D::from_values(std::iter::repeat(T::constant(theta))),
        rate: D::from_values(std::iter::repeat(T::constant(rate))),
        second_rate: D::default(),
    })
}

/// Steps in both number types from the design on, until one refuses.
fn compare<G: Tested>(
    design: &G::Points<f64>,
    built: Built,
    way: Way,
    rate: f64,
    counts: &mut Counts,
) {
    let model = G::Model::<f64>::of(G::default(), design);
    let (Ok(model), Some(single)) = (model, single::<G>(design, built)) else {
        return;
    };
    let origin = SVector::<f64, 15>::from_fn(|row, _| single.origin[row % 3]);
    let theta = model.drives_at(design).values().next().unwrap_or_default();
    let mut exact = Motion::at_rest(model.unknowns(design));
    let mut motion = single.start;
    for step in 0..=STEPS {
        let dt = if step == 0 { 0.0 } else { STEP };
        let theta = theta + rate * STEP * step as f64;
        let before = motion;
        if way
            .exact()
            .step(&model, &turning(theta, rate), dt, &mut exact)
            .is_err()
        {
            return;
        }
        let jacobian = model.jacobian(&exact.position, model.fixed());
        let inverse = inverse_norm(&jacobian).unwrap_or(f64::INFINITY);
        let stepped = way.step(&single.model, &turning(theta, rate), dt, &mut motion);
        if stepped.is_err() {
            assert_eq!(motion, before);
            counts.refused += 1;
            counts.firmest = counts.firmest.min(inverse);
            return;
        }
        let off = (motion.position.map(f64::from) + origin - exact.position).amax();
        let coordinates = before.position.amax().max(single.model.size());
        let rounding = f64::from(f32::EPSILON * coordinates);
        counts.worst = counts.worst.max(off / (inverse * rounding));
        counts.accepted += 1;
    }
}

fn check<G: Tested>(rng: &mut fastrand::Rng) {
    let home = G::design();
    for (built, away) in [
        (Built::Rounded, 0.0),
        (Built::InPlace, 0.0),
        (Built::InPlace, 30.0),
    ] {
        let mut all = [Counts {
            firmest: f64::INFINITY,
            ..Counts::default()
        }; WAYS.len()];
        for _ in 0..GEOMETRIES {
            let mut near = || 0.06 * (rng.f64() - 0.5);
            let design = G::Points::<f64>::from_values(
                home.values()
                    .map(|point| point.add_scalar(away) + Vector3::new(near(), near(), near())),
            );
            let rate = 2.0 * (rng.f64() - 0.5);
            for (way, counts) in WAYS.into_iter().zip(&mut all) {
                compare::<G>(&design, built, way, rate, counts);
            }
        }
        for (way, counts) in WAYS.into_iter().zip(all) {
            println!("{} {built:?}, {away} m away, {way:?}: {counts:?}", G::NAME);
            assert!(counts.worst <= 1.0);
            if way == Way::Bounded0 {
                // It refuses what is not rounding beside the size, as large coordinates are.
                continue;
            }
            assert!(counts.accepted > 2000 && counts.refused * 1000 <= counts.accepted);
            assert!(counts.firmest > 1.0 / (8.0 * f64::from(f32::EPSILON).sqrt()));
        }
    }
}

#[test]
fn f32_steps_of_random_geometries_are_within_rounding_or_refused() {
    let mut rng = fastrand::Rng::with_seed(SEED);
    println!("seed {SEED}");
    check::<five_link::Listing>(&mut rng);
    check::<attia2003::Listing>(&mut rng);
}
