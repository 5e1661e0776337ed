//! Assemblies of mechanisms that are combined from parts: they are distinguished by points only.

use crate::program::{Rows, folder, rows, run, table, text};

/// A motion file of statements at one instant.
fn file(statements: &str, drives: &str) -> String {
    format!(
        "unit = \"m\"\ntime = {{ instants = [0.0] }}\ndrives = {{ {drives} }}\nstatements = \"\"\"{statements}\"\"\"\n"
    )
}

/// The rows of the assemblies of statements, with further arguments.
fn listed(statements: &str, drives: &str, arguments: &[&str]) -> Rows {
    let arguments = [&["assemblies"], arguments].concat();
    table(&file(statements, drives), &arguments)
}

/// A four-bar linkage whose crank is driven by its angle about its own axis: the rocker is on either side. The equations
/// contain the sine of a quarter of the angle, which is the same for minus the angle and for its supplement.
#[test]
fn listed_assemblies_have_the_requested_angle_about_the_axis() {
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

/// For an angle of zero or half a turn the quarter has two values: with both, all points coincide.
#[test]
fn an_assembly_at_angle_zero_is_listed_once() {
    let rows = listed(
        "
        fixed: left_end at [0.0, 0.3, 0.3], right_end at [0.0, -0.3, 0.3];
        free:  left at [-0.2, 0.4, 0.3], right at [-0.2, -0.4, 0.3];
        hinge left_arm:  right_end, left_end -> left;
        hinge right_arm: right_end, left_end -> right;
        drive lift:  left.z;
        drive twist: angle(left_end -> left, right_end -> right about right_end -> left_end);",
        "lift = 0.3, twist = 0.0",
        &[
            "--drive",
            "twist",
            "--at",
            "0.0",
            "0.3",
            "3.141592653589793",
        ],
    );
    let counts: Vec<f64> = rows.iter().map(|row| row["assembly"]).collect();
    assert_eq!(counts, [1.0, 2.0, 1.0, 2.0, 1.0, 2.0]);
    let chord = 2.0 * 0.2 * 0.15_f64.sin();
    let found = ["distance_m", "farthest_m"].map(|name| rows[2][name]);
    assert!(
        found.iter().all(|found| (found - chord).abs() < 1e-12),
        "{found:?}"
    );
}

/// The position of a sliding point along its line is an unknown too, but not a coordinate.
#[test]
fn distances_of_assemblies_are_computed_from_points_alone() {
    let rows = listed(
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
        &[],
    );
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

/// At the file's own value the plane of a slide is perpendicular to an axis, and a coordinate of its point is independent.
#[test]
fn parts_of_a_mechanism_do_not_depend_on_the_drive_values() {
    let rows = listed(
        "
        fixed: foot at [0.0, 0.0, 0.0], front at [1.0, 0.0, 0.0], head at [0.0, 0.0, 1.0],
               c at [0.5, 0.5, 0.3], d at [-0.2, -0.6, 0.5];
        free:  p at [0.4, 0.0, 0.0];
        plane slot: p on foot, front, head;
        link first: c -> p;
        link second: d -> p;
        drive tilt: front.y;",
        "tilt = 0.0",
        &["--at", "0.0", "1.0"],
    );
    assert_eq!(rows.len(), 4);
}

/// Points on three links each can all be mirrored: their assemblies multiply.
#[test]
fn a_list_of_too_many_assemblies_is_cut() {
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
