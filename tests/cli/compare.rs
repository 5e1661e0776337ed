//! Comparisons of two suspensions.

mod alone;
mod axles;
mod drives;
mod measured;
mod rig;

use std::process::Output;

use super::program::{CORNER, folder, run, text};

fn compare(a: &str, b: &str, options: &[&str]) -> (tempfile::TempDir, Output) {
    let folder = folder();
    for (name, content) in [("a.toml", a), ("b.toml", b)] {
        std::fs::write(folder.path().join(name), content).expect("written");
    }
    let output = run(
        folder.path(),
        &[&["compare", "a.toml", "b.toml"], options].concat(),
    );
    (folder, output)
}

/// The rows of the table: of, quantity, unit, then at, a, b and difference.
fn rows(output: &Output) -> Vec<([String; 3], [f64; 4])> {
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    let row = |record: csv::StringRecord| {
        let text = |index: usize| record[index].to_owned();
        let number = |index: usize| record[index].parse().unwrap_or(f64::NAN);
        ([0, 1, 2].map(text), [3, 4, 5, 6].map(number))
    };
    reader
        .records()
        .map(|record| row(record.expect("a row")))
        .collect()
}

/// An arm that turns about a line along x, led by its tip's height, with a spring upright above the tip.
fn arm(unit: &str, metre: f64, top: f64) -> String {
    let at =
        |x: f64, y: f64, z: f64| format!("[{:?}, {:?}, {:?}]", x * metre, y * metre, z * metre);
    format!(
        "unit = \"{unit}\"\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.0 }}\nstatements = \"\"\"\n\
         fixed: front at {}, rear at {}, top at {};\nfree: tip at {};\n\
         link fore: front -> tip;\nlink aft: rear -> tip;\ndrive bump: tip.z;\n\
         measure spring: length(top -> tip);\n\"\"\"\n",
        at(0.2, 0.0, 0.0),
        at(-0.2, 0.0, 0.0),
        at(0.0, 0.5, top),
        at(0.0, 0.5, 0.0),
    )
}

