//! Grids of drives.

mod places;

use super::program::{CORNER, folder, rows, run, text};

#[test]
fn sweep_writes_a_row_per_place_with_correct_derivatives() {
    let folder = folder();
    // Arms that are not parallel in the side view: the instant centre there is not far away.
    let file = format!("{CORNER}[points]\nupper_rear = [-0.15, 0.42, 0.36]\n");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let (bump, steer) = ("bump=-0.001:0.001:5", "steer=0.009:0.011:5");
    let arguments = [
        "sweep",
        "a.toml",
        "--drive",
        bump,
        "--drive",
        steer,
        "--derivatives",
        "2",
        "--csv",
        "-",
    ];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let table = rows(&output.stdout);
    assert_eq!(table.len(), 25);
    assert!((table[12]["bump_m"] - 0.3).abs() < 1e-15);
    assert!((table[12]["steer_m"] - 0.35).abs() < 1e-15);
    assert!(
        (table[13]["steer_m"] - 0.3505).abs() < 1e-15,
        "the last drive changes fastest"
    );
    let middle = &table[12];
    let firsts = middle.keys().filter(|name| name.ends_with("_per_bump"));
    let mut checked = 0;
    for name in firsts {
        let quantity = name.strip_suffix("_per_bump").expect("a suffix");
        for (drive, stride) in [("bump", 5), ("steer", 1)] {
            let [a, b, c, d, e] =
                [-2, -1, 0, 1, 2].map(|k: isize| table[(12 + k * stride) as usize][quantity]);
            let h = 0.0005;
            let first = (8.0 * (d - b) - (e - a)) / (12.0 * h);
            let second = (16.0 * (b + d) - (a + e) - 30.0 * c) / (12.0 * h * h);
            let per = middle[&format!("{quantity}_per_{drive}")];
            assert!(
                (per - first).abs() < 1e-6 * (1.0 + first.abs()),
                "{quantity} per {drive}: {per} {first}"
            );
            let per = middle[&format!("{quantity}_per_{drive}2")];
            assert!(
                (per - second).abs() < 1e-4 * (1.0 + second.abs()),
                "{quantity} per {drive}: {per} {second}"
            );
            checked += 1;
        }
    }
    assert!(checked > 100, "{checked}");
    for name in [
        "roll_centre_m",
        "virtual_caster_rad",
        "front_centre_y",
        "brake_angle_rad",
    ] {
        assert!(middle[name].is_finite(), "{name}");
    }
}

#[test]
fn one_place_out_of_reach_is_printed_in_the_singular() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let arguments = ["sweep", "a.toml", "--drive", "steer=0:0.2:2"];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    assert!(
        message.contains(
            "1 of 2 places is out of reach from the design position; the other one was solved:\n"
        ),
        "{message}"
    );
}

#[test]
fn wrong_arguments_of_sweep_are_refused_in_one_sentence() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let wrong_radius = CORNER.replace("0.3 }", "-0.3 }");
    std::fs::write(folder.path().join("b.toml"), wrong_radius).expect("written");
    let wrong_drive = CORNER.replace("wheel_radius = 0.3", "travel = \"heave\"");
    std::fs::write(folder.path().join("c.toml"), wrong_drive).expect("written");
    for (file, drives, expected) in [
        (
            "a.toml",
            vec!["heave=0:1:2"],
            "a.toml: unknown drive `heave`; known are bump, steer",
        ),
        (
            "a.toml",
            vec!["bump=0:1:2", "bump=0:1:2"],
            "a.toml: the drive `bump` is given twice",
        ),
        (
            "a.toml",
            vec!["bump=0:1:2000", "steer=0:1:2000"],
            "a.toml: a grid may have 1000000 places at most",
        ),
        (
            "b.toml",
            vec!["bump=0"],
            "b.toml:3:28: wheel_radius is not a positive finite number",
        ),
        (
            "c.toml",
            vec!["bump=0"],
            "c.toml:3:22: unknown drive `heave`; known are bump, steer",
        ),
    ] {
        let mut arguments = vec!["sweep", file];
        for drive in drives {
            arguments.extend(["--drive", drive]);
        }
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn drive_columns_of_sweep_have_the_drives_own_values() {
    let folder = folder();
    let help = run(folder.path(), &["sweep", "--help"]);
    let help = text(&help.stdout);
    assert!(
        help.contains("the drives' own values, as [drives]"),
        "{help}"
    );
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let bump = |options: &[&str]| -> Vec<f64> {
        let sweep = [&["sweep", "a.toml", "--csv", "-"], options].concat();
        let output = run(folder.path(), &sweep);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let rows = rows(&output.stdout);
        rows.iter().map(|row| row["bump_m"]).collect()
    };
    let design = bump(&["--drive", "bump=0.0"])[0];
    let changes = bump(&["--drive", "bump=-0.02:0.02:3"]);
    let [from, to] = [design - 0.02, design + 0.02];
    let own = bump(&["--drive", &format!("bump={from}:{to}:3"), "--absolute"]);
    for (one, other) in changes.iter().zip([from, design, to]) {
        assert!((one - other).abs() < 1e-12, "{changes:?}");
    }
    assert_eq!(changes.len(), own.len());
    for (one, other) in changes.iter().zip(own) {
        assert!((one - other).abs() < 1e-12, "{changes:?}");
    }
}
