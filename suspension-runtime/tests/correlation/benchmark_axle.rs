//! The benchmark axle of a fork of open-kinematics: nine states, by its own solver.

use nalgebra::Vector3;
use suspension_core::wheel::{camber, toe};

use crate::agreement::Agreement;
use crate::published::{adams_name, folder, geometry, numbers, point};
use crate::suspension::{DOUBLE_WISHBONE, Suspension, half_turn};

#[test]
fn the_benchmark_axle_agrees_with_open_kinematics() {
    let Some(folder) = folder("benchmark_axle") else {
        return;
    };
    let table = geometry(&folder.join("suspension_mbd_benchmark_axle.toml"));
    let suspension = Suspension::new(DOUBLE_WISHBONE, |name| {
        let at = half_turn(point(&table[adams_name(name)]));
        // The wheel stands upright and straight ahead.
        let inboard = Vector3::new(0.0, if name == "axle_inboard" { -100.0 } else { 0.0 }, 0.0);
        at + inboard
    });
    let mut agreement = Agreement::default();
    for state in table["states"].as_array().expect("states") {
        let state = numbers(state);
        let at = suspension.design().moved([state[0], -state[1]]);
        let (moving, degrees) = (at.in_bump(), f64::to_degrees);
        let (centre, axis) = (moving.centre(), moving.spin_axis());
        let differences = [centre.x.value, centre.y.value + state[2]];
        for difference in differences {
            agreement.note("wheel centre", 1e-8, difference);
        }
        agreement.note("toe", 1e-8, degrees(toe(&axis).value) - state[3]);
        agreement.note("camber", 1e-8, degrees(camber(&axis).value) - state[4]);
    }
    agreement.holds("benchmark axle", 36);
}
