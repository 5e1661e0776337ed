//! The places of the least and greatest forces, and the tables of grids and motions.

use std::path::Path;

use super::super::program::{Rows, folder, rows, run, text};
use super::{BRAKING, loaded};

/// The line of a report that begins with a name.
fn line<'a>(report: &'a str, name: &str) -> &'a str {
    let mut lines = report.lines();
    let found = lines.find(|line| line.split_whitespace().next() == Some(name));
    found.unwrap_or_else(|| panic!("{name} in {report}"))
}

/// Returns the report of a command and its table.
fn report_and_table(file: &str, more: &[&str]) -> (String, Rows) {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(
        folder.path(),
        &[&["loads", "a.toml", "--csv", "a.csv"], more].concat(),
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let table = std::fs::read(folder.path().join("a.csv")).expect("a table");
    (text(&output.stdout).to_owned(), rows(&table))
}

/// The values of some columns in the rows in which a column is least and greatest.
fn extremes<const N: usize>(rows: &Rows, of: &str, at: [&str; N]) -> [[f64; N]; 2] {
    let least = rows.iter().min_by(|a, b| a[of].total_cmp(&b[of]));
    let greatest = rows.iter().max_by(|a, b| a[of].total_cmp(&b[of]));
    [least, greatest].map(|row| at.map(|name| row.expect("a row")[name]))
}

/// A number without its rounding.
fn short(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

#[test]
fn the_heading_of_a_load_case_names_the_drive_values() {
    let file = loaded(BRAKING);
    for (more, expected) in [
        (
            &[][..],
            "load case braking at bump = 0.3 m, steer = 0.34 m; axes of ",
        ),
        (
            &["--drive", "bump=0.02"],
            "load case braking at bump = 0.32 m, steer = 0.34 m; axes of ",
        ),
    ] {
        let (report, _) = report_and_table(&file, more);
        assert!(report.contains(expected), "{expected}: {report}");
    }
}

/// The drive that moves is named beside each force, the other one once above them all.
#[test]
fn over_a_grid_each_extreme_force_has_its_place() {
    let more = ["--drive", "bump=-0.05:0.04:5"];
    let (report, table) = report_and_table(&loaded(BRAKING), &more);
    let expected =
        "load case braking, least and greatest of 5 places with steer = 0.34 m; axes of ";
    assert!(report.contains(expected), "{report}");
    assert!(report.contains("least at"), "{report}");
    let found = extremes(&table, "braking_tie_rod_N", ["bump_m"]);
    assert_ne!(found[0], found[1]);
    let [least, greatest] = found.map(|[bump]| format!("bump = {} m", short(bump)));
    let expected = format!("{least}  {greatest}");
    assert!(
        line(&report, "tie_rod").ends_with(&expected),
        "{expected}: {report}"
    );
}

#[test]
fn over_a_grid_of_two_drives_extremes_name_both_values() {
    let more = [
        "--drive",
        "bump=-0.05:0.05:3",
        "--drive",
        "steer=-0.01:0.01:3",
    ];
    let (report, table) = report_and_table(&loaded(BRAKING), &more);
    let [least, _] = extremes(&table, "braking_tie_rod_N", ["bump_m", "steer_m"]);
    let [bump, steer] = least.map(short);
    let expected = format!("bump = {bump} m, steer = {steer} m  bump = ");
    assert!(
        line(&report, "tie_rod").contains(&expected),
        "{expected}: {report}"
    );
}

/// A force that is equal at all places has no place of an extreme.
#[test]
fn a_constant_force_has_no_place_of_its_extreme() {
    let file = loaded(&format!("{BRAKING}bump = \"damper\"\n"));
    let (report, _) = report_and_table(&file, &["--drive", "bump=-0.05:0.05:3"]);
    assert!(line(&report, "bump").ends_with("N"), "{report}");
}

#[test]
fn over_a_motion_each_extreme_force_has_its_time() {
    let motion = "time = { start = 0.0, stop = 1.0, step = 0.25 }";
    let file = loaded(BRAKING)
        .replace("time = { instants = [0.0] }", motion)
        .replace("bump = 0.3\n", "bump = [0.25, 0.10]\n");
    let (report, table) = report_and_table(&file, &["--motion"]);
    let found = extremes(&table, "braking_tie_rod_N", ["t_s", "bump_m"]);
    let found = found.map(|at| at.map(short));
    let [least, greatest] = found.map(|[t, bump]| format!("t = {t} s, bump = {bump} m"));
    let expected = format!("{least}  {greatest}");
    assert!(
        line(&report, "tie_rod").ends_with(&expected),
        "{expected}: {report}"
    );
}

/// A motion does not overwrite the table of a grid.
#[test]
fn tables_of_grids_and_motions_are_separate_files() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), loaded(BRAKING)).expect("written");
    let grid = ["loads", "a.toml", "--drive", "bump=-0.05:0.05:3"];
    for (options, name) in [
        (&grid[..], "a_loads.csv"),
        (&["loads", "a.toml", "--motion"], "a_loads_motion.csv"),
    ] {
        let output = run(folder.path(), options);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let (message, path) = (text(&output.stderr), Path::new("out").join(name));
        assert!(
            message.contains(&format!("wrote {}\n", path.display())),
            "{message}"
        );
    }
    let grid = std::fs::read(folder.path().join("out/a_loads.csv")).expect("a table");
    assert_eq!(rows(&grid).len(), 3);
}

#[test]
fn the_warning_near_a_lock_names_the_place() {
    let file = include_str!("../../../examples/attia2003.toml");
    let file = format!("{file}[loads.a]\np11 = [0.0, 0.0, 1000.0]\n");
    let more = ["--absolute", "--drive", "theta=1.57842626:2.17842626:4"];
    let (report, _) = report_and_table(&file, &more);
    let expected = "times the largest load, at theta = 2.17843 rad: the mechanism is near a position where it locks";
    assert!(report.contains(expected), "{report}");
}
