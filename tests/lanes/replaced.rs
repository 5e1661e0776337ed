//! A lane that gets another model goes on as if it had always had it, and its neighbours are not affected.

use nalgebra::Vector3;
use suspension_core::Values;
use suspension_core::linkages::five_link;
use suspension_core::step::bounded::Outputs;
use suspension_lanes::{Lane, Lanes};

use super::fleet::{ALL, Fleet, Make, bits};
use crate::support;

const STEP: f64 = 1e-3;

/// Replaces the model of lane `replaced` before the tenth step.
fn replace_a_lane<T, const LANES: usize>(replaced: usize)
where
    T: Lane + std::fmt::LowerExp,
    Lanes<five_link::Listing, T, 15, LANES>: Make<five_link::Listing, T, LANES>,
{
    let rough = support::five_link_rough();
    let fleet = Fleet::<five_link::Listing, T, LANES>::displaced(&rough);
    // The suspension on the other side of the vehicle.
    let across = rough
        .values()
        .map(|point| Vector3::new(point.x, -point.y, point.z));
    let other = Fleet::<five_link::Listing, T, LANES>::new([Values::from_values(across); LANES]);
    let dt = T::constant(STEP);
    for instructions in ALL {
        let [mut lanes, mut sound] = [0; 2].map(|_| fleet.lanes(instructions));
        let mut fresh = other.lanes(instructions);
        for step in 1..=20 {
            let old_drives = fleet.drives(f64::from(step) * STEP);
            let new_drives = other.drives(f64::from(step - 9) * STEP);
            let mut drives = old_drives;
            if step == 10 {
                let (model, motion) = (other.models[replaced], &other.starts[replaced]);
                lanes.replace(replaced, model, motion);
            }
            if step >= 10 {
                drives[replaced] = new_drives[replaced];
                let results = fresh.step(Outputs::Acceleration, &new_drives, dt);
                assert!(results.iter().all(Result::is_ok));
            }
            let results = lanes.step(Outputs::Acceleration, &drives, dt);
            assert!(results.iter().all(Result::is_ok));
            sound.step(Outputs::Acceleration, &old_drives, dt);
            for lane in 0..LANES {
                let is_replaced = lane == replaced && step >= 10;
                let expected = if is_replaced { &fresh } else { &sound };
                assert_eq!(bits(&lanes.motion(lane)), bits(&expected.motion(lane)));
            }
        }
    }
}

#[test]
fn a_replaced_lane_steps_with_its_new_model_and_the_others_go_on() {
    replace_a_lane::<f64, 1>(0);
    replace_a_lane::<f64, 4>(2);
    replace_a_lane::<f64, 8>(6);
    replace_a_lane::<f32, 4>(0);
    replace_a_lane::<f32, 8>(7);
}