#[test]
fn compared_kingpin_angles_match_a_calculation_by_hand() {
    let moved = format!("{CORNER}[points]\nupper_ball = [-0.015, 0.65, 0.44]\n");
    let (_folder, output) = compare(CORNER, &moved, &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let rows = rows(&output);
    let row = |of: &str, quantity: &str| {
        let found = rows
            .iter()
            .find(|(names, _)| names[0] == of && names[1] == quantity);
        found.unwrap_or_else(|| panic!("no {of} {quantity}"))
    };
    let ([_, _, unit], [_, a, b, difference]) = row("design", "kingpin angle");
    let [before, after] = [0.04_f64, 0.05].map(|lean| lean.atan2(0.27).to_degrees());
    assert_eq!(unit, "deg");
    assert!(
        (a - before).abs() < 1e-9 && (b - after).abs() < 1e-9,
        "{a} {b}"
    );
    assert!((difference - (after - before)).abs() < 1e-9);
    // Bump camber: the wheel's height is driven, so that its own derivative is one in both.
    let (_, [_, a, b, _]) = row("per travel", "wheel centre z");
    assert!((a - 1.0).abs() < 1e-12 && (b - 1.0).abs() < 1e-12);
    let (_, [at, a, b, difference]) = row("over travel", "camber angle");
    assert!((-0.06..=0.06).contains(at) && (b - a - difference).abs() < 1e-12);
    let (_, [_, _, _, at_design]) = row("design", "camber angle");
    assert!(
        difference.abs() > at_design.abs(),
        "largest at the ends of the travel"
    );
}

#[test]
fn compared_lengths_are_in_the_unit_of_the_first_file() {
    let (_folder, output) = compare(
        &arm("m", 1.0, 0.4),
        &arm("mm", 1000.0, 0.4),
        &["--csv", "-"],
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let rows = rows(&output);
    assert!(rows.len() > 3, "{rows:?}");
    for (names, [_, a, b, difference]) in &rows {
        assert!(!names[2].contains("mm"), "{names:?}");
        assert!(
            difference.abs() < 1e-12 && (a - b).abs() < 1e-12,
            "{names:?}"
        );
    }
    let spring =
        |(names, _): &&([String; 3], [f64; 4])| names[0] == "design" && names[1] == "spring";
    let (_, [_, a, ..]) = rows.iter().find(spring).expect("a spring");
    assert!((a - 0.4).abs() < 1e-12);
}

/// Masses are converted with the points, and the load of a spring along a coordinate changes its sign with the coordinate.
#[test]
fn masses_and_springs_compare_equal_in_other_axes() {
    let file = |axes: &str, [x, y, z]: [f64; 3]| {
        let at = |a: f64, b: f64, c: f64| format!("[{:?}, {:?}, {:?}]", a * x, b * y, c * z);
        let points = [
            at(0.20, 0.35, 0.16),
            at(-0.20, 0.36, 0.15),
            at(0.005, 0.70, 0.17),
            at(0.01, 0.75, 0.30),
            at(0.01, 0.65, 0.30),
        ];
        let [front, rear, ball, centre, axle] = points;
        let [xy, yz, zx] = [0.1 * x * y, 0.05 * y * z, -0.02 * z * x];
        let mass = at(0.02, 0.72, 0.33);
        let load = -3000.0 * z;
        format!(
            "unit = \"m\"\n{axes}statements = \"\"\"\nfixed: front at {front}, rear at {rear};\n\
             free: ball at {ball}, wheel_centre at {centre};\nhinge arm: front, rear -> ball, wheel_centre;\n\
             point axle: arm at {axle};\ndrive bump: wheel_centre.z;\nmeasure height: ball.z;\n\
             wheel: axle -> wheel_centre;\n\"\"\"\n\
             time = {{ instants = [0.0] }}\nvehicle = {{ wheel_radius = 0.3 }}\ndrives = {{ bump = {:?} }}\n\
             [masses]\narm = {{ mass = 20.0, centre = {mass}, inertia = [0.6, 0.9, 0.5, {xy:?}, {yz:?}, {zx:?}] }}\n\
             [springs.s]\nalong = \"height\"\nrate = 20000.0\nload = {load:?}\n",
            0.30 * z,
        )
    };
    let iso = file("", [1.0; 3]);
    for (axes, signs) in [("Adams", [-1.0, -1.0, 1.0]), ("SAE", [1.0, -1.0, -1.0])] {
        let other = file(&format!("axes = \"{axes}\"\n"), signs);
        let (_folder, output) = compare(&iso, &other, &["--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let rows = rows(&output);
        for wanted in [
            "effective mass at the wheel",
            "load on the springs at the wheel",
            "wheel rate",
        ] {
            assert!(
                rows.iter().any(|(names, _)| names[1] == wanted),
                "{wanted}: {rows:?}"
            );
        }
        for (names, [_, a, b, difference]) in &rows {
            assert!(
                difference.abs() < 1e-8 * (1.0 + a.abs()),
                "{axes}: {names:?} {a} {b}"
            );
        }
    }
}

/// The tip goes up by z on a circle of 0.5 m; the spring above it stands 0.4 or 0.5 m high.
#[test]
fn the_largest_difference_of_a_curve_matches_the_closed_form() {
    let options = ["--csv", "-", "--travel", "-0.2:0.1"];
    let (_folder, output) = compare(&arm("m", 1.0, 0.4), &arm("m", 1.0, 0.5), &options);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let spring = |top: f64, z: f64| (0.5 - (0.25 - z * z).sqrt()).hypot(top - z);
    let difference = |place: i32| {
        let z = -0.2 + 0.3 * f64::from(place) / 60.0;
        (z, spring(0.5, z) - spring(0.4, z))
    };
    let (at, largest) = (0..=60)
        .map(difference)
        .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
        .expect("places");
    let rows = rows(&output);
    let over = rows
        .iter()
        .find(|(names, _)| names[0] == "over travel" && names[1] == "spring");
    let (_, [told_at, _, _, difference_found]) = over.expect("a curve");
    assert!(
        (told_at - at).abs() < 1e-12 && (difference_found - largest).abs() < 1e-12,
        "{told_at} {difference_found}"
    );
    let (_folder, output) = compare(
        &arm("m", 1.0, 0.4),
        &arm("m", 1.0, 0.5),
        &["--json", "-", "--travel", "-0.2:0.1"],
    );
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(json["header"]["b"], "b.toml");
    let over = json["rows"].as_array().expect("rows").iter();
    let mut over = over.filter(|row| row["of"] == "over travel" && row["quantity"] == "spring");
    let row = over.next().expect("a row");
    let squares: f64 = (0..=60).map(|place| difference(place).1.powi(2)).sum();
    let rms = row["rms"].as_f64().expect("a number");
    assert!((rms - (squares / 61.0).sqrt()).abs() < 1e-12, "{rms}");
    assert_eq!(row["along"], "change of bump (m)");
}

/// The springs of both have a preload difference of 200 N everywhere, so no place is named; their force at the wheel varies.
#[test]
fn a_constant_difference_has_no_place() {
    let of_load = |load: f64| {
        format!("{CORNER}[springs.a]\nalong = \"damper\"\nrate = 0.0\nload = {load:?}\n")
    };
    let (_folder, output) = compare(&of_load(300.0), &of_load(500.0), &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let rows = rows(&output);
    let place = |quantity: &str| {
        let mut over = rows.iter().filter(|(names, _)| names[0] == "over travel");
        let row = over.find(|(names, _)| names[1] == quantity);
        let (_, [at, .., difference]) = row.unwrap_or_else(|| panic!("no {quantity}: {rows:?}"));
        (*at, *difference)
    };
    let (at, difference) = place("a_force");
    assert!(
        at.is_nan() && (difference - 200.0).abs() < 1e-9,
        "{at} {difference}"
    );
    let (at, difference) = place("load on the springs at the wheel");
    assert!(
        at.is_finite() && difference.abs() > 1.0,
        "{at} {difference}"
    );
    let (folder, output) = compare(&of_load(300.0), &of_load(500.0), &["--html", "c.html"]);
    let report = text(&output.stdout);
    let (_, over) = report
        .split_once("Largest difference over bump")
        .expect("curves");
    let line = over
        .lines()
        .find(|line| line.contains("  a_force "))
        .expect("a line");
    let words: Vec<&str> = line.split_whitespace().collect();
    assert_eq!(
        words,
        ["a_force", "300", "500", "200", "N", "everywhere", "200"]
    );
    let page = std::fs::read_to_string(folder.path().join("c.html")).expect("a page");
    assert!(
        page.contains("<td class=\"number\">everywhere</td>"),
        "{page}"
    );
}

#[test]
fn compare_prints_a_text_table_and_writes_a_page() {
    let (folder, output) = compare(CORNER, CORNER, &["--html", "c.html", "--csv", "c.csv"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    for expected in [
        "A  a.toml (double_wishbone_pushrod)",
        "B - A",
        "Largest difference over bump",
    ] {
        assert!(report.contains(expected), "{report}");
    }
    let page = std::fs::read_to_string(folder.path().join("c.html")).expect("a page");
    assert!(page.matches("<svg").count() > 20 && page.contains("camber angle"));
    // The legends name the files a.toml and b.toml.
    for (name, is_shown) in [("a", true), ("b", true), ("A", false)] {
        assert_eq!(
            page.contains(&format!("\n{name}\n</text>")),
            is_shown,
            "{page}"
        );
    }
    assert!(folder.path().join("c.csv").exists());
}

/// As for other commands, `-` is standard output: the page takes the place of the table.
#[test]
fn the_page_of_compare_goes_to_standard_output_for_a_hyphen() {
    let (folder, output) = compare(CORNER, CORNER, &["--html", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = text(&output.stdout);
    assert!(page.starts_with("<!DOCTYPE html>") && page.trim_end().ends_with("</html>"));
    assert!(!folder.path().join("-").exists());
    let (_, output) = compare(CORNER, CORNER, &["--html", "-", "--csv", "-"]);
    let expected = "--html and --csv name the same place; give each its own";
    assert!(text(&output.stderr).contains(expected), "{output:?}");
}

#[test]
fn compare_refuses_files_that_cannot_be_compared() {
    let arm_alone = arm("m", 1.0, 0.4).replace("bump", "lift");
    for (b, options, expected) in [
        (
            arm_alone.as_str(),
            &[][..],
            "b.toml: which drive moves the wheel up and down?",
        ),
        (CORNER, &["--html", "b.toml"], "--html would overwrite"),
        (CORNER, &["--csv", "a.toml"], "--csv would overwrite"),
        // Places are checked before anything is solved.
        (&*arm_alone, &["--csv", "a.toml"], "--csv would overwrite"),
    ] {
        let (_folder, output) = compare(CORNER, b, options);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(text(&output.stderr).contains(expected), "{output:?}");
    }
}

#[test]
fn a_page_and_a_table_of_compare_at_one_path_are_refused() {
    let file = arm("m", 1.0, 0.4);
    let (folder, output) = compare(&file, &file, &["--html", "y", "--csv", "./y"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let error = text(&output.stderr);
    assert!(
        error.contains("--html and --csv name the same place"),
        "{error}"
    );
    assert!(!folder.path().join("y").exists());
}
