//! The list of assemblies.

mod complete;
mod parts;

use std::collections::BTreeMap;

use super::program::{example, folder, rows, run, text};

/// Returns the distance of two points.
fn length(row: &BTreeMap<String, f64>, [from, to]: &[String; 2]) -> f64 {
    let along =
        ["x", "y", "z"].map(|axis| row[&format!("{to}_{axis}")] - row[&format!("{from}_{axis}")]);
    along.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn the_assemblies_report_states_whether_the_list_is_complete() {
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
    assert!(
        report.contains("Only real assemblies can be built. The coordinates of a complex assembly are complex numbers"),
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
fn assemblies_of_nine_distances_include_mirrored_ones() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), example("attia2003.toml")).expect("written");
    let output = run(folder.path(), &["assemblies", "a.toml", "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let rows = rows(&output.stdout);
    let right = rows.iter().filter(|row| row["mirrored"] == 0.0).count();
    assert_eq!((rows.len(), right), (14, 4));
}

#[test]
fn a_drive_value_without_assembly_gives_exit_code_3() {
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
fn invalid_arguments_of_assemblies_are_refused() {
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
    let behind = run(folder.path(), &["assemblies", "--at", "1", "a.toml"]);
    assert_eq!(behind.status.code(), Some(2), "{behind:?}");
    let error = text(&behind.stderr);
    assert!(
        error.contains("the motion file stands before --at"),
        "{error}"
    );
    let unknown = ["assemblies", "a.toml", "--at", "1", "--drive", "bump"];
    let output = run(folder.path(), &unknown);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("unknown drive `bump`; known are theta"));
}

#[test]
fn assemblies_and_check_print_the_same_smallest_singular_value() {
    let folder = folder();
    let file = "linkage = \"trailing_arm\"\nunit = \"m\"\ntime = { instants = [0.0] }\ndrives = { bump = 0.29 }\n";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["assemblies", "a.toml", "--csv", "-"]);
    let smallest = rows(&output.stdout)[0]["smallest_singular_value"];
    let checked = run(folder.path(), &["check", "a.toml"]);
    let expected = format!("smallest singular value {smallest:.3}");
    let report = text(&checked.stdout);
    assert!(
        report.contains(expected.trim_end_matches('0')),
        "{expected}: {report}"
    );
}

/// Only the square of a length enters the equations.
#[test]
fn a_driven_length_below_zero_is_refused() {
    let folder = folder();
    let write = |design: &str| {
        let file = format!(
            "unit = \"m\"\nstatements = '''\nfixed: a at [0, 0, 0.5], b at [0.2, 0, 0.2], c at [0.2, 0.5, 0.2];\n\
             free: p at [0.5, 0.1, 0.7];\nhinge arm: b, c -> p;\ndrive ram: length(a -> p);\n'''\n{design}\
             [time]\ninstants = [0.0]\n[drives]\nram = 0.54\n"
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
    };
    let message = "the length from `a` to `p` cannot be less than zero";
    write("");
    let output = run(folder.path(), &["assemblies", "a.toml", "--at=-0.5"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = format!("--at -0.5: {message}; --at has the drive's own values\n");
    assert!(text(&output.stderr).ends_with(&expected), "{output:?}");
    write("[design]\nram = -0.5\n");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = format!("a.toml:9:7: {message}\n");
    assert!(text(&output.stderr).ends_with(&expected), "{output:?}");
}
