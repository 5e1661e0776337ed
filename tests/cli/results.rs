//! The results of a motion that runs to its end.

use super::program::{Rows, edited, example, folder, rows, run, text};
use crate::support::{self, Reference};

/// Returns the largest difference in a column of the reference.
fn tolerance(column: &str) -> f64 {
    match column.rsplit_once('_') {
        Some(("omega", _)) => 1e-11,
        Some(("alpha", _)) => 1e-9,
        Some((_, axis)) if axis.starts_with('v') => 1e-12,
        Some((_, axis)) if axis.starts_with('a') => 1e-10,
        _ => 5e-15,
    }
}

fn assert_meets_reference(ours: &Rows) {
    let reference = Reference::load();
    assert_eq!(ours.len(), reference.rows.len());
    for (ours, expected) in ours.iter().zip(&reference.rows) {
        for (column, expected) in expected {
            let difference = (ours[column] - expected).abs();
            assert!(
                difference <= tolerance(column),
                "{column} at t = {} s is off by {difference:.1e}",
                ours["t_s"]
            );
        }
    }
}

#[test]
fn the_run_without_arguments_prints_both_tables_and_writes_files() {
    let folder = folder();
    let output = run(folder.path(), &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let printed = text(&output.stdout);
    for expected in [
        "Table 2",
        "Point 10",
        "Table 3",
        "Angular acceleration",
        "-0.181*",
        "Misprints",
        "Largest differences",
        "Newton iterations",
        "Largest residual",
        "Time a step",
    ] {
        assert!(printed.contains(expected), "{expected}\n{printed}");
    }
    let widest = printed.lines().map(|line| line.chars().count()).max();
    assert!(widest <= Some(120), "{widest:?}");
    let csv = std::fs::read(folder.path().join("out/attia2003.csv")).expect("a table");
    assert_meets_reference(&rows(&csv));
    for plot in ["height", "angles"] {
        let path = folder.path().join(format!("out/attia2003_{plot}.svg"));
        let svg = std::fs::read_to_string(path).expect("a plot");
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        assert!(svg.contains("time t (s)"));
    }
}

#[test]
fn the_csv_begins_with_the_columns_of_the_reference() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "-"]);
    let header = text(&output.stdout).lines().next().expect("a header");
    let reference = include_str!("../data/attia2003_reference.csv");
    let expected = reference.lines().next().expect("a header");
    assert!(header.starts_with(expected), "{header}");
}

#[test]
fn measures_of_the_linkage_are_in_table_and_summary() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "-"]);
    let table = text(&output.stdout);
    let mut lines = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().expect("a header");
    let column = |name| header.iter().position(|column| *column == name);
    let [height, centre] = ["height_m", "p11_z"].map(|name| column(name).expect("a column"));
    for row in lines {
        assert_eq!(row[height], row[centre]);
    }
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert!(text(&output.stdout).contains("  height\n"));
}

#[test]
fn with_a_dash_only_the_table_is_on_standard_output() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(output.stderr.is_empty());
    assert_eq!(text(&output.stdout).lines().count(), 10);
    assert_meets_reference(&rows(&output.stdout));
}

#[test]
fn with_a_dash_pages_drawings_and_sources_are_on_standard_output() {
    let folder = folder();
    let file = example("double_wishbone_pushrod.toml");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let bake = ["bake", "a.toml", "--drive", "bump=0.28:0.32", "--as"];
    for (arguments, begins) in [
        (vec!["sheet", "a.toml", "--out", "-"], "<!DOCTYPE html>"),
        (vec!["draw", "a.toml", "--out", "-"], "<svg"),
        ([&bake[..], &["c", "--out", "-"]].concat(), "/*"),
        ([&bake[..], &["c", "--output", "-"]].concat(), "/*"),
    ] {
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let printed = text(&output.stdout);
        assert!(printed.starts_with(begins), "{printed}");
        assert!(!text(&output.stderr).contains("wrote"), "{output:?}");
        assert_eq!(folder.path().read_dir().expect("a folder").count(), 1);
    }
}

