//! A five-link rear axle of an industrial design study: 20 strokes of the wheel, five significant digits.
//!
//! Its caster, trail and scrub fit no axis of rigid links and are not compared.

use nalgebra::Vector3;
use suspension_core::wheel::{camber_to_ground, toe};

use crate::agreement::Agreement;
use crate::published::{folder, geometry, number, point, results};
use crate::suspension::{FIVE_LINK, Suspension, half_turn};

/// Outboard, on the left, by toe and camber to the ground in degrees.
fn spin_axis(toe: f64, camber: f64) -> Vector3<f64> {
    let [toe, camber] = [toe, camber].map(f64::to_radians);
    let level = camber.cos();
    Vector3::new(level * toe.sin(), level * toe.cos(), -camber.sin())
}

#[test]
fn the_five_link_rear_axle_agrees_with_the_industrial_study() {
    let Some(folder) =
        folder("industrial::the_five_link_rear_axle_agrees_with_the_industrial_study")
    else {
        return;
    };
    let table = geometry(&folder.join("five_link_rear_industrial.toml"));
    let angle = |name: &str| number(&table[name]);
    let axis = spin_axis(angle("design_toe_deg"), angle("design_camber_deg"));
    let suspension = Suspension::new(FIVE_LINK, |name| {
        let centre = || half_turn(point(&table["points"]["wheel_center"]));
        let end = |name: &str, end: usize| {
            // Its toe link has the place of a track rod.
            let link = if name == "trackrod" { "toe" } else { name };
            half_turn(point(&table["links"][link][end]))
        };
        match name.strip_suffix("_inboard") {
            Some("axle") => centre() - axis * 100.0,
            Some(link) => end(link, 0),
            None if name == "axle_outboard" => centre(),
            None => end(name, 1),
        }
    });
    let radius = number(&table["tyre_static_radius_mm"]);
    let mut agreement = Agreement::default();
    for row in results(&folder.join("five_link_rear_industrial_results.csv")) {
        let moving = suspension.design().moved([row["wc_stroke"], 0.0]).in_bump();
        let axis = moving.spin_axis();
        let contact = moving.contact(radius);
        let (toe, camber) = (toe(&axis).value, camber_to_ground(&axis).value);
        agreement.note("toe", 0.004, toe.to_degrees() - row["toe_deg"]);
        agreement.note("camber", 0.0005, camber.to_degrees() - row["camber_deg"]);
        agreement.note("contact x", 0.15, contact.x.value + row["contact_x"]);
        agreement.note("contact y", 0.15, contact.y.value + row["contact_y"]);
    }
    agreement.holds("industrial five-link", 80);
}
