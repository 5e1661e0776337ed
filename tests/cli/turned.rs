//! A rocker driven by its angle in place of the wheel's height.

use std::path::Path;

use super::program::{folder, run, table_in, text};

const LISTING: &str =
    include_str!("../../suspension-core/src/linkages/double_wishbone_rocker.linkage");
const TURN: &str = "angle(rocker_rear -> damper_inner, rocker_rear -> pushrod_upper about rocker_rear -> rocker_front)";
const BUMP: &str = "bump:  wheel_centre.z";

const MOTION: &str = "
unit = \"m\"
vehicle = { wheel_radius = 0.3 }
time = { start = 0.0, stop = 1.0, step = 0.05 }
";

const LOAD: &str = "
[loads.bump]
wheel_centre = [100.0, -400.0, 3000.0]
";

/// Files with the listing of which the height or the angle is driven, and the other measured.
fn written(drives: &str) -> tempfile::TempDir {
    let folder = folder();
    for (name, is, driven, measured) in [
        ("by_bump", "bump", BUMP, format!("turn: {TURN}")),
        (
            "by_turn",
            "turn",
            &*format!("turn: {TURN}"),
            BUMP.to_owned(),
        ),
    ] {
        let listing = LISTING
            .replace(&format!("drive {BUMP}"), &format!("drive {driven}"))
            .replace(
                "measure damper",
                &format!("measure {measured};\nmeasure damper"),
            );
        assert!(listing.contains(&format!("drive {is}:")), "{listing}");
        write(folder.path(), &format!("{name}.linkage"), &listing);
        let file = format!("listing = \"{name}.linkage\"\n{MOTION}\n[drives]\n{drives}\n{LOAD}");
        write(folder.path(), &format!("{name}.toml"), &file);
    }
    folder
}

fn write(folder: &Path, name: &str, content: &str) {
    std::fs::write(folder.join(name), content).expect("written");
}

/// Returns the angle of the design position, to the last digit.
fn start(folder: &Path) -> f64 {
    table_in(
        folder,
        &["sweep", "by_bump.toml", "--drive", "steer=0:0.01:2"],
    )[0]["turn_rad"]
}

/// Led by the angle in place of the height, and driven by it: the same motion, of two systems of equations.
#[test]
fn a_motion_driven_by_an_angle_equals_the_motion_led_by_the_angle() {
    let folder = written("turn = [-2.3, 0.5, 0.125]\nsteer = [0.34, 0.01]");
    let [led, driven] =
        ["by_bump.toml", "by_turn.toml"].map(|file| table_in(folder.path(), &["motion", file]));
    assert_eq!((led.len(), driven.len()), (21, 21));
    let mut worst = 0.0_f64;
    for (led, driven) in led.iter().zip(&driven) {
        // The virtual steering axis is that of another drive that is held.
        let names = led.keys().filter(|name| !name.starts_with("virtual_"));
        for name in names.filter(|name| driven.contains_key(*name)) {
            let off = (led[name] - driven[name]).abs() / led[name].abs().max(1.0);
            worst = worst.max(off);
        }
    }
    assert!(worst < 1e-12, "{worst:e}");
}

/// By the chain rule, with the other drive held: `x' / t'` and `(x'' - x' t'' / t') / t'^2`.
#[test]
fn derivatives_by_a_driven_angle_satisfy_the_chain_rule() {
    let folder = written("bump = 0.3\nsteer = 0.34");
    let of = |file: &str, drive: &str| {
        let sweep = ["sweep", file, "--derivatives", "2", "--drive", drive];
        table_in(folder.path(), &sweep)
    };
    let by_bump = of("by_bump.toml", "bump=-0.04:0.04:5");
    let design = start(folder.path());
    let file = std::fs::read_to_string(folder.path().join("by_turn.toml")).expect("a file");
    let file = file.replace("bump = 0.3\n", &format!("turn = {design:?}\n"));
    write(folder.path(), "by_turn.toml", &file);
    let mut worst = 0.0_f64;
    for by_bump in by_bump {
        let change = by_bump["turn_rad"] - design;
        let drive = format!("turn={:?}:{:?}:2", change, change + 1e-3);
        let by_turn = &of("by_turn.toml", &drive)[0];
        let [pace, bend] = ["turn_rad_per_bump", "turn_rad_per_bump2"].map(|name| by_bump[name]);
        for quantity in ["camber_rad", "toe_rad", "damper_m", "scrub_radius_m"] {
            let [first, second] =
                ["_per_bump", "_per_bump2"].map(|drive| by_bump[&format!("{quantity}{drive}")]);
            let expected = [first / pace, (second - first * bend / pace) / (pace * pace)];
            let found =
                ["_per_turn", "_per_turn2"].map(|drive| by_turn[&format!("{quantity}{drive}")]);
            for (found, expected) in found.into_iter().zip(expected) {
                worst = worst.max((found - expected).abs() / expected.abs().max(1.0));
            }
        }
    }
    assert!(worst < 1e-11, "{worst:e}");
}

/// The force on the wheel's height is the moment about the axis by virtual work.
#[test]
fn the_moment_on_a_driven_angle_matches_virtual_work() {
    let folder = written("bump = 0.3\nsteer = 0.34");
    let design = start(folder.path());
    let file = std::fs::read_to_string(folder.path().join("by_turn.toml")).expect("a file");
    let file = file.replace("bump = 0.3\n", &format!("turn = {design:?}\n"));
    write(folder.path(), "by_turn.toml", &file);
    let load = |file| table_in(folder.path(), &["loads", file])[0].clone();
    let (by_bump, by_turn) = (load("by_bump.toml"), load("by_turn.toml"));
    let sweep = [
        "sweep",
        "by_bump.toml",
        "--derivatives",
        "1",
        "--drive",
        "bump=0:0.01:2",
    ];
    let pace = table_in(folder.path(), &sweep)[0]["turn_rad_per_bump"];
    let force = by_bump["bump_bump_N"];
    let off = by_turn["bump_turn_Nm"] * pace - force;
    assert!(
        force > 2000.0 && off.abs() < 1e-12 * force,
        "{off:e} of {force}"
    );
}