#[test]
fn motion_files_with_a_dot_in_the_name_have_separate_drawings() {
    let folder = folder();
    for name in ["corner.v1", "corner.v2"] {
        let file = format!("{name}.toml");
        let content = example("double_wishbone_pushrod.toml");
        std::fs::write(folder.path().join(&file), content).expect("written");
        let output = run(folder.path(), &["draw", &file]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let drawing = folder.path().join(format!("out/{name}.svg"));
        assert!(drawing.is_file(), "{output:?}");
    }
}

#[test]
fn motion_without_options_prints_a_summary() {
    let folder = folder();
    std::fs::write(folder.path().join("f.toml"), example("five_link.toml")).expect("written");
    let output = run(folder.path(), &["motion", "f.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let printed = text(&output.stdout);
    let expected = "\
        \x20      t    theta  centre x  centre y  centre z  kingpin   caster   camber      toe  height\n\
        \x20    (s)    (deg)      (mm)      (mm)      (mm)    (deg)    (deg)    (deg)    (deg)    (mm)\n";
    assert!(printed.contains(expected), "{printed}");
    for expected in ["five_link", "11 of 40 instants"] {
        assert!(printed.contains(expected), "{expected}\n{printed}");
    }
    let files = std::fs::read_dir(folder.path()).expect("a folder").count();
    assert_eq!(files, 1);
}

#[test]
fn the_summary_of_an_axle_fits_into_a_terminal() {
    let folder = folder();
    let file = example("front_and_rear_axle.toml");
    std::fs::write(folder.path().join("f.toml"), file).expect("written");
    let output = run(folder.path(), &["motion", "f.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let printed = text(&output.stdout);
    let widest = printed.lines().map(|line| line.chars().count()).max();
    assert!(widest.is_some_and(|widest| widest <= 120), "{printed}");
    let times = printed
        .lines()
        .filter(|line| line.starts_with("  0.0000  "));
    assert!(times.count() > 3, "{printed}");
}

/// A user who copies the example moves a point by a centimetre, and it runs.
#[test]
fn the_example_runs_with_any_hardpoint_moved_by_10_mm() {
    let folder = folder();
    let content = example("five_link.toml");
    let heights = |content: &str| {
        std::fs::write(folder.path().join("a.toml"), content).expect("written");
        let output = run(folder.path(), &["motion", "a.toml", "--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{content}\n{output:?}");
        assert!(output.stderr.is_empty(), "{output:?}");
        let rows = rows(&output.stdout);
        rows.iter()
            .map(|row| row["wheel_centre_z"])
            .collect::<Vec<_>>()
    };
    let as_shipped = heights(&content);
    let hardpoints = content
        .lines()
        .filter(|line| line.contains("ner = [") || line.contains("ter = ["));
    let mut moved = 0;
    for line in hardpoints {
        let (name, list) = line.split_once(" = ").expect("a point");
        let at: Vec<f64> = list
            .trim_matches(['[', ']'])
            .split(", ")
            .map(|number| number.parse().expect("a number"))
            .collect();
        for (axis, by) in [
            (0, 10.0),
            (1, 10.0),
            (2, 10.0),
            (0, -10.0),
            (1, -10.0),
            (2, -10.0),
        ] {
            let mut at = at.clone();
            at[axis] += by;
            let edited = content.replace(line, &format!("{name} = {at:?}"));
            assert_ne!(heights(&edited), as_shipped, "{name} by {by}");
            moved += 1;
        }
    }
    assert_eq!(moved, 60);
}

#[test]
fn distant_instants_in_any_order_stay_in_the_same_assembly() {
    let folder = folder();
    for instants in ["[1.95, 1.0, 0.0]", "[0.0, 1.95]", "[1.95, 0.0]", "[1.0]"] {
        let path = folder.path().join("a.toml");
        let line = format!("instants = {instants}");
        std::fs::write(path, edited("instants", &line)).expect("written");
        let output = run(folder.path(), &["motion", "a.toml", "--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{instants}: {output:?}");
        for row in rows(&output.stdout) {
            let instant = support::INSTANTS.iter().position(|t| *t == row["t_s"]);
            let expected = &Reference::load().rows[instant.expect("an instant of the paper")];
            for column in ["p6_x", "p8_y", "p10_z"] {
                let difference = (row[column] - expected[column]).abs();
                assert!(difference < 5e-15, "{instants}: {column} {difference:e}");
            }
        }
    }
}

#[test]
fn five_link_in_millimetres_moves_like_attia2003_in_metres() {
    let folder = folder();
    let write = |name: &str, content: String| {
        std::fs::write(folder.path().join(name), content).expect("written");
        rows(&run(folder.path(), &["motion", name, "--csv", "-"]).stdout)
    };
    let metres = write(
        "m.toml",
        edited("instants", "start = 0.0\nstop = 1.95\nstep = 0.05"),
    );
    let millimetres = write("mm.toml", example("published_five_link.toml"));
    assert_eq!((metres.len(), millimetres.len()), (40, 40));
    for (m, mm) in metres.iter().zip(&millimetres) {
        for (long, short) in support::FIVE_LINK_NAMES.iter().skip(5) {
            for column in ["x", "y", "z", "vx", "az"] {
                let expected = 1e3 * m[&format!("{short}_{column}")];
                let difference = mm[&format!("{long}_{column}")] - expected;
                let scale = 1e3 + expected.abs();
                assert!(
                    difference.abs() < 1e-11 * scale,
                    "{long}_{column} {difference:e}"
                );
            }
        }
        for column in ["omega_x", "alpha_z", "camber_rad", "kingpin_rad", "toe_rad"] {
            let difference = (m[column] - mm[column]).abs();
            assert!(difference < 1e-10 * (1.0 + m[column].abs()), "{column}");
        }
    }
}
