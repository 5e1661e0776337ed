//! A lane that fails reports the reason and stays unchanged; its neighbours are not affected.

use nalgebra::Vector3;
use suspension_core::linkage::Factors as _;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::listing::Part;
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Inputs, Linkage, SolveError, Tracker};
use suspension_lanes::{Lane, Lanes};

use super::fleet::{ALL, Fleet, Make, bits};
use crate::support;

const STEP: f64 = 1e-3;

/// Angles that no step of a millisecond reaches: NaN, one half a radian ahead, and one at which the linkage has no
/// configuration.
const OUT_OF_REACH: [fn(f64) -> f64; 3] = [|_| f64::NAN, |start| start + 0.5, |_| 3.1];

/// Follows a fleet with the angle of lane `bad` out of reach in the tenth step, and without.
fn step_with_one_failing_lane<T, const LANES: usize>(bad: usize)
where
    T: Lane + std::fmt::LowerExp,
    Lanes<five_link::Listing, T, 15, LANES>: Make<five_link::Listing, T, LANES>,
{
    let fleet = Fleet::<five_link::Listing, T, LANES>::displaced(&support::five_link_rough());
    let dt = T::constant(STEP);
    let all = ALL.into_iter();
    for (instructions, out_of_reach) in all.flat_map(|one| OUT_OF_REACH.map(|angle| (one, angle))) {
        let mut sound = fleet.lanes(instructions);
        let mut spoiled = fleet.lanes(instructions);
        for step in 1..=20 {
            let mut drives = fleet.drives(f64::from(step) * STEP);
            let results = sound.step(Outputs::Acceleration, &drives, dt);
            assert!(results.iter().all(Result::is_ok));
            let theta = &mut drives[bad].value.theta;
            if step == 10 {
                *theta = T::constant(out_of_reach(theta.to_subset().expect("f64")));
            }
            let before = spoiled.motion(bad);
            let results = spoiled.step(Outputs::Acceleration, &drives, dt);
            for lane in (0..LANES).filter(|lane| *lane != bad) {
                assert!(results[lane].is_ok());
                assert_eq!(bits(&spoiled.motion(lane)), bits(&sound.motion(lane)));
            }
            if step == 10 {
                let error = results[bad].expect_err("out of reach");
                assert_eq!(bits(&spoiled.motion(bad)), bits(&before));
                let inputs = Inputs::still(drives[bad]);
                let alone = Bounded::<T>::default()
                    .step(&fleet.models[bad], &inputs, dt, &mut before.clone())
                    .expect_err("nor alone");
                assert_eq!(error, alone);
                let not_a_number = matches!(
                    error,
                    SolveError::NotFinite {
                        part: Part::Equation(14)
                    }
                );
                assert_eq!(not_a_number, !inputs.drives.value.theta.is_finite());
            }
        }
    }
}

#[test]
fn a_failed_lane_stays_unchanged_and_the_others_advance() {
    step_with_one_failing_lane::<f64, 1>(0);
    step_with_one_failing_lane::<f64, 4>(2);
    step_with_one_failing_lane::<f64, 8>(7);
    step_with_one_failing_lane::<f32, 1>(0);
    step_with_one_failing_lane::<f32, 4>(0);
    step_with_one_failing_lane::<f32, 8>(3);
}

#[test]
fn a_lane_that_missed_a_step_is_restored_among_the_others() {
    const LANE: usize = 2;
    let fleet = Fleet::<five_link::Listing, f64, 4>::displaced(&support::five_link_rough());
    let at = |step: i32| fleet.drives(f64::from(step) * STEP);
    for instructions in ALL {
        let mut sound = fleet.lanes(instructions);
        let mut lanes = fleet.lanes(instructions);
        for step in 1..=20 {
            let mut drives = at(step);
            let results = sound.step(Outputs::Acceleration, &drives, STEP);
            assert!(results.iter().all(Result::is_ok));
            if step == 10 {
                drives[LANE].value.theta = f64::NAN;
            }
            let results = lanes.step(Outputs::Acceleration, &drives, STEP);
            assert_eq!(results[LANE].is_ok(), step != 10);
            if step == 10 {
                let ends = [at(step - 1), at(step)].map(|drives| Inputs::still(drives[LANE]));
                let mut motion = lanes.motion(LANE);
                Tracker::default()
                    .step_between(&fleet.models[LANE], ends.each_ref(), STEP, &mut motion)
                    .expect("a step that is not refused");
                lanes.set_motion(LANE, &motion);
            }
        }
        let [found, expected] = [&lanes, &sound].map(|lanes| lanes.motion(LANE));
        assert!((found.position - expected.position).amax() < 1e-14);
        assert!((found.velocity - expected.velocity).amax() < 1e-12);
        assert_eq!(found.positive_determinant, expected.positive_determinant);
    }
}

/// Designs with link 6-1 perpendicular to an axis, where a pivot of the macro's order is zero, among others: lanes solved
/// with partial pivoting succeed, and do not affect their neighbours.
#[test]
fn a_lane_with_small_pivots_is_solved_by_partial_pivoting() {
    use attia2003::{Listing, Model, Points};
    let design = support::attia_rough::<f64>();
    let square_to = |link| Points {
        p6: design.p1 + link,
        ..design
    };
    let squares = [Vector3::new(0.0, 0.3, 0.33), Vector3::new(0.3, 0.0, 0.33)].map(square_to);
    let mixed = Fleet::<Listing, f64, 4>::new([design, squares[0], squares[1], design]);
    let sound = Fleet::<Listing, f64, 4>::new([design; 4]);
    let unhealthy = [1, 2].map(|lane: usize| {
        let model: &Model<f64> = &mixed.models[lane];
        let factors = model.factor(&mixed.starts[lane].position, model.fixed());
        factors.growth_squared().is_nan() || factors.growth_squared() > 1e6
    });
    assert!(unhealthy.contains(&true), "a zero pivot along x or y");
    for instructions in ALL {
        let [mut lanes, mut others] = [&mixed, &sound].map(|fleet| fleet.lanes(instructions));
        let drives = mixed.drives(0.0);
        for result in lanes.step(Outputs::Acceleration, &drives, 0.0) {
            let settled = result.expect("regular");
            assert!(settled.growth() < 1e3 && settled.residual() <= settled.tolerance());
        }
        let results = others.step(Outputs::Acceleration, &sound.drives(0.0), 0.0);
        assert!(results.iter().all(Result::is_ok));
        for lane in [0, 3] {
            assert_eq!(bits(&lanes.motion(lane)), bits(&others.motion(lane)));
        }
        for lane in [1, 2] {
            let mut expected = mixed.starts[lane];
            let inputs = Inputs::still(drives[lane]);
            Tracker::default()
                .step(&mixed.models[lane], &inputs, 0.0, &mut expected)
                .expect("regular");
            let found = lanes.motion(lane);
            assert!((found.position - expected.position).amax() < 1e-14);
            assert!((found.velocity - expected.velocity).amax() < 1e-12);
            assert!((found.acceleration - expected.acceleration).amax() < 1e-11);
        }
    }
}
