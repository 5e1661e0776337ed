//! Rows as JSON, compared with those of CSV files.

use serde_json::Value;

use super::program::{CORNER, folder, rows, run, text};

#[test]
fn json_has_the_csv_rows_and_a_header_with_units_and_axes() {
    let folder = folder();
    let moving = CORNER.replace("bump = 0.3", "bump = [0.3, 0.05]");
    let moving = moving.replace("[0.0]", "[0.0, 0.5, 1.0]");
    std::fs::write(folder.path().join("a.toml"), moving).expect("written");
    for command in [
        &["motion", "a.toml"][..],
        &["sweep", "a.toml", "--drive", "bump=-0.05:0.05:3"],
        // Beyond the lock there are no rows, before it all have their derivatives.
        &[
            "sweep",
            "a.toml",
            "--drive",
            "bump=-0.2:0.2:9",
            "--derivatives",
            "2",
        ],
    ] {
        let arguments = [command, &["--csv", "a.csv", "--json", "out/a.json"]].concat();
        let output = run(folder.path(), &arguments);
        assert!(
            text(&output.stderr).contains("wrote out/a.json"),
            "{output:?}"
        );
        let read = |name: &str| std::fs::read(folder.path().join(name)).expect("a file");
        let json: Value = serde_json::from_slice(&read("out/a.json")).expect("JSON");
        let header = &json["header"];
        assert_eq!(header["linkage"], "double_wishbone_pushrod");
        assert_eq!(
            (&header["length"], &header["angle"]),
            (&Value::from("m"), &Value::from("rad"))
        );
        assert_eq!(header["axes"], "ISO 8855: x forward, y left, z up");
        let expected = rows(&read("a.csv"));
        let found = json["rows"].as_array().expect("rows");
        assert_eq!(found.len(), expected.len());
        assert!(found.len() > 2);
        for (found, expected) in found.iter().zip(&expected) {
            let found = found.as_object().expect("an object");
            assert_eq!(found.len(), expected.len());
            for (name, value) in expected {
                // NaN is null; this JSON reader may round the last digit differently.
                let same = found[name].as_f64().map_or(value.is_nan(), |other| {
                    (other - value).abs() <= 4e-16 * value.abs()
                });
                assert!(same, "{name}: {} is not {value}", found[name]);
            }
        }
    }
}

/// Programs that compare texts would report a difference between equal numbers.
#[test]
fn zero_is_written_without_sign_in_csv_and_json() {
    let content = CORNER.replace("double_wishbone_pushrod", "trailing_arm");
    let content = content
        .replace("steer = 0.34\n", "")
        .replace("0.3\n", "0.29\n");
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), content).expect("written");
    for form in ["--csv", "--json"] {
        let output = run(folder.path(), &["motion", "a.toml", form, "-"]);
        let table = text(&output.stdout);
        let mut numbers = table.split([',', ':', '}', '\n']);
        assert!(numbers.clone().any(|number| number == "0.0"), "{output:?}");
        assert!(!numbers.any(|number| number == "-0.0"), "{table}");
    }
}

#[test]
fn json_is_written_to_standard_output_or_its_own_file() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let sweep = ["sweep", "a.toml", "--drive", "bump=0", "--json", "-"];
    let output = run(folder.path(), &sweep);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let json: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(json["rows"][0]["bump_m"], 0.3);
    assert!(!folder.path().join("out").exists());
    for (csv, json, expected) in [
        (
            "-",
            "a.toml",
            "a.toml: this is the file that is read, which --json would overwrite",
        ),
        ("-", "-", "--csv and --json name the same place"),
        (
            "all.csv",
            "./all.csv",
            "--csv and --json name the same place",
        ),
    ] {
        let output = run(
            folder.path(),
            &["motion", "a.toml", "--csv", csv, "--json", json],
        );
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(text(&output.stderr).contains(expected), "{output:?}");
    }
}

/// Before anything is solved.
#[test]
#[cfg(not(feature = "parquet"))]
fn parquet_is_refused_by_a_program_built_without_parquet() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    for arguments in [
        &["motion", "a.toml"][..],
        &["sweep", "a.toml", "--drive", "bump=0"],
    ] {
        let output = run(
            folder.path(),
            &[arguments, &["--parquet", "a.parquet"]].concat(),
        );
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert_eq!(
            text(&output.stderr),
            "this program is built without Parquet; build it with: cargo build --release --features parquet\n"
        );
    }
}
