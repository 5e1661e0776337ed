//! Led motions, which a measure prescribes in place of a drive.

mod out_of_reach;

use std::f64::consts::FRAC_PI_2;
use std::path::Path;

use super::program::{example, folder, rows, run, table_in, text};

/// A motion by theta between the turning points of the height.
const BY_THETA: [(&str, &str); 2] = [
    ("stop = 1.95", "stop = 2.4"),
    ("theta = [0.7, 0.5, 0.125]", "theta = [0.9, 0.5]"),
];

/// Another motion of the linkage, by its height.
const BY_HEIGHT: (&str, &str) = ("theta = [0.7, 0.5, 0.125]", "height = [50.0, -10.0]");

fn edited(name: &str, edits: &[(&str, &str)]) -> String {
    edits.iter().fold(example(name), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    })
}

fn write(folder: &Path, name: &str, content: &str) {
    std::fs::write(folder.join(name), content).expect("written");
}

/// The instants at which a motion from `from` with a constant rate has these heights.
fn instants(heights: impl Iterator<Item = f64>, from: f64, rate: f64) -> String {
    let each: Vec<String> = heights
        .map(|height| format!("{:.17e}", (height - from) / rate))
        .collect();
    format!("instants = [{}]", each.join(", "))
}

/// Led by height at a constant rate, a row has the same configuration as by theta, its velocities
/// `v h'_led / h'` and accelerations `(a - v h'' / h') (h'_led / h')^2`.
#[test]
fn a_led_motion_has_the_configurations_of_the_driven_motion() {
    const RATE: f64 = -40.0;
    let folder = folder();
    write(
        folder.path(),
        "theta.toml",
        &edited("published_five_link.toml", &BY_THETA),
    );
    let driven = table_in(folder.path(), &["motion", "theta.toml"]);
    let from = driven[0]["height_mm"];
    let times = instants(driven.iter().map(|row| row["height_mm"]), from, RATE);
    let by_height = [
        ("start = 0.0\nstop = 1.95\nstep = 0.05", times.as_str()),
        (BY_HEIGHT.0, &format!("height = [{from:.17e}, {RATE}]")),
    ];
    write(
        folder.path(),
        "height.toml",
        &edited("published_five_link.toml", &by_height),
    );
    let led = table_in(folder.path(), &["motion", "height.toml"]);
    assert_eq!((led.len(), driven.len()), (49, 49));
    let mut worst = [0.0_f64; 3];
    for (led, driven) in led.iter().zip(&driven) {
        let pace = RATE / driven["wheel_centre_vz"];
        let slowing = driven["wheel_centre_az"] / driven["wheel_centre_vz"];
        let mut differ = |order: usize, column: &str, expected: f64| {
            let off = (led[column] - expected).abs() / expected.abs().max(1.0);
            worst[order] = worst[order].max(off);
        };
        differ(0, "theta_rad", driven["theta_rad"]);
        for point in ["lower_front_outer", "track_rod_outer", "wheel_centre"] {
            for axis in ["x", "y", "z"] {
                let [x, v, a] = ["", "v", "a"].map(|kind| format!("{point}_{kind}{axis}"));
                differ(0, &x, driven[&x]);
                differ(1, &v, driven[&v] * pace);
                differ(2, &a, (driven[&a] - driven[&v] * slowing) * pace * pace);
            }
        }
    }
    assert!(
        worst[0] <= 1e-12 && worst[1] <= 1e-11 && worst[2] <= 1e-10,
        "{worst:?}"
    );
}

