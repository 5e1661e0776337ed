//! Quantities of both wheels of an axle, and of the axle.

use std::collections::BTreeMap;

use super::program::{Rows, folder, rows, run, text};

const TRACK: f64 = 1.5;
const WHEELBASE: f64 = 2.6;

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

/// The rows of a command on a file.
fn table(file: &str, arguments: &[&str]) -> Rows {
    let folder = folder();
    std::fs::write(folder.path().join("axle.toml"), file).expect("written");
    let arguments: Vec<&str> = [arguments[0], "axle.toml", "--csv", "-"]
        .iter()
        .chain(&arguments[1..])
        .copied()
        .collect();
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    rows(&output.stdout)
}

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
fn a_symmetric_axle_has_in_a_mirror_what_it_has() {
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
fn each_wheel_is_that_of_the_corner_alone() {
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

/// Steer angles of the outer and the inner wheel.
fn turned(row: &BTreeMap<String, f64>) -> [f64; 2] {
    let [left, right] = [-row["left_toe_rad"], row["right_toe_rad"]];
    assert_near(row["left_steer_angle_rad"], left, 0.0, "left");
    assert_near(row["right_steer_angle_rad"], right, 0.0, "right");
    if left + right < 0.0 {
        [-left, -right]
    } else {
        [right, left]
    }
}

#[test]
fn ackermann_and_the_turning_circle_are_those_of_the_cotangents() {
    let table = table(&steered(DESIGN), &["sweep", "--drive=steer=-0.03:0.03:13"]);
    for (place, row) in table.iter().enumerate() {
        let [outer, inner] = turned(row);
        let track = row["left_contact_y"] - row["right_contact_y"];
        assert_near(row["track_m"], track, 1e-15, "track");
        let toe = row["left_toe_rad"] + row["right_toe_rad"];
        assert_near(row["total_toe_rad"], toe, 0.0, "total toe");
        if place == 6 {
            assert!(row["ackermann_percent"].is_nan() && row["turning_radius_m"].is_nan());
            assert_near(track, TRACK, 1e-12, "track of the design");
            continue;
        }
        let ideal = (1.0 / (1.0 / outer.tan() - track / WHEELBASE)).atan();
        let percent = 100.0 * (inner - outer) / (ideal - outer);
        assert_near(row["ackermann_percent"], percent, 1e-8, "percentage");
        assert_near(
            row["ackermann_error_rad"],
            inner - ideal,
            1e-12,
            "Ackermann error",
        );
        // The circle through the outer contact point about where its normal meets the line of the rear axle.
        let across = WHEELBASE / outer.tan();
        let radius = across.hypot(WHEELBASE);
        assert_near(row["turning_radius_m"], radius, 1e-10 * radius, "radius");
    }
}

/// The drives' rates at which the left contact point rises by one and the right one falls by one.
fn in_roll(row: &BTreeMap<String, f64>) -> [f64; 2] {
    let rise = |wheel: &str, drive: &str| row[&format!("{wheel}_contact_z_per_bump_{drive}")];
    let [a, b] = ["left", "right"].map(|drive| rise("left", drive));
    let [c, d] = ["left", "right"].map(|drive| rise("right", drive));
    let determinant = a * d - b * c;
    [(d + b) / determinant, -(a + c) / determinant]
}

/// A tenth of a millimetre of roll either way.
#[test]
fn roll_camber_and_roll_steer_are_those_of_two_states_of_small_roll() {
    for (left, right, steer) in [(0.3, 0.3, 0.34), (0.33, 0.29, 0.345), (0.27, 0.31, 0.325)] {
        let held = format!("bump_left = {left}\nbump_right = {right}\nsteer = {steer}");
        let [dl, dr, ds] = [left - 0.3, right - 0.3, steer - 0.34];
        let arguments = [
            format!("--drive=bump_left={dl}"),
            format!("--drive=bump_right={dr}"),
            format!("--drive=steer={ds}"),
        ];
        let [a, b, c] = arguments.each_ref().map(String::as_str);
        let here = table(&steered(&held), &["sweep", a, b, c]).remove(0);
        let [p, q] = in_roll(&here);
        let rolling =
            format!("bump_left = [{left}, {p:?}]\nbump_right = [{right}, {q:?}]\nsteer = {steer}");
        let states = table(&steered(&rolling), &["motion"]);
        let [before, now, after] = states.as_slice() else {
            panic!("three instants");
        };
        let roll = |row: &BTreeMap<String, f64>| {
            let line = ["y", "z"].map(|axis| {
                row[&format!("left_contact_{axis}")] - row[&format!("right_contact_{axis}")]
            });
            line[1].atan2(line[0])
        };
        for wheel in ["left", "right"] {
            for (roll_name, name) in [("roll_camber", "camber"), ("roll_steer", "steer_angle")] {
                let of = format!("{wheel}_{name}_rad");
                let slope = (after[&of] - before[&of]) / (roll(after) - roll(before));
                let found = now[&format!("{wheel}_{roll_name}_rad_rad")];
                let tolerance = 1e-6 * slope.abs();
                assert_near(found, slope, tolerance, &format!("{wheel} {roll_name}"));
                assert!(slope.abs() > 1e-3, "{slope}");
            }
        }
    }
}

/// First and second derivatives by each drive, at a place of no symmetry.
fn check_derivatives(names: &[&str], step: f64) {
    let centre = [("bump_left", 0.02), ("bump_right", -0.01), ("steer", 0.028)];
    for moved in ["bump_left", "bump_right", "steer"] {
        let drives = centre.map(|(drive, at)| {
            if drive == moved {
                format!("--drive={drive}={}:{}:3", at - step, at + step)
            } else {
                format!("--drive={drive}={at}")
            }
        });
        let [a, b, c] = drives.each_ref().map(String::as_str);
        let rows = table(&steered(DESIGN), &["sweep", "--derivatives", "2", a, b, c]);
        let [before, here, after] = rows.as_slice() else {
            panic!("three places");
        };
        for name in names {
            let (none, first) = ((*name).to_owned(), format!("{name}_per_{moved}"));
            let second = format!("{first}2");
            for (of, derivative) in [(&none, &first), (&first, &second)] {
                let slope = (after[of] - before[of]) / (2.0 * step);
                let size = slope.abs().max(here[of].abs()).max(1.0);
                assert_near(here[derivative], slope, 2e-6 * size, derivative);
            }
        }
    }
}

#[test]
fn derivatives_of_what_an_axle_has_are_those_of_differences() {
    let smooth = [
        "total_toe_rad",
        "track_m",
        "left_steer_angle_rad",
        "right_steer_angle_rad",
        "ackermann_error_rad",
        "left_roll_camber_rad_rad",
        "right_roll_camber_rad_rad",
        "left_roll_steer_rad_rad",
        "right_roll_steer_rad_rad",
    ];
    check_derivatives(&smooth, 2e-5);
    // These have poles near by: where the axle is straight ahead, where both normals are parallel.
    let bent = [
        "ackermann_percent",
        "turning_radius_m",
        "axle_roll_centre_y",
        "axle_roll_centre_z",
    ];
    check_derivatives(&bent, 2e-6);
}

/// The axle turns about a line in the plane of symmetry: through where the lower links' lines meet, and where those of
/// the upper ones do.
#[test]
fn a_live_axle_rolls_and_steers_about_its_roll_axis() {
    let drives = "bump_left = 0.31\nbump_right = 0.31";
    let axle = file("live_axle_splayed", "", drives);
    let row = table(&axle, &["motion"]).remove(1);
    let met = |front: [f64; 3], rear: [f64; 3]| {
        let part = front[1] / (front[1] - rear[1]);
        [0, 2].map(|axis: usize| front[axis] + part * (rear[axis] - front[axis]))
    };
    let lower = met([0.56, 0.46, 0.29], [0.02, 0.50, 0.24]);
    let upper = met([0.34, 0.42, 0.44], [0.02, 0.12, 0.43]);
    let slope = (upper[1] - lower[1]) / (upper[0] - lower[0]);
    let height = lower[1] - slope * lower[0];
    assert_near(row["axle_roll_centre_y"], 0.0, 1e-12, "roll centre");
    assert_near(row["axle_roll_centre_z"], height, 1e-10, "roll centre");
    for wheel in ["left", "right"] {
        let steer = row[&format!("{wheel}_roll_steer_rad_rad")];
        assert_near(steer, slope, 1e-10, "roll steer");
    }
    // The wheels lean with the axle: the top of the left one inboard as it rises.
    assert_near(row["left_roll_camber_rad_rad"], -1.0, 1e-10, "roll camber");
    assert_near(row["right_roll_camber_rad_rad"], 1.0, 1e-10, "roll camber");
}

/// The height of the roll centre of an axle that is symmetric, by one of its wheels.
#[test]
fn a_symmetric_axle_has_the_roll_centre_of_each_wheel() {
    let row = table(&steered(DESIGN), &["motion"]).remove(1);
    let ground = row["left_contact_z"];
    for wheel in ["left", "right"] {
        let of_wheel = row[&format!("{wheel}_roll_centre_m")] + ground;
        assert_near(row["axle_roll_centre_z"], of_wheel, 1e-12, wheel);
    }
}

#[test]
fn drives_of_wheels_are_named_in_a_table() {
    let named = "travel = { left = \"bump_left\", right = \"bump_right\" }\nsteer = \"steer\"";
    let [named, unnamed] = [named, ""].map(|vehicle| {
        let file = file("steered_axle", vehicle, DESIGN);
        table(&file, &["motion"])
    });
    assert_eq!(format!("{named:?}"), format!("{unnamed:?}"));
}

#[test]
fn a_drive_of_no_wheel_is_refused() {
    for (linkage, vehicle, drives, expected) in [
        (
            "steered_axle",
            "travel = { left = \"bump_left\", rihgt = \"bump_right\" }",
            DESIGN,
            "axle.toml:5:10: unknown wheel `rihgt`; known are left, right",
        ),
        (
            "steered_axle",
            "travel = { left = \"bump\" }",
            DESIGN,
            "axle.toml:5:19: unknown drive `bump`; known are steer, bump_left, bump_right",
        ),
        (
            "steered_axle",
            "steer = 3",
            DESIGN,
            "axle.toml:5:9: invalid type: integer `3`, expected \"drive\" or { wheel = \"drive\" }",
        ),
        (
            "double_wishbone",
            "travel = { left = \"bump\" }",
            "bump = 0.3\nsteer = 0.34",
            "axle.toml:5:10: unknown wheel `left`; the listing names no wheels: write the drive alone, as \"NAME\"",
        ),
    ] {
        let folder = folder();
        let file = file(linkage, vehicle, drives);
        std::fs::write(folder.path().join("axle.toml"), file).expect("written");
        let output = run(folder.path(), &["motion", "axle.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert!(message.contains(expected), "{message}");
    }
}

/// A page and a comparison have the wheels by name, each definition once.
#[test]
fn sheets_and_comparisons_have_both_wheels() {
    let folder = folder();
    let write = |name: &str, file: String| {
        std::fs::write(folder.path().join(name), file).expect("written");
    };
    write("axle.toml", steered(DESIGN));
    let corner = file("double_wishbone", "", "bump = 0.3\nsteer = 0.34");
    write("corner.toml", corner);
    let sheet = ["sheet", "axle.toml", "--out", "axle.html"];
    assert_eq!(run(folder.path(), &sheet).status.code(), Some(0));
    let page = std::fs::read_to_string(folder.path().join("axle.html")).expect("a page");
    assert_eq!(
        page.matches("<td rowspan=\"2\">camber angle</td>").count(),
        1
    );
    assert_eq!(page.matches("ISO 8855; Attia 2003, angle beta").count(), 1);
    for heading in ["Over bump_left", "Over bump_right", "Over steer"] {
        assert_eq!(page.matches(heading).count(), 1, "{heading}");
    }
    let output = run(folder.path(), &["compare", "axle.toml", "axle.toml"]);
    let compared = text(&output.stdout);
    for part in [
        "left toe angle",
        "right toe angle",
        "per travel 2",
        "total toe",
    ] {
        assert!(compared.contains(part), "{part}");
    }
    let output = run(folder.path(), &["compare", "axle.toml", "corner.toml"]);
    let compared = text(&output.stdout);
    for line in ["  left camber angle", "  right camber angle"] {
        let line = compared.lines().find(|found| found.starts_with(line));
        let cells: Vec<&str> = line.expect("compared").split_whitespace().collect();
        assert_eq!(cells[3..], ["0", "0", "0", "deg"]);
    }
}
