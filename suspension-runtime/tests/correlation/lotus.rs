//! Two reports of Lotus Suspension Analysis (SHARK): static outputs of double wishbones, two decimals.

use suspension_core::wheel::{Heading, SteeringAxis, caster, kingpin_angle};

use crate::agreement::Agreement;
use crate::published::{folder, geometry, number, point};
use crate::suspension::{DOUBLE_WISHBONE, Suspension, half_turn, values};

/// Half a unit of the last digit.
const PRINTED: f64 = 0.005;

/// The file's names.
fn published(name: &str) -> &str {
    match name {
        "lower_inboard_front" => "lower_front",
        "lower_inboard_rear" => "lower_rear",
        "upper_inboard_front" => "upper_front",
        "upper_inboard_rear" => "upper_rear",
        "lower_outboard" => "lower_outer",
        "upper_outboard" => "upper_outer",
        "trackrod_inboard" => "trackrod_inner",
        "trackrod_outboard" => "trackrod_outer",
        "axle_inboard" => "spindle_point",
        _ => "wheel_center",
    }
}

/// Compares a report.
fn compare(report: &str) {
    let Some(folder) = folder(report) else {
        return;
    };
    let table = geometry(&folder.join("lotus_shark_double_wishbones.toml"));
    let table = &table[report];
    let suspension = Suspension::new(DOUBLE_WISHBONE, |name| {
        half_turn(point(&table[published(name)]))
    });
    let design = suspension.design();
    let moving = design.in_bump();
    let (spin, centre) = (values(&moving.spin_axis()), values(&moving.centre()));
    let contact = values(&moving.contact(number(&table["tyre_radius_mm"])));
    let heading = Heading::of(&spin);
    let ends = ["lower_outboard", "upper_outboard"].map(|name| values(&moving.point(name)));
    let axis = SteeringAxis::through(ends);
    let caster = caster(&axis.direction);
    let trail = axis.ahead_of(&contact, &heading);
    let upright = ["lower_outboard", "upper_outboard", "trackrod_outboard"];
    let roll_centre = moving.carrier(upright).roll_centre(&contact) - contact.z;
    let mut agreement = Agreement::default();
    for (name, gate, ours) in [
        ("caster_deg", PRINTED, caster.to_degrees()),
        // Positive where the axis passes behind the wheel centre.
        (
            "caster_trail_hub_mm",
            PRINTED,
            -axis.ahead_of(&centre, &heading),
        ),
        ("caster_offset_ground_mm", PRINTED, trail),
        (
            "kingpin_deg",
            PRINTED,
            kingpin_angle(&axis.direction, &spin).to_degrees(),
        ),
        (
            "kingpin_offset_wheel_mm",
            PRINTED,
            axis.inboard_of(&centre, &heading),
        ),
        (
            "kingpin_offset_ground_mm",
            PRINTED,
            axis.inboard_of(&contact, &heading),
        ),
        // Perpendicular to the axis in the side view.
        ("mechanical_trail_mm", PRINTED, trail * caster.cos()),
        ("roll_centre_height_mm", 0.1, roll_centre),
    ] {
        agreement.note(name, gate, ours - number(&table["results"][name]));
    }
    agreement.holds(report, 8);
}

#[test]
fn shark_4x4_agrees_with_lotus() {
    compare("shark_4x4V23");
}

#[test]
fn shark_bat_agrees_with_lotus() {
    compare("shark_bat");
}