/// The example passes the turning point of theta, and at and beyond it agrees with the curve of `suspension range`.
#[test]
fn a_motion_led_by_height_passes_the_turning_point_of_theta() {
    let folder = folder();
    let name = "five_link_height.toml";
    write(folder.path(), name, &example(name));
    let motion = table_in(folder.path(), &["motion", name]);
    let theta: Vec<f64> = motion.iter().map(|row| row["theta_rad"]).collect();
    let falls: Vec<bool> = theta.windows(2).map(|pair| pair[1] < pair[0]).collect();
    let turns = falls.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert_eq!((motion.len(), falls[0], turns), (184, true, 1));
    assert!((motion[183]["height_mm"] + 99.5).abs() <= 1e-9);
    let curve = table_in(folder.path(), &["range", name]);
    let height = |index: usize| curve[index]["wheel_centre_z"];
    let turning = (0..curve.len())
        .find(|index| curve[*index]["turns"] == 1.0 && curve[*index]["theta_rad"] < 0.7)
        .expect("a turning point");
    // Along the curve the height falls in one direction from there and rises in the other.
    let falls_onwards = height(turning + 1) < height(turning);
    let along = |steps: usize| {
        if falls_onwards {
            turning + steps
        } else {
            turning - steps
        }
    };
    let stations: Vec<_> = (0..)
        .map(along)
        .take_while(|index| height(*index) > -99.0)
        .collect();
    assert!(stations.len() > 20, "{}", stations.len());
    let times = instants(stations.iter().map(|index| height(*index)), 358.0, -50.0);
    let replaced = [("start = 0.0\nstop = 9.15\nstep = 0.05", times.as_str())];
    write(folder.path(), "there.toml", &edited(name, &replaced));
    let led = table_in(folder.path(), &["motion", "there.toml"]);
    for (row, index) in led.iter().zip(stations) {
        let station = &curve[index];
        for (column, expected) in station.iter().filter(|(column, _)| {
            column.ends_with("_x") || column.ends_with("_z") || *column == "theta_rad"
        }) {
            let off = (row[column] - expected).abs() / expected.abs().max(1.0);
            assert!(
                off <= 1e-12,
                "{column} at {} off by {off:e}",
                row["height_mm"]
            );
        }
    }
}

#[test]
fn a_led_motion_ends_at_the_turning_point_of_its_measure() {
    let folder = folder();
    let beyond = edited("five_link_height.toml", &[("stop = 9.15", "stop = 9.5")]);
    write(folder.path(), "a.toml", &beyond);
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "a.csv"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr).lines().last().expect("a message");
    for expected in [
        "no configuration at t = 9.2 s with height = -102 mm",
        "goes no further than height = -100.14 mm",
        "measure `height` has an extreme value of -100.14 mm",
        "184 rows were kept",
    ] {
        assert!(
            message.contains(expected),
            "{expected} is not in: {message}"
        );
    }
    let kept = std::fs::read(folder.path().join("a.csv")).expect("a table");
    assert_eq!(rows(&kept).len(), 184);
}

/// A kilometre up, the height counts from the file's origin.
#[test]
fn far_from_the_origin_a_leading_height_counts_from_that_of_the_file() {
    const UP: f64 = 1e6;
    let folder = folder();
    let near = edited("published_five_link.toml", &[BY_HEIGHT]);
    let raised = |line: &str| match line
        .split_once("= [")
        .map(|(name, rest)| (name, rest.trim_end_matches(']')))
    {
        Some((name, list)) if !name.contains('{') && !name.starts_with('h') => {
            let (xy, z) = list.rsplit_once(", ").expect("coordinates");
            format!(
                "{name}= [{xy}, {}]",
                z.parse::<f64>().expect("a number") + UP
            )
        }
        _ => line.replace("[50.0,", &format!("[{},", 50.0 + UP)),
    };
    let far: Vec<String> = near.lines().map(raised).collect();
    write(folder.path(), "near.toml", &near);
    write(folder.path(), "far.toml", &far.join("\n"));
    let tables =
        |command| ["near.toml", "far.toml"].map(|name| table_in(folder.path(), &[command, name]));
    let [near, far] = tables("range");
    let off = far[0]["wheel_centre_z"] - UP - near[0]["wheel_centre_z"];
    assert!(off.abs() <= 1e-8, "{off:e}");
    let [near, far] = tables("motion");
    assert_eq!(near.len(), far.len());
    for (near, far) in near.iter().zip(&far) {
        let rounding = 4.0 * UP * f64::EPSILON;
        for column in ["height_mm", "wheel_centre_z", "lower_rear_outer_z"] {
            assert!(
                (far[column] - UP - near[column]).abs() <= 4.0 * rounding,
                "{column}"
            );
        }
        assert!((far["theta_rad"] - near["theta_rad"]).abs() <= rounding);
    }
}

