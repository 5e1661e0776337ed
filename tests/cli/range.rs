//! The ranges of drives.

use super::program::{CORNER, edited, example, folder, rows, run, text};

/// The turning points of the published drive, from a 40-digit solution, rad.
const ENDS: [f64; 2] = [0.662_460_552_146_186_5, 2.178_426_263_359_593];

/// When the published drive is at the upper end, s.
const LOCKS: f64 = 1.978_367_769_183;

/// The number after some words.
fn number_after(report: &str, words: &str) -> f64 {
    let (_, rest) = report.split_once(words).expect(words);
    let end = rest.find(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'));
    rest[..end.unwrap_or(rest.len())].parse().expect("a number")
}

#[test]
fn range_prints_both_ends_and_the_instant_of_the_lock() {
    let folder = folder();
    for name in ["attia2003.toml", "published_five_link.toml"] {
        std::fs::write(folder.path().join(name), example(name)).expect("written");
        let output = run(folder.path(), &["range", name]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let report = text(&output.stdout);
        for (line, expected) in report.lines().filter(|l| l.contains(" end   ")).zip(ENDS) {
            let value = number_after(line, "deg (");
            assert!((value - expected).abs() <= 1e-12, "{line}");
            assert!(line.contains("turning point of the drive"), "{line}");
        }
        let locks = number_after(report, "the upper end at t = ");
        assert!((locks - LOCKS).abs() <= 1e-9, "{locks}");
        assert!(report.contains(
            "stays in the range until its last instant, 1.95 s; continued, it would reach the "
        ));
        assert!(report.contains("4 turning points"), "{report}");
    }
}

/// A motion that also steers may lock within the range for a fixed steering.
#[test]
fn a_motion_of_several_drives_makes_no_claim_about_the_ends() {
    let folder = folder();
    let both = CORNER.replace("bump = 0.3", "bump = [0.3, 0.01]");
    let both = both.replace("steer = 0.34", "steer = [0.34, 0.01]");
    assert_eq!(both.matches("0.01]").count(), 2);
    std::fs::write(folder.path().join("a.toml"), both).expect("written");
    let output = run(folder.path(), &["range", "a.toml"]);
    let report = text(&output.stdout);
    assert_eq!(
        report.matches("moves other drives as well").count(),
        2,
        "{report}"
    );
    assert!(!report.contains("neither end"), "{report}");
}

#[test]
fn range_reports_a_drive_that_the_motion_holds() {
    let folder = folder();
    let bump = CORNER.replace("bump = 0.3", "bump = [0.3, 0.01]");
    std::fs::write(folder.path().join("a.toml"), bump).expect("written");
    let output = run(folder.path(), &["range", "a.toml", "--drive", "steer"]);
    let report = text(&output.stdout);
    assert!(
        report.contains("the file's motion holds this drive"),
        "{report}"
    );
    assert!(!report.contains("moves other drives"), "{report}");
}

/// `range` counts from the first instant and `check` from the design position; both state it.
#[test]
fn range_states_the_origin_of_its_values() {
    let folder = folder();
    let at = |bump: &str| CORNER.replace("bump = 0.3", bump);
    // The same lock of the same drive, in both ways of counting.
    let lock = |report: &str| {
        let mut lines = report
            .lines()
            .filter(|line| line.contains("`pushrod` is too long"));
        let line = lines.next().expect("a lock");
        assert!(
            line.contains(" m, at +0.1375 m from the design: "),
            "{line}"
        );
        let rounded = ["0.437538 m", "0.4375 m"];
        assert!(rounded.iter().any(|value| line.contains(value)), "{line}");
    };
    for (bump, expected) in [
        (
            "bump = 0.34",
            "Drive bump, from 0.34 m at the first instant, the other drives held as there",
        ),
        (
            "bump = 30",
            "Drive bump, from 0.3 m at the design position, the other drives held as there",
        ),
    ] {
        std::fs::write(folder.path().join("a.toml"), at(bump)).expect("written");
        let output = run(folder.path(), &["range", "a.toml"]);
        assert!(text(&output.stdout).contains(expected), "{output:?}");
        lock(text(&output.stdout));
        let output = run(folder.path(), &["check", "a.toml"]);
        lock(text(&output.stdout));
        let expected = "reach         of each drive from the design position, the other drives held there; `suspension range` starts";
        assert!(text(&output.stdout).contains(expected), "{output:?}");
    }
}

#[test]
fn a_motion_that_locks_names_the_drive_at_its_extreme() {
    let folder = folder();
    let two_seconds = edited("instants", "start = 0.0\nstop = 2.0\nstep = 0.05");
    std::fs::write(folder.path().join("a.toml"), two_seconds).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(3));
    let message = text(&output.stderr);
    assert!(message.contains("the drive `theta` locks at"), "{message}");
    let reached = number_after(message, "the motion ends at t = ");
    assert!((reached - LOCKS).abs() <= 5e-6, "six digits: {message}");
}

#[test]
fn range_writes_the_whole_curve_as_table_and_plot() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    let arguments = ["range", "a.toml", "--csv", "a.csv", "--plots", "."];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let table = rows(&std::fs::read(folder.path().join("a.csv")).expect("a table"));
    let turns: Vec<f64> = table
        .iter()
        .filter(|row| row["turns"] == 1.0)
        .map(|row| row["theta_rad"])
        .collect();
    assert_eq!(turns.len(), 4);
    for expected in ENDS {
        let nearest = turns.iter().map(|turn| (turn - expected).abs());
        assert!(nearest.fold(f64::INFINITY, f64::min) <= 1e-13);
    }
    let [first, last] = [&table[0], &table[table.len() - 1]];
    for (column, value) in first {
        let other = last[column];
        let rounding = 1e-11 * value.abs().max(1.0);
        assert!(
            (value - other).abs() <= rounding || column == "residual_m",
            "{column}"
        );
    }
    for pair in table.windows(2) {
        let moved = (pair[1]["p11_z"] - pair[0]["p11_z"]).abs();
        assert!(moved < 0.01, "no gap in the curve");
        assert!(pair[1]["residual_m"] <= 1e-14);
    }
    let plot = std::fs::read_to_string(folder.path().join("a_range_theta.svg")).expect("a plot");
    assert!(plot.contains("theta (deg)") && plot.contains("height z (m)"));
    assert_eq!(plot.matches("<circle").count(), 2, "both ends");
}

