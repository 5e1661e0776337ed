//! A suspension beside a table of measured numbers.

mod mistakes;
mod noise;
mod opposite;
mod several;

use std::process::Output;

use super::super::program::{CORNER, folder, run, text};
use super::drives::led_by;
use super::{arm, rows};

pub(super) fn beside(model: &str, table: &str, options: &[&str]) -> (tempfile::TempDir, Output) {
    let folder = folder();
    for (name, content) in [("a.toml", model), ("m.csv", table)] {
        std::fs::write(folder.path().join(name), content).expect("written");
    }
    let output = run(
        folder.path(),
        &[&["compare", "a.toml", "m.csv"], options].concat(),
    );
    (folder, output)
}

/// The spring of `arm`, upright 0.4 m above the tip, which goes up by z on a circle of 0.5 m.
fn spring(z: f64) -> f64 {
    (0.5 - (0.25 - z * z).sqrt()).hypot(0.4 - z)
}

/// Places in mm, unevenly spaced and in no order, with known differences of the spring in mm. The rig measures 0 twice.
const MEASURED: [[f64; 2]; 6] = [
    [120.0, 2.5],
    [0.0, 2.2],
    [-35.5, 1.0],
    [80.0, 2.0],
    [0.0, 1.8],
    [-150.0, 2.0],
];

/// The table of a closed form with known differences, as a spreadsheet in Germany writes it; a column without a heading.
fn table() -> String {
    let line = |[at, off]: &[f64; 2]| {
        let spring = 1000.0 * spring(at / 1000.0) + off;
        format!("\"{spring:?}\";left;{at:?}\r\n").replace('.', ",")
    };
    let lines: String = MEASURED.iter().map(line).collect();
    format!("\u{feff}Spring [mm];;bump (mm)\r\n\r\n{lines}")
}

