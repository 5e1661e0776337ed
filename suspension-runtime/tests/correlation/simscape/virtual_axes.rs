//! Linkages whose steering axis is not the line through two ball joints. The published runs had other track rods than
//! the published geometry, so that nothing is compared that depends on those.

use nalgebra::Vector3;

use crate::agreement::Agreement;
use crate::published::{folder, geometry, number, point};
use crate::simscape::{Axis, bump_caster, printed};
use crate::suspension::{DOUBLE_WISHBONE, FIVE_LINK, Suspension};

/// Two lower links and an upper wishbone.
const SPLIT_LOWER_ARM: &str = "
    fixed: lower_front_inboard, lower_rear_inboard, upper_inboard_front, upper_inboard_rear, trackrod_inboard;
    free:  lower_front, lower_rear, upper_outboard, trackrod_outboard, axle_outboard;

    link one:      lower_front_inboard -> lower_front;
    link two:      lower_rear_inboard  -> lower_rear;
    link three:    upper_inboard_front -> upper_outboard;
    link four:     upper_inboard_rear  -> upper_outboard;
    link trackrod: trackrod_inboard    -> trackrod_outboard;
    body upright:  lower_front, lower_rear, upper_outboard, trackrod_outboard, axle_outboard;
    point axle_inboard: upright;

    drive bump:  axle_outboard.z;
    drive steer: trackrod_inboard.y;";

/// A point by the file's names: a link has both its ends in one entry.
fn published(table: &toml::Value, name: &str) -> Vector3<f64> {
    let centre = || point(&table["wheel_center"]);
    let (part, end) = match name.strip_suffix("_inboard") {
        Some(part) => (part, 0),
        None => (name, 1),
    };
    match part {
        // The wheel stands upright and straight ahead.
        "axle" => centre() - Vector3::y() * 0.1,
        "axle_outboard" => centre(),
        "trackrod" | "trackrod_outboard" => point(&table["trackrod_2022"][end]),
        "lower_front" | "lower_rear" | "upper_front" | "upper_rear" => point(&table[part][end]),
        _ => point(&table[name]),
    }
}

/// Compares what there is of a linkage; its carrier by three points.
fn compare(linkage: &str, statements: &str, body: [&str; 3], numbers: usize) {
    let Some(folder) = folder(linkage) else {
        return;
    };
    let table = geometry(&folder.join("simscape_five_link_and_sedan.toml"));
    let table = &table[linkage];
    let suspension = Suspension::new(statements, |name| published(table, name));
    let design = suspension.design();
    let axis = Axis::at(&design, body, 0.0);
    let mut agreement = Agreement::default();
    for (name, digits, ours) in [
        ("caster_deg", 4, axis.caster.to_degrees()),
        ("kpi_deg", 4, axis.kingpin.to_degrees()),
        ("camber_per_toe", 5, axis.camber_per_toe),
        ("bump_caster_deg_per_m", 5, bump_caster(&design, body)),
    ] {
        if let Some(metric) = table["metrics"].get(name) {
            let published = number(&metric["value"]);
            agreement.note(name, printed(published, digits), ours - published);
        }
    }
    agreement.holds(linkage, numbers);
}

#[test]
fn the_sedan_five_link_agrees_with_simscape() {
    let body = ["lower_front", "upper_front", "trackrod"];
    compare("sedan_five_link", FIVE_LINK, body, 4);
}

#[test]
fn the_formula_student_five_link_agrees_with_simscape() {
    let body = ["lower_front", "upper_front", "trackrod"];
    compare("formula_student_five_link", FIVE_LINK, body, 3);
}

#[test]
fn the_sedan_split_lower_arm_agrees_with_simscape() {
    let body = ["lower_front", "upper_outboard", "trackrod_outboard"];
    compare("sedan_split_lower_arm", SPLIT_LOWER_ARM, body, 3);
}

#[test]
fn the_sedan_double_wishbone_agrees_with_simscape() {
    let body = ["lower_outboard", "upper_outboard", "trackrod_outboard"];
    compare("sedan_double_wishbone", DOUBLE_WISHBONE, body, 4);
}
