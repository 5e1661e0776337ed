//! The list of assemblies.

use std::collections::{BTreeMap, BTreeSet};

use super::program::{example, folder, rows, run, text};

#[test]
fn a_table_of_assemblies_and_how_sure_it_is() {
    let folder = folder();
    std::fs::write(
        folder.path().join("a.toml"),
        example("published_five_link.toml"),
    )
    .expect("written");
    let output = run(
        folder.path(),
        &[
            "assemblies",
            "a.toml",
            "--at",
            "0.7",
            "1.2",
            "--csv",
            "a.csv",
        ],
    );
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let report = text(&output.stdout);
    assert_eq!(
        report
            .matches("The list is complete by all that was tried")
            .count(),
        2
    );
    assert!(
        report.contains("4 real and 36 complex assemblies"),
        "{report}"
    );
    let table = std::fs::read(folder.path().join("a.csv")).expect("a table");
    let rows = rows(&table);
    let counts: Vec<f64> = rows.iter().map(|row| row["assembly"]).collect();
    assert_eq!(counts, [1.0, 2.0, 3.0, 4.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    assert!(rows[0]["distance_mm"] < 1e-9 && rows[1]["distance_mm"] > 100.0);
    for row in &rows {
        assert_eq!(row["mirrored"], 0.0);
        let edge = ["lower_front_outer", "upper_front_outer"].map(str::to_owned);
        let length = length(row, &edge);
        assert!((length - 214.453).abs() < 1e-9, "{length}");
    }
}

#[test]
fn nine_distances_have_mirrored_assemblies_too() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    let output = run(folder.path(), &["assemblies", "a.toml", "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let rows = rows(&output.stdout);
    let right = rows.iter().filter(|row| row["mirrored"] == 0.0).count();
    assert_eq!((rows.len(), right), (14, 4));
}

/// Where the curve of the wheel runs off to infinity along planes of the drive's coordinate, a general plane cuts it; and where
/// roots go to infinity as lengths become the mechanism's, they are told from those that are lost.
#[test]
fn the_list_of_a_layout_is_complete() {
    let folder = folder();
    for (file, tally) in [
        (
            include_str!("../../examples/double_wishbone.toml"),
            "\n24 real assemblies, put together part by part, in 3 parts:\n",
        ),
        (
            include_str!("../../examples/macpherson.toml"),
            "8 real and 12 complex assemblies, 4 at infinity, 0 not",
        ),
    ] {
        std::fs::write(folder.path().join("layout.toml"), file).expect("written");
        let output = run(folder.path(), &["assemblies", "layout.toml"]);
        let listed = text(&output.stdout);
        assert!(
            listed.contains("The list is complete by all that was tried:"),
            "{listed}"
        );
        assert!(listed.contains(tally), "{listed}");
    }
}

/// One side of an axle after the other, as far as they follow from the rack: 8 assemblies of the left one, which leads the rack,
/// times 2 places of its other end, times 4 of the right side on average.
#[test]
fn the_list_of_a_steered_axle_is_complete() {
    let folder = folder();
    let axle = include_str!("../../examples/steered_axle.toml");
    std::fs::write(folder.path().join("axle.toml"), axle).expect("written");
    let output = run(
        folder.path(),
        &["assemblies", "axle.toml", "--csv", "all.csv"],
    );
    let listed = text(&output.stdout);
    let expected = "The list is complete by all that was tried:\n64 real assemblies, put together part by part, in 3 parts:\n";
    assert!(listed.contains(expected), "{listed}");
    let rows = rows(&std::fs::read(folder.path().join("all.csv")).expect("a table"));
    assert_eq!(rows.len(), 64);
    let links = ["left", "right"].into_iter().flat_map(|side| {
        let of_side = |point: &str| format!("{side}_{point}");
        let balls = ["lower_ball", "upper_ball", "tie_ball", "wheel_centre"].map(of_side);
        let [lower, upper, tie, centre] = balls;
        let rack = format!("rack_{side}");
        [
            [lower.clone(), upper.clone()],
            [lower.clone(), tie.clone()],
            [upper, tie.clone()],
            [lower, centre],
            [rack, tie],
        ]
    });
    let rack = ["rack_left", "rack_right"].map(str::to_owned);
    for link in links.chain([rack]) {
        let [first, ..] = rows.as_slice() else {
            panic!("no rows")
        };
        for row in &rows {
            assert!((length(row, &link) - length(first, &link)).abs() < 1e-12);
        }
    }
    // Each is another one: by micrometres of all free points.
    let placed = rows.iter().map(|row| {
        let coordinates = row.iter().filter(|(name, _)| name.contains("_ball_"));
        let rounded = coordinates.map(|(_, x)| (x * 1e6).round() as i64);
        rounded
            .chain([(row["rack_right_y"] * 1e6).round() as i64])
            .collect::<Vec<_>>()
    });
    assert_eq!(placed.collect::<BTreeSet<_>>().len(), 64);
}

/// How far two points are apart.
fn length(row: &BTreeMap<String, f64>, [from, to]: &[String; 2]) -> f64 {
    let along =
        ["x", "y", "z"].map(|axis| row[&format!("{to}_{axis}")] - row[&format!("{from}_{axis}")]);
    along.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// A motion file of statements at one instant.
fn file(statements: &str, drives: &str) -> String {
    format!(
        "unit = \"m\"\ntime = {{ instants = [0.0] }}\ndrives = {{ {drives} }}\nstatements = \"\"\"{statements}\"\"\"\n"
    )
}

/// Of an angle of zero or half a turn the quarter has two values: with both all points stand at the same places.
#[test]
fn an_assembly_at_an_angle_of_zero_is_listed_once() {
    let folder = folder();
    let bar = file(
        "
        fixed: left_end at [0.0, 0.3, 0.3], right_end at [0.0, -0.3, 0.3];
        free:  left at [-0.2, 0.4, 0.3], right at [-0.2, -0.4, 0.3];
        hinge left_arm:  right_end, left_end -> left;
        hinge right_arm: right_end, left_end -> right;
        drive lift:  left.z;
        drive twist: angle(left_end -> left, right_end -> right about right_end -> left_end);",
        "lift = 0.3, twist = 0.0",
    );
    std::fs::write(folder.path().join("bar.toml"), bar).expect("written");
    let arguments = [
        "assemblies",
        "bar.toml",
        "--csv",
        "-",
        "--drive",
        "twist",
        "--at",
        "0.0",
        "0.3",
        "3.141592653589793",
    ];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let rows = rows(&output.stdout);
    let counts: Vec<f64> = rows.iter().map(|row| row["assembly"]).collect();
    assert_eq!(counts, [1.0, 2.0, 1.0, 2.0, 1.0, 2.0]);
    let chord = 2.0 * 0.2 * 0.15_f64.sin();
    let found = ["distance_m", "farthest_m"].map(|name| rows[2][name]);
    assert!(
        found.iter().all(|found| (found - chord).abs() < 1e-12),
        "{found:?}"
    );
}

/// Where on its line a point slides is an unknown too, but no coordinate.
#[test]
fn distances_are_those_of_points() {
    let folder = folder();
    let pillar = file(
        "
        fixed: top at [-0.03, 0.60, 0.48], bot at [0.0, 0.63, 0.18], rack at [0.13, 0.22, 0.24];
        free:  hi at [-0.02, 0.61, 0.38], lo at [-0.01, 0.62, 0.28], tie at [0.12, 0.57, 0.25],
               centre at [0.002, 0.70, 0.30];
        slide upper: hi on top -> bot;
        slide lower: lo on top -> bot;
        body knuckle: hi, lo, tie, centre;
        link rod: rack -> tie;
        drive bump: centre.z;",
        "bump = 0.30",
    );
    std::fs::write(folder.path().join("pillar.toml"), pillar).expect("written");
    let output = run(folder.path(), &["assemblies", "pillar.toml", "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let rows = rows(&output.stdout);
    assert_eq!(rows.len(), 4);
    for row in &rows {
        let moved = ["hi", "lo", "tie", "centre"].map(|point| {
            let along = ["x", "y", "z"].map(|axis| {
                let name = format!("{point}_{axis}");
                row[&name] - rows[0][&name]
            });
            along.iter().map(|x| x * x).sum::<f64>()
        });
        let distance = moved.iter().sum::<f64>().sqrt();
        let farthest = moved.into_iter().fold(0.0, f64::max).sqrt();
        assert!((row["distance_m"] - distance).abs() < 1e-9, "{row:?}");
        assert!((row["farthest_m"] - farthest).abs() < 1e-9, "{row:?}");
    }
}

/// At the file's own value the plane of a slide is an axis', and a coordinate of its point stands alone.
#[test]
fn parts_are_those_of_any_value_of_the_drives() {
    let folder = folder();
    let plane = file(
        "
        fixed: foot at [0.0, 0.0, 0.0], front at [1.0, 0.0, 0.0], head at [0.0, 0.0, 1.0],
               c at [0.5, 0.5, 0.3], d at [-0.2, -0.6, 0.5];
        free:  p at [0.4, 0.0, 0.0];
        plane slot: p on foot, front, head;
        link first: c -> p;
        link second: d -> p;
        drive tilt: front.y;",
        "tilt = 0.0",
    );
    std::fs::write(folder.path().join("plane.toml"), plane).expect("written");
    let arguments = [
        "assemblies",
        "plane.toml",
        "--csv",
        "-",
        "--at",
        "0.0",
        "1.0",
    ];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(rows(&output.stdout).len(), 4);
}

/// Points on three links each can all be mirrored: their assemblies multiply.
#[test]
fn a_list_that_would_be_too_long_is_cut() {
    let folder = folder();
    let points = 1..=13;
    let at = points
        .clone()
        .map(|point| format!("p{point} at [0.{point:02}, 0.3, 0.5]"));
    let at: Vec<String> = at.collect();
    let links = points.map(|point| format!("link a{point}: a -> p{point}; link b{point}: b -> p{point}; link c{point}: c -> p{point};\n"));
    let statements = format!(
        "fixed: a at [0, 0, 0], b at [1, 0, 0], c at [0, 1, 0.1];\nfree: {}, q at [0.2, 0.3, 0.3];\n\
         {}link qa: a -> q; link qb: b -> q;\ndrive z: q.z;",
        at.join(", "),
        links.collect::<String>(),
    );
    std::fs::write(
        folder.path().join("many.toml"),
        file(&statements, "z = 0.3"),
    )
    .expect("written");
    let output = run(folder.path(), &["assemblies", "many.toml"]);
    let expected =
        "The list may not be complete (only the first 10000 are listed):\n10000 real assemblies";
    assert!(text(&output.stdout).contains(expected), "{output:?}");
}

#[test]
fn a_value_without_an_assembly_is_no_success() {
    let folder = folder();
    let content = example("published_five_link.toml");
    std::fs::write(folder.path().join("a.toml"), content).expect("written");
    // Beyond the turning points at 0.662 and 2.178 rad, and all others of the closed curve.
    let arguments = [
        "assemblies",
        "a.toml",
        "--at",
        "0.7",
        "3.1",
        "--csv",
        "a.csv",
    ];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    assert!(
        message.contains("no assembly was found at theta = 3.1 rad"),
        "{message}"
    );
    assert!(text(&output.stdout).contains("cannot be put together there"));
    let table = std::fs::read(folder.path().join("a.csv")).expect("a table");
    assert_eq!(rows(&table).len(), 4, "those at 0.7 rad are kept");
}

#[test]
fn what_makes_no_sense_is_refused() {
    let folder = folder();
    std::fs::write(
        folder.path().join("a.toml"),
        example("published_five_link.toml"),
    )
    .expect("written");
    for (arguments, message) in [
        (["--at", "4"], "between 0 and pi"),
        (["--at", "nan"], "between 0 and pi"),
        (["--csv", "a.toml"], "would overwrite"),
    ] {
        let output = run(
            folder.path(),
            &[&["assemblies", "a.toml"][..], &arguments].concat(),
        );
        assert_eq!(output.status.code(), Some(2));
        let error = text(&output.stderr);
        assert!(
            error.contains(message) && error.lines().count() == 1,
            "{error}"
        );
    }
    let without_a_value = ["assemblies", "a.toml", "--drive", "theta"];
    let output = run(folder.path(), &without_a_value);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(text(&output.stderr).contains("--at"), "{output:?}");
    let unknown = ["assemblies", "a.toml", "--at", "1", "--drive", "bump"];
    let output = run(folder.path(), &unknown);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("unknown drive `bump`; known are theta"));
}

/// A double wishbone whose points are all off by up to 40 mm: its wishbones' axes are skew.
fn skew_double_wishbone(seed: u64) -> String {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut points = String::new();
    for (name, at) in [
        ("lower_front", [0.2, 0.35, 0.16]),
        ("lower_rear", [-0.2, 0.35, 0.16]),
        ("upper_front", [0.15, 0.42, 0.42]),
        ("upper_rear", [-0.15, 0.42, 0.42]),
        ("rack", [0.11, 0.34, 0.2]),
        ("lower_ball", [0.005, 0.7, 0.17]),
        ("upper_ball", [-0.015, 0.66, 0.44]),
        ("tie_ball", [0.12, 0.68, 0.21]),
        ("wheel_centre", [0.0, 0.75, 0.3]),
    ] {
        let at = at.map(|x: f64| x + 0.08 * (random.f64() - 0.5));
        points += &format!("{name} = {at:?}\n");
    }
    format!(
        "linkage = \"double_wishbone\"\nunit = \"m\"\ntime = {{ instants = [0.0] }}\n\
         [points]\n{points}[drives]\nbump = 0.3\nsteer = 0.34\n"
    )
}

#[test]
fn a_list_of_a_skew_double_wishbone_is_complete_with_32_or_says_that_it_may_not_be() {
    const SEEDS: u64 = 6;
    let folder = folder();
    let mut complete = 0;
    for seed in 0..SEEDS {
        let file = skew_double_wishbone(seed);
        std::fs::write(folder.path().join("a.toml"), &file).expect("written");
        let arguments = ["assemblies", "a.toml", "--drive", "bump", "--at", "0.3"];
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(0), "seed {seed}: {output:?}");
        let report = text(&output.stdout);
        if report.contains("The list is complete") {
            assert!(report.contains("of the 32 that"), "seed {seed}: {report}");
            complete += 1;
        }
    }
    assert!(complete + 1 >= SEEDS, "{complete} of {SEEDS}");
}

/// A four-bar linkage whose crank is driven by its angle about its own axis: the rocker stands on either side. The equations
/// have the sine of a quarter of the angle, which the crank at minus the angle has too, and at what it lacks to a straight one.
#[test]
fn a_driven_angle_about_an_axis_is_the_one_that_is_asked_for() {
    let folder = folder();
    let statements = "
        fixed: a at [0, 0, 0], a2 at [0.1, 0, 0], b at [0, 1, 0], b2 at [0.1, 1, 0];
        free: p at [0, 0, 0.3], q at [0, 1.1, 0.8];
        hinge crank: a, a2 -> p;
        hinge rocker: b, b2 -> q;
        link rod: p -> q;
        drive turn: angle(a -> b, a -> p about a -> a2);";
    let file = file(statements, "turn = 1.5");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let angles = [1.5, 0.4, 2.4, -0.9];
    let mut arguments = vec!["assemblies", "a.toml", "--csv", "a.csv", "--at"];
    let words = angles.map(|angle| angle.to_string());
    arguments.extend(words.iter().map(String::as_str));
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("2 real (6 more at other quarters of a driven angle)"));
    let rows = rows(&std::fs::read(folder.path().join("a.csv")).expect("a table"));
    assert_eq!(rows.len(), 2 * angles.len());
    for row in rows {
        let crank = row["p_z"].atan2(row["p_y"]);
        assert!((crank - row["turn_rad"]).abs() < 1e-9, "{row:?}");
    }
}