#[test]
fn known_differences_from_a_closed_form_are_found() {
    let (_folder, output) = beside(&arm("m", 1.0, 0.4), &table(), &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let found = rows(&output);
    let [whole, offset, rest] = &found[..] else {
        panic!("{found:?}")
    };
    let is_near = |a: f64, b: f64| (a - b).abs() < 1e-9;
    for (row, of, at, off) in [
        (whole, "as measured", 120.0, 2.5),
        (offset, "offset", 0.0, 2.0),
        (rest, "without offset", -35.5, -1.0),
    ] {
        let (names, [told, a, b, difference]) = row;
        assert_eq!(names[..], [of, "spring", "mm"].map(str::to_owned));
        assert_eq!(*told, at, "{of}");
        assert!(is_near(*a, 1000.0 * spring(at / 1000.0)), "{of}: {a}");
        assert!(is_near(*difference, off) && is_near(b - a, off), "{row:?}");
    }
    let (_folder, output) = beside(&arm("m", 1.0, 0.4), &table(), &["--json", "-"]);
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let squares = |from: f64| MEASURED.map(|[_, off]| (off - from).powi(2));
    for (row, squares) in [(0, squares(0.0)), (2, squares(2.0))] {
        let row = &json["rows"][row];
        let rms = (squares.iter().sum::<f64>() / 6.0).sqrt();
        assert!(
            is_near(row["rms"].as_f64().expect("a number"), rms),
            "{row}"
        );
        assert_eq!(row["along"], "change of bump (mm)");
    }
    assert_eq!(json["header"]["b"], "m.csv");
}

#[test]
fn the_report_of_the_example_is_that_of_its_page() {
    let model = "examples/double_wishbone_pushrod.toml";
    let table = "examples/double_wishbone_measured.csv";
    let output = run(
        env!("CARGO_MANIFEST_DIR").as_ref(),
        &["compare", model, table],
    );
    let report = text(&output.stdout);
    let page = include_str!("../../../docs/measured.md");
    let shown = page.split("```text\n").nth(1).expect("a report");
    let shown = shown.split("```").next().expect("an end");
    assert!(report.contains(shown), "{report}");
}

#[test]
fn the_page_has_marks_over_the_curve_of_the_model() {
    let (folder, output) = beside(&arm("m", 1.0, 0.4), &table(), &["--html", "c.html"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    assert!(report.contains("B  m.csv (6 measured places)"), "{report}");
    let page = std::fs::read_to_string(folder.path().join("c.html")).expect("a page");
    // As measured and without the offset, each with a mark in the legend.
    assert_eq!(page.matches("<circle").count(), 2 * (6 + 1));
    assert!(page.contains("\nwithout offset\n</text>"), "{page}");
    let level = "bump [mm],spring [mm]\n0,400\n";
    let (folder, _) = beside(&arm("m", 1.0, 0.4), level, &["--html", "c.html"]);
    let page = std::fs::read_to_string(folder.path().join("c.html")).expect("a page");
    assert!(!page.contains("\nwithout offset\n</text>"), "{page}");
}

/// The only place of the model is a mark, too: it has no curve.
#[test]
fn a_table_of_one_place_has_a_mark_of_the_model() {
    let table = "bump [mm],spring [mm]\n20,400\n20,400\n";
    let (folder, output) = beside(&arm("m", 1.0, 0.4), table, &["--html", "c.html"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = std::fs::read_to_string(folder.path().join("c.html")).expect("a page");
    // The model and the two lines, with two marks in the legend.
    assert_eq!(page.matches("<circle").count(), (1 + 2) + 2);
}

/// The largest difference is at the second of 4001 places, of which the first and each third behind it are drawn.
#[test]
fn a_chart_of_many_places_is_thinned_and_says_so() {
    let line = |line: i32| {
        let at = f64::from(line) * 0.01;
        let off = if line == 1 { 5.0 } else { 1.0 };
        format!("{at:?},{:?}\n", 1000.0 * spring(at / 1000.0) + off)
    };
    let lines: String = (0..4001).map(line).collect();
    let table = format!("bump [mm],spring [mm]\n{lines}");
    let (folder, output) = beside(&arm("m", 1.0, 0.4), &table, &["--html", "c.html"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = std::fs::read_to_string(folder.path().join("c.html")).expect("a page");
    assert!(page.contains("1 of 3 measured places is drawn, and that of the largest difference"));
    assert_eq!(page.matches("<circle").count(), 2 * (1334 + 1 + 1));
}

#[test]
fn coordinates_of_points_have_their_axes_in_names() {
    let table = "bump [mm],lower_ball_y,Lower_ball z [m]\n0,0.7,0.17\n";
    let (_folder, output) = beside(CORNER, table, &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let found = rows(&output);
    let named: Vec<&str> = found[..2]
        .iter()
        .map(|(names, _)| names[1].as_str())
        .collect();
    assert_eq!(named, ["lower_ball y", "lower_ball z"]);
    let (_folder, output) = beside(CORNER, "bump [mm],lower_ball [m]\n0,0.7\n", &[]);
    let expected = "m.csv:1:11: unknown quantity `lower_ball`";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
}

/// The same arm, led by the wheel's height, by its negative, and by the damper, at the same wheel travel.
#[test]
fn wheel_travel_leads_the_model_whatever_its_drive() {
    let of_height = folder();
    std::fs::write(
        of_height.path().join("a.toml"),
        led_by("wheel_centre.z", 301.0),
    )
    .expect("written");
    let sweep = [
        "sweep",
        "a.toml",
        "--drive",
        "bump=-60:40:5",
        "--derivatives",
        "0",
        "--csv",
        "-",
    ];
    let output = run(of_height.path(), &sweep);
    let table = text(&output.stdout).replacen("bump_mm", "", 1);
    for (drive, value) in [
        ("-1 wheel_centre.z", -301.0),
        ("length(low -> top)", 451.691_266_242_773_4),
    ] {
        let (_folder, output) = beside(&led_by(drive, value), &table, &["--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{drive}: {output:?}");
        let found = rows(&output);
        let has = |quantity: &str| found.iter().any(|(names, _)| names[1] == quantity);
        assert!(has("camber angle") && has("damper") && !has("wheel travel"));
        for (names, [.., difference]) in &found {
            assert!(difference.abs() < 1e-7, "{drive}: {names:?} {difference}");
        }
    }
}

/// In roll one wheel rises as far as the other falls.
#[test]
fn drives_that_move_together_are_one_column() {
    let axle = CORNER
        .replace("double_wishbone_pushrod", "steered_axle")
        .replace("bump = 0.3", "bump_left = 0.3\nbump_right = 0.3");
    let table = "\"bump_left,-bump_right [mm]\",left wheel travel [mm],right_wheel_travel_in\n0,0,0\n25.4,25.4,-1\n";
    let (_folder, output) = beside(&axle, table, &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let found = rows(&output);
    assert_eq!(found.len(), 6, "{output:?}");
    for (names, [.., difference]) in &found {
        assert!(difference.abs() < 1e-9, "{names:?} {difference}");
    }
    let travel = "wheel travel [mm],left toe [deg]\n0,0\n";
    let (_folder, output) = beside(&axle, travel, &[]);
    let expected = "m.csv:1:1: unknown quantity `wheel travel`; did you mean `left_wheel_travel` or `right_wheel_travel`?";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
}

/// Rigs write a line on the test above the headings, and spreadsheets a separator for each column behind it.
#[test]
fn titles_above_the_headings_are_left_out() {
    let report = |table: &str| {
        let (_folder, output) = beside(&arm("m", 1.0, 0.4), table, &[]);
        assert_eq!(output.status.code(), Some(0), "{table}{output:?}");
        text(&output.stdout).to_owned()
    };
    let plain = report(&table());
    for titles in [
        "Rig 17\r\n\r\n",
        "\"Rig; 17\";;\r\n2024-03-12;\r\n",
        "Rig 17, arm;;\r\n",
    ] {
        let titled = table().replace("Spring", &format!("{titles}Spring"));
        assert_eq!(report(&titled), plain, "{titles}");
    }
}

#[test]
fn signs_for_thousands_beside_decimals_change_nothing() {
    let said = |[first, second, third]: [&str; 3]| {
        let table = format!("bump (mm)\tspring (mm)\n-20\t{first}\n0\t{second}\n20\t{third}\n");
        let (_folder, output) = beside(&arm("m", 1.0, 0.4), &table, &[]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        text(&output.stdout).to_owned()
    };
    let plain = said(["1500", "1490.5", "1480"]);
    assert_eq!(said(["1,500", "1,490.5", "1,480"]), plain);
    assert_eq!(said(["1,500", "1490.5", "1480"]), plain);
    assert_eq!(said(["1.500", "1490,5", "1480"]), plain);
}