/// A point on a circle moves by the radius for a radian, whatever unknowns an angle has, at the ends of the angle too.
#[test]
fn the_speed_of_a_point_over_a_driven_angle_is_its_radius() {
    for (outer, drive) in [
        (
            "[0.4, 0.6, 0.3], mark at [0.4, 0.3, 0.0]",
            "angle(inner -> mark, inner -> tip about inner -> outer)",
        ),
        ("[0.4, 0.7, 0.3]", "angle(outer -> tip, z)"),
    ] {
        let file = format!(
            "statements = '''
fixed: inner at [0.4, 0.3, 0.3], outer at {outer};
free: tip at [0.0, 0.7, 0.3];
hinge arm: inner, outer -> tip;
drive turn: {drive};
'''
unit = \"m\"
time = {{ instants = [0.0] }}
drives = {{ turn = 1.5707963267948966 }}
"
        );
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["range", "a.toml", "--csv", "t.csv"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let report = text(&output.stdout);
        assert!(report.contains("poor        nowhere"), "{report}");
        let table = std::fs::read(folder.path().join("t.csv")).expect("a table");
        for row in rows(&table) {
            assert!((row["speed_m"] - 0.4).abs() < 1e-9, "{}", row["speed_m"]);
        }
    }
}

#[test]
fn for_a_motion_out_of_reach_ranges_start_at_the_design() {
    let folder = folder();
    let out_of_reach = edited("theta = [", "theta = [2.2]");
    std::fs::write(folder.path().join("a.toml"), out_of_reach).expect("written");
    let output = run(folder.path(), &["range", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let note = text(&output.stderr);
    assert!(note.starts_with(
        "note: a.toml: the first instant, t = 0 s with theta = 2.2 rad, is out of reach"
    ));
    assert!(note.contains("it stays at the design position"), "{note}");
    let report = text(&output.stdout);
    for (line, expected) in report.lines().filter(|l| l.contains(" end   ")).zip(ENDS) {
        let value = number_after(line, "deg (");
        assert!((value - expected).abs() <= 1e-12, "{line}");
    }
}

#[test]
fn invalid_arguments_of_range_are_refused() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    let cases: [(&[&str], i32, &str); 3] = [
        (&["range", "none.toml"], 2, "none.toml"),
        (
            &["range", "a.toml", "--csv", "a.toml"],
            2,
            "--csv would overwrite",
        ),
        (
            &["range", "a.toml", "--drive", "thta"],
            2,
            "a.toml: unknown drive `thta`; known are theta; did you mean `theta`?",
        ),
    ];
    for (arguments, code, expected) in cases {
        let output = run(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(code), "{output:?}");
        let message = text(&output.stderr);
        assert_eq!(message.lines().count(), 1, "{message}");
        assert!(message.contains(expected), "{message}");
    }
}

/// The ends are those of the design position's curve, to which the file's motion does not belong.
#[test]
fn a_motion_that_begins_out_of_reach_is_compared_with_no_end() {
    let folder = folder();
    let file = CORNER.replace("bump = 0.3", "bump = [-0.4, 0.1]");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["range", "a.toml"]);
    let report = text(&output.stdout);
    assert!(
        report.contains("  motion      the file's motion begins out of reach\n"),
        "{output:?}"
    );
}

/// A spring's perch that an actuator moves: only the measure reads it.
#[test]
fn the_range_of_a_drive_that_moves_no_free_point_has_no_nan() {
    let file = "unit = \"m\"\nstatements = '''\nfixed: front at [0.2, 0.3, 0.3], rear at [-0.2, 0.3, 0.3], perch at [0.0, 0.5, 0.6];\n\
                free: hub at [0.0, 0.7, 0.3];\nhinge arm: front, rear -> hub;\ndrive bump: hub.z;\ndrive height: perch.z;\n\
                measure spring: length(perch -> hub);\n'''\ntime = { instants = [0.0] }\ndrives = { bump = 0.3, height = 0.6 }\n";
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["range", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(!text(&output.stdout).contains("NaN"), "{output:?}");
}

/// With several wheels the plot shows the one that the drive moves up and down, or else the first.
#[test]
fn a_range_plot_names_its_wheel() {
    let folder = folder();
    let axle = example("live_axle_panhard.toml");
    std::fs::write(folder.path().join("a.toml"), axle).expect("written");
    let output = run(folder.path(), &["range", "a.toml", "--plots", "."]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    for (side, title) in [("left", "Left toe angle"), ("right", "Right toe angle")] {
        let path = folder.path().join(format!("a_range_bump_{side}.svg"));
        let plot = std::fs::read_to_string(path).expect("a plot");
        let title = format!("{title} over the whole curve of bump_{side}");
        assert!(plot.contains(&title), "{plot}");
    }
}

/// A wheel's height is a straight line over the drive that is this height, and over one that steers at constant height.
#[test]
fn a_range_plot_shows_toe_where_height_is_trivial() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let theta = example("five_link_height.toml");
    std::fs::write(folder.path().join("theta.toml"), theta).expect("written");
    for (file, drive, expected) in [
        ("a.toml", "bump", "Toe angle over the whole curve of bump"),
        ("a.toml", "steer", "Toe angle over the whole curve of steer"),
        (
            "theta.toml",
            "theta",
            "Height of the wheel centre over the whole curve of theta",
        ),
    ] {
        let arguments = ["range", file, "--drive", drive, "--plots", "."];
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let plot = file.replace(".toml", &format!("_range_{drive}.svg"));
        let plot = std::fs::read_to_string(folder.path().join(plot)).expect("a plot");
        assert!(plot.contains(expected), "{plot}");
    }
}

/// Report, table and plot of a named drive equal those in a run over all drives.
#[test]
fn the_range_of_one_named_drive_equals_that_among_all() {
    let folder = folder();
    let file = CORNER.replace("bump = 0.3", "bump = 0.34");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let range_with = |more: &[&str]| {
        let output = run(folder.path(), &[&["range", "a.toml"], more].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        output
    };
    let all = range_with(&[]);
    let (of_bump, of_steer) = text(&all.stdout).split_once("\nDrive steer").expect("two");
    let steer = range_with(&["--drive", "steer", "--plots", "."]);
    let alone = text(&steer.stdout).split_once("\nDrive steer");
    assert_eq!(alone.map(|(_, report)| report), Some(of_steer));
    assert!(of_bump.contains("from 0.34 m at the first instant"));
    assert!(of_steer.contains("from 0.34 m at the first instant, the other drives held as there"));
    let is_drawn = |drive: &str| folder.path().join(format!("a_range_{drive}.svg")).exists();
    assert!(is_drawn("steer") && !is_drawn("bump"));
    let both = range_with(&["--drive", "steer", "--drive", "bump", "--drive", "steer"]);
    assert_eq!(
        both.stdout, all.stdout,
        "in the order of the listing, each once"
    );
    let table = rows(&range_with(&["--drive", "steer", "--csv", "-"]).stdout);
    assert!(table.iter().all(|row| row["freed"] == 2.0));
}
