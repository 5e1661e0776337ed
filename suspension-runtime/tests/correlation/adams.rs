//! MSC Adams/Car 2024.1, kinematic mode: a double wishbone with rack steering, nine states, both sides.

use nalgebra::Vector3;
use suspension_core::wheel::{camber_to_ground, toe};

use crate::agreement::Agreement;
use crate::published::{adams_name, folder, geometry, point, results, vector};
use crate::suspension::{DOUBLE_WISHBONE, Suspension, half_turn, values};

/// Compares a side, to which `y` of the listed left one is turned.
fn compare(side: &str, y: f64) {
    let Some(folder) = folder("adams") else {
        return;
    };
    let table = geometry(&folder.join("adams_dw_tr_front.toml"));
    let suspension = Suspension::new(DOUBLE_WISHBONE, |name| {
        let at = half_turn(point(&table["left"][adams_name(name)]));
        // The wheel stands upright and straight ahead.
        let inboard = if name == "axle_inboard" { 100.0 } else { 0.0 };
        Vector3::new(at.x, y * (at.y - inboard), at.z)
    });
    let mut agreement = Agreement::default();
    for row in results(&folder.join("adams_dw_tr_front_results.csv")) {
        let by = [row["wheel_travel"], -row["rack"]];
        let moving = suspension.design().moved(by).in_bump();
        let centre = half_turn(values(&moving.centre()));
        let off = (centre - vector(&row, &format!("{side}_wc_?"))).amax();
        agreement.note("wheel centre", 1e-6, off);
        let axis = values(&moving.spin_axis());
        let angles = [("toe", toe(&axis)), ("camber", camber_to_ground(&axis))];
        for (name, angle) in angles {
            let published = row[&format!("{side}_{name}_deg")];
            agreement.note(name, 2e-6, angle.to_degrees() - published);
        }
    }
    agreement.holds(&format!("Adams/Car, {side}"), 27);
}

#[test]
fn the_left_wheel_agrees_with_adams_car() {
    compare("left", 1.0);
}

#[test]
fn the_right_wheel_agrees_with_adams_car() {
    compare("right", -1.0);
}