/// Against designs that are changed by a hundredth of a millimetre.
#[test]
fn sensitivities_of_an_angle_driven_rocker_agree_with_differences() {
    const STEP: f64 = 1e-4;
    // Ends of the axis and of both lines.
    const POINTS: [(&str, [f64; 3]); 4] = [
        ("rocker_front", [0.04, 0.38, 0.52]),
        ("rocker_rear", [-0.04, 0.38, 0.52]),
        ("damper_inner", [0.0, 0.10, 0.58]),
        ("pushrod_upper", [0.0, 0.46, 0.55]),
    ];
    let folder = written("turn = -2.4\nsteer = 0.34");
    let file = std::fs::read_to_string(folder.path().join("by_turn.toml")).expect("a file");
    let output = run(
        folder.path(),
        &["sensitivities", "by_turn.toml", "--csv", "-"],
    );
    let mut reader = csv::Reader::from_reader(&*output.stdout);
    let headers = reader.headers().expect("names").clone();
    let records: Vec<_> = reader.records().filter_map(Result::ok).collect();
    for (point, design) in POINTS {
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let at = |steps: f64| {
                let mut moved = design;
                moved[axis] += steps * STEP;
                let points = format!("\n[points]\n{point} = {moved:?}\n");
                write(folder.path(), "moved.toml", &(file.clone() + &points));
                let sweep = [
                    "sweep",
                    "moved.toml",
                    "--derivatives",
                    "1",
                    "--drive",
                    "turn=0:0.1:2",
                ];
                table_in(folder.path(), &sweep)[0].clone()
            };
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(at);
            let changed = format!("{point}.{name}");
            let mut records = records.iter();
            let record = records.find(|record| record[0] == changed).expect("a row");
            for quantity in ["camber_rad_per_turn", "bump_m_per_turn", "toe_rad_per_turn"] {
                let column = headers
                    .iter()
                    .position(|name| name == quantity)
                    .expect("a column");
                let found: f64 = record[column].parse().expect("a number");
                let [a, b, c, d] = [&a, &b, &c, &d].map(|row| row[quantity]);
                let expected = (8.0 * (c - b) - (d - a)) / (12.0 * STEP);
                let off = (found - expected).abs() / expected.abs().max(1e-2);
                assert!(
                    off < 1e-7,
                    "{quantity} by {changed}: {found} for {expected}"
                );
            }
        }
    }
}

#[test]
fn a_driven_angle_moves_through_its_range_and_no_further() {
    let folder = written("turn = -2.4\nsteer = 0.34");
    let output = run(folder.path(), &["check", "by_turn.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let printed = text(&output.stdout);
    assert!(
        printed.contains("34 of 34: no equation is redundant"),
        "{printed}"
    );
    let output = run(folder.path(), &["range", "by_turn.toml"]);
    let printed = text(&output.stdout);
    for end in ["lower end   -360 deg", "upper end   360 deg"] {
        assert!(printed.contains(end), "{printed}");
    }
    let baked = [
        "bake",
        "by_turn.toml",
        "--drive",
        "turn=-2.8:-2.2",
        "--out",
        "a.rs",
    ];
    let output = run(folder.path(), &baked);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let folder = written("turn = 6.5\nsteer = 0.34");
    let output = run(folder.path(), &["motion", "by_turn.toml"]);
    let messages = text(&output.stderr);
    assert_eq!(
        (output.status.code(), messages.lines().count()),
        (Some(2), 1),
        "{messages}"
    );
    let message = "drive `turn` begins at 6.5 rad; an angle about an axis must be less than a whole turn to either side";
    assert!(messages.contains(message), "{messages}");
}

/// The point from which an angle counts, if its zero is the design; a point that is used otherwise does not coincide with
/// another.
#[test]
fn a_direction_may_end_at_the_position_of_its_point() {
    let listing = "fixed: low at [0.0, 0.0, 0.0], high at [0.0, 0.0, 1.0], zero at [1.0, 0.0, 0.0];\n\
                   free: tip at [1.0, 0.0, 0.0];\n\
                   hinge arm: low, high -> tip;\n\
                   drive turn: angle(low -> zero, low -> tip about low -> high);\n";
    let motion = "unit = \"m\"\n[time]\ninstants = [0.0]\n[drives]\nturn = 0.5\n";
    let folder = folder();
    write(folder.path(), "arm.linkage", listing);
    let inline = format!("statements = '''\n{listing}'''\n{motion}");
    for file in [&format!("listing = \"arm.linkage\"\n{motion}"), &inline] {
        write(folder.path(), "a.toml", file);
        let row = table_in(folder.path(), &["motion", "a.toml"]).remove(0);
        assert!((row["tip_y"] - 0.5_f64.sin()).abs() < 1e-15, "{row:?}");
    }
    write(
        folder.path(),
        "a.toml",
        &inline.replace("high at [0.0, 0.0, 1.0]", "high at [1.0, 0.0, 0.0]"),
    );
    let refused = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(
        text(&refused.stderr),
        "a.toml:3:7: point `tip` is in the same place as point `high`; correct one of them, or, if they are one joint, state one \
         point and name it in the statements of both\n"
    );
}
