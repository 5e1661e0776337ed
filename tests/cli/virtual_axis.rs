//! The virtual steering axis of a strut on two lower links, as the screw axis of its constraints: without the solver's
//! equations.

use std::collections::BTreeMap;

use nalgebra::{Matrix6, RowVector6, Vector3, Vector6};
use suspension_core::linkages::LISTINGS;
use suspension_runtime::Listing;

use super::program::table;

const LAYOUT: &str = "macpherson_two_links";
/// From 40 mm of rebound to 40 mm of bump, the rack from lock to lock.
const MOTION: &str = "
linkage = \"macpherson_two_links\"
unit = \"m\"
vehicle = { wheel_radius = 0.315 }
time = { start = 0.0, stop = 1.0, step = 0.125 }
drives = { bump = [0.275, 0.08], steer = [0.27, 0.12] }
";

type Row = BTreeMap<String, f64>;

fn at(row: &Row, point: &str) -> Vector3<f64> {
    let coordinate = |axis| row[&format!("{point}_{axis}")];
    Vector3::new(coordinate("x"), coordinate("y"), coordinate("z"))
}

/// The velocity at the origin and the angular velocity of the knuckle per movement of the rack, the wheel's height held.
fn twist(row: &Row) -> [Vector3<f64>; 2] {
    let (_, text) = LISTINGS
        .iter()
        .find(|(name, _)| *name == LAYOUT)
        .expect("a layout");
    let listing = Listing::parse(text).expect("a listing");
    let design = listing.design().expect("all points are stated");
    let chassis = |name| design[listing.point(name).expect("a point")];
    let mut conditions = Vec::new();
    let mut moves = |point: Vector3<f64>, along: Vector3<f64>, pace: f64| {
        let arm = point.cross(&along);
        let row = RowVector6::new(along.x, along.y, along.z, arm.x, arm.y, arm.z);
        conditions.push((row, pace));
    };
    for (inner, outer) in [
        ("lateral_inner", "lateral_ball"),
        ("tension_inner", "tension_ball"),
    ] {
        let outer = at(row, outer);
        moves(outer, outer - chassis(inner), 0.0);
    }
    let tie = at(row, "tie_ball");
    let rack = Vector3::new(chassis("rack").x, row["steer_m"], chassis("rack").z);
    moves(tie, tie - rack, tie.y - rack.y);
    let line = at(row, "strut_high") - at(row, "strut_low");
    let across = line.cross(&Vector3::x());
    moves(chassis("top"), across, 0.0);
    moves(chassis("top"), line.cross(&across), 0.0);
    moves(at(row, "wheel_centre"), Vector3::z(), 0.0);
    let rows: Vec<_> = conditions.iter().map(|(row, _)| *row).collect();
    let paces = Vector6::from_iterator(conditions.iter().map(|(_, pace)| *pace));
    let found = Matrix6::from_rows(&rows)
        .lu()
        .solve(&paces)
        .expect("regular");
    [0, 3].map(|first| found.fixed_rows::<3>(first).into_owned())
}

#[test]
fn the_virtual_axis_of_a_strut_on_two_links_is_the_screw_axis_of_its_constraints() {
    let rows = table(MOTION, &["motion"]);
    assert_eq!(rows.len(), 9);
    for row in &rows {
        let [velocity, omega] = twist(row);
        let up = omega * omega.z.signum();
        let axis = omega.cross(&velocity) / omega.norm_squared();
        let contact = at(row, "contact");
        let from_contact = axis - up * (axis.z - contact.z) / up.z - contact;
        let spin = at(row, "wheel_centre") - at(row, "axle");
        let outboard = Vector3::new(spin.x, spin.y, 0.0).normalize();
        let forward = Vector3::new(outboard.y, -outboard.x, 0.0);
        for (name, expected) in [
            ("virtual_kingpin_rad", (-up.y).atan2(up.z)),
            ("virtual_caster_rad", (-up.x).atan2(up.z)),
            ("virtual_scrub_radius_m", -from_contact.dot(&outboard)),
            ("virtual_trail_m", from_contact.dot(&forward)),
            (
                "virtual_pitch_m_rad",
                omega.dot(&velocity) / omega.norm_squared(),
            ),
        ] {
            let off = row[name] - expected;
            assert!(off.abs() < 1e-11, "{name}: {}, off by {off:e}", row[name]);
        }
    }
}
