//! The Formula Student double wishbone.

use nalgebra::Vector3;
use suspension_core::wheel::{camber, toe};

use crate::agreement::Agreement;
use crate::published::{folder, geometry, number, point};
use crate::simscape::{Axis, TRAVEL, printed};
use crate::suspension::{DOUBLE_WISHBONE, Position, Suspension, values};

const UPRIGHT: [&str; 3] = ["lower_outboard", "upper_outboard", "trackrod_outboard"];
/// Of the rack at lock, m.
const LOCK: f64 = 0.0185;

/// Differences between both ends of travel, per metre: degrees of toe and camber, the wheel centre.
fn in_travel(design: &Position<'_>) -> ([f64; 2], Vector3<f64>) {
    let [up, down] = [TRAVEL, -TRAVEL].map(|bump| {
        let moving = design.moved([bump, 0.0]).in_bump();
        let axis = values(&moving.spin_axis());
        let angles = [toe(&axis), camber(&axis)].map(f64::to_degrees);
        (angles, values(&moving.centre()))
    });
    let rate = |k: usize| (up.0[k] - down.0[k]) / (2.0 * TRAVEL);
    ([rate(0), rate(1)], (up.1 - down.1) / (2.0 * TRAVEL))
}

#[test]
fn the_formula_student_front_axle_agrees_with_simscape() {
    let Some(folder) = folder("simscape::the_formula_student_front_axle_agrees_with_simscape")
    else {
        return;
    };
    let table = geometry(&folder.join("simscape_fs_pullrod_front.toml"));
    let points = &table["points_m"];
    let suspension = Suspension::new(DOUBLE_WISHBONE, |name| match name {
        // The wheel stands upright and straight ahead.
        "axle_inboard" => point(&points["wheel_center"]) - Vector3::y() * 0.1,
        "axle_outboard" => point(&points["wheel_center"]),
        _ => point(&points[name]),
    });
    let design = suspension.design();
    let axis = Axis::at(&design, UPRIGHT, 0.0);
    let ([bump_steer, bump_camber], recession) = in_travel(&design);
    let at_rack =
        |rack| toe(&values(&design.moved([0.0, rack]).in_bump().spin_axis())).to_degrees();
    let mut agreement = Agreement::default();
    for (name, ours) in [
        ("caster_deg", axis.caster.to_degrees()),
        ("kpi_deg", axis.kingpin.to_degrees()),
        ("camber_per_toe", axis.camber_per_toe),
        ("bump_steer_deg_per_m", bump_steer),
        ("bump_camber_deg_per_m", bump_camber),
        ("recession_long", recession.x),
        ("recession_lat", recession.y),
        ("toe_at_rack_plus_18_5mm_deg", at_rack(LOCK)),
        ("toe_at_rack_minus_18_5mm_deg", at_rack(-LOCK)),
    ] {
        let published = number(&table["metrics"][name]["value"]);
        // At full left lock the last digit is off by one: the number is the extreme of a run in time.
        let halves = if name.contains("plus") { 2.0 } else { 1.0 };
        let gate = halves * printed(published, 5);
        agreement.note(name, gate, ours - published);
    }
    agreement.holds("Simscape, Formula Student", 9);
}
