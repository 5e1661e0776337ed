//! A hardpoint or a length over a range of values.

mod axle;
#[cfg(unix)]
mod interrupted;
mod length;
mod page;
mod refused;

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Output;

use super::program::{CORNER, Rows, folder, run, table, text};

/// Arms that are not parallel in the side view: the instant centre there is not far away.
fn corner(points: &str) -> String {
    format!("angle = \"deg\"\n{CORNER}[points]\nupper_rear = [-0.15, 0.42, 0.36]\n{points}")
}

/// An arm that turns about a line along x, led by the length of its damper, with a line on the vehicle.
fn arm(vehicle: &str) -> String {
    format!(
        "unit = \"m\"\ntime = {{ instants = [0.0] }}\ndrives = {{ damper = 0.4 }}\n{vehicle}\
             statements = \"\"\"\nfixed: front at [0.2, 0.0, 0.0], rear at [-0.2, 0.0, 0.0], top at [0.0, 0.3, 0.4];\n\
             free: tip at [0.0, 0.5, 0.0];\nhinge arm: front, rear -> tip;\npoint hub: arm at [0.0, 0.4, 0.0];\n\
             wheel: hub -> tip;\ndrive damper: length(top -> tip);\n\"\"\"\n"
    )
}

/// Runs the command on a file `a.toml`.
fn vary(folder: &Path, file: &str, arguments: &[&str]) -> Output {
    std::fs::write(folder.join("a.toml"), file).expect("written");
    run(folder, &[&["vary", "a.toml"], arguments].concat())
}

/// A quantity, and whether it is `design` or a derivative.
type Name = (String, String);

/// The table: for each value, in its order, the number and the unit of each quantity.
type Table = Vec<(f64, BTreeMap<Name, (f64, String)>)>;

fn parsed(csv_text: &[u8]) -> Table {
    let mut reader = csv::Reader::from_reader(csv_text);
    let names = reader.headers().expect("headings").clone();
    assert_eq!(names, vec!["value", "of", "quantity", "unit", "number"]);
    let mut table = Table::new();
    for record in reader.records() {
        let record = record.expect("a row");
        let value: f64 = record[0].parse().expect("a number");
        if table.last().is_none_or(|(last, _)| *last != value) {
            table.push((value, BTreeMap::new()));
        }
        let name = (record[2].to_owned(), record[1].to_owned());
        let number = record[4].parse().unwrap_or(f64::NAN);
        let (_, row) = table.last_mut().expect("a value");
        row.insert(name, (number, record[3].to_owned()));
    }
    table
}

#[track_caller]
fn varied(file: &str, words: &str) -> Table {
    let folder = folder();
    let output = vary(folder.path(), file, &[words, "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    parsed(&output.stdout)
}

/// Compares the numbers at a value with the design position of another file, by `sweep`; returns how many there are.
#[track_caller]
fn compare_with_sweep(numbers: &BTreeMap<Name, (f64, String)>, file: &str, drive: &str) -> usize {
    let swept: Rows = table(file, &["sweep", "--drive", &format!("{drive}=0")]);
    let mut compared = 0;
    for ((quantity, of), (number, unit)) in numbers {
        let unit = unit.split('/').next().unwrap_or_default();
        let per = of.strip_prefix("per ").map(|drive| format!("_per_{drive}"));
        let per = per.unwrap_or_default();
        let named = [
            format!("{quantity}{per}"),
            format!("{quantity}_{unit}{per}"),
        ];
        let Some(expected) = named.iter().find_map(|name| swept[0].get(name)) else {
            continue;
        };
        if expected.is_nan() && number.is_nan() {
            continue;
        }
        let off = (number - expected).abs() / expected.abs().max(1.0);
        assert!(off < 1e-9, "{quantity} {of}: {number} is not {expected}");
        compared += 1;
    }
    compared
}

/// The file with the hardpoint written in it by hand has the same numbers.
#[test]
fn a_varied_hardpoint_is_that_of_a_file_with_the_hardpoint_moved() {
    let table = varied(&corner(""), "rack.z=-0.006:0.006:5");
    let values: Vec<f64> = table.iter().map(|(value, _)| *value).collect();
    assert_eq!(values, [-0.006, -0.003, 0.0, 0.003, 0.006]);
    for (value, numbers) in &table {
        let file = corner(&format!("rack = [0.11, 0.34, {}]\n", 0.2 + value));
        let compared = compare_with_sweep(numbers, &file, "bump");
        assert!(compared > 80, "{compared}");
    }
}

/// A corner in millimetres and the axes of Adams.
const STATEMENTS: &str = "statements = \"\"\"\n\
    fixed: fore at [-200.0, -350.0, 160.0], aft at [200.0, -350.0, 150.0], up_fore at [-150.0, -420.0, 420.0],\n\
    up_aft at [150.0, -420.0, 410.0], rack at [-110.0, -340.0, 200.0];\n\
    free: ball at [-5.0, -700.0, 170.0], top at [15.0, -660.0, 440.0], tie at [-120.0, -680.0, 210.0],\n\
    hub at [0.0, -750.0, 300.0];\n\
    link a: fore -> ball; link b: aft -> ball; link c: up_fore -> top; link d: up_aft -> top; link tie_rod: rack -> tie;\n\
    body upright: ball, top, tie, hub; point marker: upright at [-5.0, -690.0, 170.0];\n\
    point axle: upright at [0.0, -650.0, 300.0];\n\
    drive bump: hub.z; wheel: axle -> hub; kingpin: ball -> top;\n\
    measure reach: length(marker -> rack);\n\"\"\"\n";

/// The file is in millimetres, and x and y point rearwards and to the right. The marker follows its point.
#[test]
fn values_are_in_the_unit_and_axes_of_the_file() {
    let file = |ball: f64| {
        format!(
            "unit = \"mm\"\nangle = \"deg\"\naxes = \"Adams\"\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 300.0 }}\n\
             vehicle = {{ wheel_radius = 300.0 }}\n{STATEMENTS}[points]\nball = [{ball:?}, -700.0, 170.0]\n\
             marker = {{ from = \"ball\", offset = [0.0, 10.0, 0.0] }}\n"
        )
    };
    let table = varied(&file(-5.0), "ball.x=2:-2:3");
    for ((value, numbers), expected) in table.iter().zip([2.0, 0.0, -2.0]) {
        assert_eq!(*value, expected);
        let compared = compare_with_sweep(numbers, &file(-5.0 + value), "bump");
        assert!(compared > 40, "{compared}");
        assert!(numbers.contains_key(&("reach".to_owned(), "design".to_owned())));
    }
}

#[test]
fn differences_of_small_changes_are_the_sensitivities() {
    const STEP: f64 = 1e-5;
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), corner("")).expect("written");
    for (name, row) in [
        ("rack.z", "rack.z"),
        ("lower_ball.y", "lower_ball.y"),
        ("tie_rod", "length tie_rod"),
    ] {
        let output = run(folder.path(), &["sensitivities", "a.toml", "--csv", "-"]);
        let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
        let headings = reader.headers().expect("headings").clone();
        let mut records = reader.records().map(|record| record.expect("a row"));
        let record = records.find(|record| &record[0] == row).expect("a row");
        let table = varied(&corner(""), &format!("{name}={:?}:{STEP:?}:3", -STEP));
        let of = |place: usize, quantity: &str, of: &str| {
            table[place].1[&(quantity.to_owned(), of.to_owned())].0
        };
        for (quantity, per, column) in [
            ("toe", "design", "toe_deg"),
            ("toe", "per bump", "toe_deg_per_bump"),
            ("camber", "per steer", "camber_deg_per_steer"),
            ("roll_centre", "design", "roll_centre_m"),
            ("roll_centre", "per bump", "roll_centre_m_per_bump"),
            ("damper", "per bump", "damper_m_per_bump"),
        ] {
            let slope = (of(2, quantity, per) - of(0, quantity, per)) / (2.0 * STEP);
            let place = headings.iter().position(|heading| heading == column);
            let place = place.unwrap_or_else(|| panic!("no {column}"));
            let expected: f64 = record[place].parse().expect("a number");
            let off = (slope - expected).abs() / expected.abs().max(1.0);
            assert!(
                off < 1e-5,
                "{name}: {quantity} {per}: {slope} is not {expected}"
            );
        }
    }
}

