//! Each lane equals a single step, to rounding.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Build, Inputs, Listing};
use suspension_lanes::{Instructions, Lane, Lanes};

use super::fleet::{ALL, Fleet, Make, bits};
use crate::support;

const STEP: f64 = 1e-3;

/// Returns the largest differences in position, velocity and acceleration from single steps, over 0.6 s. Instructions that
/// the processor lacks are replaced.
fn worst<G, T, const LANES: usize>(
    fleet: &Fleet<G, T, LANES>,
    instructions: Instructions,
) -> [f64; 3]
where
    G: Listing<15> + Default,
    T: Lane + std::fmt::LowerExp,
    G::Model<T>: Build<15>,
    Lanes<G, T, 15, LANES>: Make<G, T, LANES>,
{
    let mut lanes = fleet.lanes(instructions);
    let mut alone = fleet.starts;
    let dt = T::constant(STEP);
    let mut worst = [0.0_f64; 3];
    for step in 1..=600 {
        let drives = fleet.drives(f64::from(step) * STEP);
        let results = lanes.step(Outputs::Acceleration, &drives, dt);
        for (lane, result) in results.into_iter().enumerate() {
            let inputs = Inputs::still(drives[lane]);
            let expected = &mut alone[lane];
            let settled = Bounded::<T>::default()
                .step(&fleet.models[lane], &inputs, dt, expected)
                .unwrap_or_else(|error| panic!("lane {lane}, step {step} alone: {error}"));
            let result = result.unwrap_or_else(|error| panic!("lane {lane}, step {step}: {error}"));
            assert_eq!(result.tolerance(), settled.tolerance());
            let found = lanes.motion(lane);
            assert_eq!(found.positive_determinant, expected.positive_determinant);
            if instructions == Instructions::Plain {
                assert_eq!(bits(&found), bits(expected));
            }
            let differences = [
                (found.position - expected.position).amax(),
                (found.velocity - expected.velocity).amax(),
                (found.acceleration - expected.acceleration).amax(),
            ];
            for (worst, difference) in worst.iter_mut().zip(differences) {
                *worst = worst.max(difference.to_subset().expect("finite"));
            }
        }
    }
    worst
}

fn agree<G, T, const LANES: usize>(rough: &G::Points<T>, bounds: [f64; 3])
where
    G: Listing<15> + Default,
    T: Lane + std::fmt::LowerExp,
    G::Model<T>: Build<15>,
    Lanes<G, T, 15, LANES>: Make<G, T, LANES>,
{
    let fleet = Fleet::<G, T, LANES>::displaced(rough);
    for instructions in ALL {
        let found = worst(&fleet, instructions);
        let number = std::any::type_name::<T>();
        println!("{LANES} lanes of {number}, {instructions:?}: {found:?}");
        for (found, bound) in found.into_iter().zip(bounds) {
            assert!(found <= bound, "{found:e} > {bound:e}");
        }
    }
}

fn all_lanes<T: Lane + std::fmt::LowerExp>(bounds: [f64; 3]) {
    println!("the best here: {:?}", Instructions::best());
    let listed = support::attia_rough::<T>();
    agree::<attia2003::Listing, T, 4>(&listed, bounds);
    let rigid = support::five_link_rough::<T>();
    agree::<five_link::Listing, T, 1>(&rigid, bounds);
    agree::<five_link::Listing, T, 4>(&rigid, bounds);
    agree::<five_link::Listing, T, 8>(&rigid, bounds);
}

#[test]
fn f64_lanes_agree_with_single_steps() {
    all_lanes::<f64>([1e-14, 2e-12, 5e-11]);
}

#[test]
fn f32_lanes_agree_with_single_steps() {
    all_lanes::<f32>([5e-6, 1e-3, 2e-2]);
}

/// Motions read from the lanes equal those that were written, and models are gathered number by number.
#[test]
fn lanes_return_motions_and_models_unchanged() {
    fn kept<T: Lane>() {
        let fleet = Fleet::<five_link::Listing, T, 8>::displaced(&support::five_link_rough());
        for instructions in ALL {
            let lanes = fleet.lanes(instructions);
            for (lane, start) in fleet.starts.iter().enumerate() {
                assert_eq!(bits(&lanes.motion(lane)), bits(start));
            }
        }
        let models = fleet.models.each_ref();
        for (lane, model) in models.into_iter().enumerate() {
            let gathered: five_link::Model<T> =
                five_link::Listing::gather(models[0], |read| models.map(read)[lane]);
            assert_eq!(gathered, *model);
        }
    }
    kept::<f64>();
    kept::<f32>();
    let single = support::five_link_model::<f32>();
    let double: five_link::Model<f64> =
        five_link::Listing::converted(&single, |x: f32| f64::from(x));
    let back: five_link::Model<f32> = five_link::Listing::converted(&double, |x: f64| x as f32);
    assert_eq!(back, single);
}

/// Lanes without corrections also refuse the steps that they would refuse alone.
#[test]
fn lanes_without_corrections_agree_with_single_steps() {
    let fleet = Fleet::<five_link::Listing, f32, 4>::displaced(&support::five_link_rough());
    let bounded = Bounded::<f32, 0>::new();
    for instructions in ALL {
        let mut lanes = Lanes::<five_link::Listing, f32, 15, 4, 0>::with(
            instructions,
            fleet.models,
            &fleet.starts,
        );
        let mut alone = fleet.starts;
        let mut refused = 0;
        for (t, dt) in (1..=300).map(|step| (step, 1)).chain([(350, 50)]) {
            let [t, dt] = [t, dt].map(|milliseconds| f64::from(milliseconds) * STEP);
            let drives = fleet.drives(t);
            let results = lanes.step(Outputs::Acceleration, &drives, dt as f32);
            for (lane, result) in results.into_iter().enumerate() {
                let (model, inputs) = (&fleet.models[lane], Inputs::still(drives[lane]));
                let expected = bounded.step(model, &inputs, dt as f32, &mut alone[lane]);
                assert_eq!(result.is_ok(), expected.is_ok(), "lane {lane} at {t} s");
                refused += i32::from(result.is_err());
                let found = lanes.motion(lane);
                assert!((found.position - alone[lane].position).amax() < 5e-6);
                assert!((found.velocity - alone[lane].velocity).amax() < 1e-3);
                assert!((found.acceleration - alone[lane].acceleration).amax() < 2e-2);
            }
        }
        assert_eq!(refused, 4);
    }
}
