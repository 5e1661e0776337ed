//! Quantities of both wheels of an axle, and of the axle.

mod car;
mod coupled;
mod derivatives;
mod files;
mod rigid_bodies;
mod roll;
mod steering;
mod steering_box;
mod steering_wheel;

use std::collections::BTreeMap;

use super::program::{folder, run, table, table_in, text};

type Row = BTreeMap<String, f64>;

fn file(linkage: &str, vehicle: &str, drives: &str) -> String {
    format!(
        "linkage = \"{linkage}\"\nunit = \"m\"\n[vehicle]\nwheel_radius = 0.3\n{vehicle}\n\
         [time]\ninstants = [-1e-4, 0.0, 1e-4]\n[drives]\n{drives}\n"
    )
}

fn steered(drives: &str) -> String {
    file("steered_axle", "wheelbase = 2.6", drives)
}

const DESIGN: &str = "bump_left = 0.3\nbump_right = 0.3\nsteer = 0.34";

fn assert_near(found: f64, expected: f64, tolerance: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(
        off <= tolerance || (found.is_nan() && expected.is_nan()),
        "{what}: {found}, not {expected}"
    );
}

/// The name that a column has in a mirror, and the sign that its number then has.
fn mirrored(name: &str) -> (String, f64) {
    let exchanged = name.split('_').map(|word| match word {
        "left" => "right",
        "right" => "left",
        word => word,
    });
    let of = name.split("_per_").next().expect("a name");
    let turns = ["steer_angle", "roll_camber", "virtual_pitch", "roll_travel"];
    let signs = [
        of.ends_with("_y"),
        turns.iter().any(|turn| of.contains(turn)),
        name.ends_with("_per_steer"),
    ];
    let sign = signs.iter().filter(|changes| **changes).count();
    let name = exchanged.collect::<Vec<_>>().join("_");
    (name, if sign % 2 == 0 { 1.0 } else { -1.0 })
}

#[test]
fn quantities_of_a_symmetric_axle_mirror_with_its_drives() {
    const PLACES: usize = 3;
    let table = table(
        &steered(DESIGN),
        &[
            "sweep",
            "--drive=bump_left=-0.04:0.04:3",
            "--drive=bump_right=-0.04:0.04:3",
            "--drive=steer=-0.02:0.02:3",
        ],
    );
    assert_eq!(table.len(), PLACES.pow(3));
    let mut compared = 0;
    for (index, row) in table.iter().enumerate() {
        let (left, right, steer) = (index / 9, index / 3 % 3, index % 3);
        let image = &table[right * 9 + left * 3 + (PLACES - 1 - steer)];
        for (name, value) in row {
            let (other, sign) = mirrored(name);
            let is_drive = ["bump_left_m", "bump_right_m", "steer_m"].contains(&name.as_str());
            if is_drive || name.starts_with("residual") {
                continue;
            }
            let size = value.abs().max(1.0);
            assert_near(sign * image[&other], *value, 1e-9 * size * size, name);
            compared += 1;
        }
    }
    assert!(compared > 27 * 200, "{compared}");
}

#[test]
fn each_wheel_of_an_axle_equals_that_of_the_corner_alone() {
    let grid = ["--drive=steer=-0.02:0.02:3"];
    let both = table(
        &steered(DESIGN),
        &["sweep", "--drive=bump_left=-0.06:0.06:7", grid[0]],
    );
    let corner = file("double_wishbone", "", "bump = 0.3\nsteer = 0.34");
    let alone = table(&corner, &["sweep", "--drive=bump=-0.06:0.06:7", grid[0]]);
    let mut compared = 0;
    for (one, both) in alone.iter().zip(&both) {
        for (name, value) in one {
            let of_axle = format!("left_{}", name.replace("_per_bump", "_per_bump_left"));
            let Some(found) = both.get(&of_axle) else {
                continue;
            };
            let tolerance = 1e-9 * value.abs().max(1.0).powi(2);
            assert_near(*found, *value, tolerance, name);
            compared += 1;
        }
    }
    assert!(compared > 21 * 90, "{compared}");
}