#[test]
fn prints_a_row_for_each_quantity_and_a_column_for_each_value() {
    let folder = folder();
    let output = vary(
        folder.path(),
        &corner(""),
        &["rack.z=0.002:0.004:2", "--of", "toe"],
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let printed = text(&output.stdout);
    let lines: Vec<Vec<&str>> = printed
        .lines()
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(
        printed.lines().next(),
        Some(
            "a.toml: change of rack.z from the design, in m; axes of ISO 8855: x forward, y left, z up"
        )
    );
    assert_eq!(lines[2], ["quantity", "design", "0.002", "0.004"]);
    assert_eq!(lines[3][..2], ["toe", "(deg)"]);
    assert_eq!(lines[4][..4], ["toe", "per", "bump", "(deg/m)"]);
    assert_eq!(lines[5][..4], ["toe", "per", "steer", "(deg/m)"]);
    assert_eq!(lines.len(), 6);
}

/// The rack is on neither the kingpin nor a wishbone.
#[test]
fn quantities_that_no_value_changes_are_named_below_the_table() {
    let folder = folder();
    let output = vary(folder.path(), &corner(""), &["rack.z=-0.002:0.002:3"]);
    let printed = text(&output.stdout);
    let (table, alike) = printed
        .split_once("\nAlike for all values: ")
        .expect("both");
    assert!(table.contains("\n  toe per bump (deg/m)") && !table.contains("caster (deg)"));
    assert!(
        alike
            .split(", ")
            .any(|name| name.starts_with("caster ") && name.ends_with(" deg")),
        "{alike}"
    );
    let asked = ["rack.z=-0.002:0.002:3", "--of", "caster"];
    let output = vary(folder.path(), &corner(""), &asked);
    let printed = text(&output.stdout);
    assert!(printed.contains("\n  caster (deg)") && !printed.contains("Alike"));
}

#[test]
fn json_has_a_header_and_the_rows_of_csv() {
    let folder = folder();
    let arguments = [
        "rack.z=0.002",
        "--of",
        "toe",
        "--json",
        "a.json",
        "--csv",
        "a.csv",
    ];
    let output = vary(folder.path(), &corner(""), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let json = std::fs::read(folder.path().join("a.json")).expect("a file");
    let json: serde_json::Value = serde_json::from_slice(&json).expect("JSON");
    for (name, expected) in [
        ("file", "a.toml"),
        ("varied", "rack.z"),
        ("unit", "m"),
        ("axes", "ISO 8855"),
    ] {
        assert_eq!(json["header"][name], expected);
    }
    let csv = std::fs::read(folder.path().join("a.csv")).expect("a file");
    let rows: usize = parsed(&csv).iter().map(|(_, row)| row.len()).sum();
    assert_eq!(json["rows"].as_array().map(Vec::len), Some(rows));
    assert_eq!(rows, 6);
}

#[test]
fn a_falling_range_has_its_columns_in_that_order() {
    let values: Vec<f64> = varied(&corner(""), "rack.z=0.002:-0.001:2")
        .iter()
        .map(|(value, _)| *value)
        .collect();
    assert_eq!(values, [0.002, 0.0, -0.001]);
}