#[test]
fn wrong_sets_of_drives_and_leading_measures_are_refused() {
    let cases = [
        (
            "theta = [0.7]\nheight = [50.0]",
            ":52:1: measure `height` can only replace a drive",
        ),
        (
            "bump = [50.0]",
            ":51:1: unknown drive `bump`; the drives are theta, and one of them may be replaced by height",
        ),
        (
            "height = []",
            ":51:10: drive `height` needs at least one coefficient",
        ),
        (
            "height = [nan]",
            ":51:10: drive `height` has a coefficient that is not a finite",
        ),
        ("", ":49:1: drive `theta` is missing"),
    ];
    let folder = folder();
    for (drives, expected) in cases {
        let content = edited("published_five_link.toml", &[(BY_HEIGHT.0, drives)]);
        write(folder.path(), "a.toml", &content);
        let output = run(folder.path(), &["motion", "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert_eq!(message.lines().count(), 1);
        assert!(
            message.starts_with(&format!("a.toml{expected}")),
            "{message}"
        );
    }
    let design = edited(
        "published_five_link.toml",
        &[("theta = 1.57", "height = 50.0\ntheta = 1.57")],
    );
    write(folder.path(), "a.toml", &design);
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(text(&output.stderr).contains("unknown drive `height`"));
}

#[test]
fn bake_refuses_a_motion_led_by_a_measure() {
    let folder = folder();
    write(
        folder.path(),
        "a.toml",
        &edited("published_five_link.toml", &[BY_HEIGHT]),
    );
    let output = run(folder.path(), &["bake", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected =
        "a.toml:51:1: `height` is a measure that prescribes the motion; suspension bake needs";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
    let files = std::fs::read_dir(folder.path()).expect("a folder").count();
    assert_eq!(files, 1);
}

#[test]
fn range_and_assemblies_start_at_the_led_position() {
    let folder = folder();
    write(
        folder.path(),
        "a.toml",
        &edited("published_five_link.toml", &[BY_HEIGHT]),
    );
    let theta = table_in(folder.path(), &["motion", "a.toml"])[0]["theta_rad"];
    for (command, before, after, digits) in [
        ("range", "deg (", " rad) at the first instant", 1e-11),
        ("assemblies", "At theta = ", " rad:", 1e-5),
    ] {
        let output = run(folder.path(), &[command, "a.toml"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let report = text(&output.stdout);
        let (head, _) = report.split_once(after).expect(after);
        let (_, value) = head.split_once(before).expect(before);
        let value: f64 = value.parse().expect("a number");
        assert!((value - theta).abs() <= digits, "{report}");
        if command == "range" {
            assert!(report.contains("led by a measure"), "{report}");
        }
    }
}

/// A crank that its measured angle turns twice round, a slider in place of it; measured, the angle jumps at half a turn.
#[test]
fn a_measured_angle_leads_a_crank_through_two_turns() {
    let folder = folder();
    let statements = "
        fixed: a at [0, 0, 0], a2 at [0.1, 0, 0], s1 at [0, 0.2, 0], s2 at [0, 1, 0];
        free: p at [0, 0, 0.2], q at [0, 0.4582575694955840, 0];
        hinge crank: a, a2 -> p;
        slide guide: q on s1 -> s2;
        link rod: p -> q;
        drive along: q.y;
        measure turn: angle(a -> s2, a -> p about a -> a2);";
    for rate in [2.0, -2.0] {
        let file = format!(
            "unit = \"m\"\ntime = {{ start = 0.0, stop = 6.0, step = 0.05 }}\n\
             drives = {{ turn = [{FRAC_PI_2:?}, {rate:?}] }}\nstatements = '''{statements}'''\n"
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let rows = table_in(folder.path(), &["motion", "a.toml"]);
        assert_eq!(rows.len(), 121);
        for row in rows {
            let turn = FRAC_PI_2 + rate * row["t_s"];
            assert!((row["p_y"] - 0.2 * turn.cos()).abs() < 1e-9, "{row:?}");
            assert!((row["p_z"] - 0.2 * turn.sin()).abs() < 1e-9, "{row:?}");
        }
    }
}
