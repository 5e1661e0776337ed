//! A motion that ends before its last instant.

use crate::support::Reference;

use super::program::{edited, folder, rows, run, text};

const TWO_SECONDS: &str = "start = 0.0\nstop = 2.0\nstep = 0.05";

#[test]
fn where_the_mechanism_locks_the_rows_up_to_there_are_kept() {
    let folder = folder();
    let path = folder.path().join("two.toml");
    std::fs::write(path, edited("instants", TWO_SECONDS)).expect("written");
    let arguments = ["motion", "two.toml", "--csv", "two.csv", "--plots", "."];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr).lines().last().expect("a message");
    for expected in [
        "t = 2 s",
        "theta = 2.2",
        "1.97836776918",
        "2.17842626335",
        "`p",
        "locks",
        "40 rows",
    ] {
        // The limit is found to a few units of rounding times the conditioning there.
        let rounded_up = expected.replace("335", "336");
        let found = message.contains(expected) || message.contains(&rounded_up);
        assert!(found, "{expected} is not in: {message}");
    }
    let table = std::fs::read(folder.path().join("two.csv")).expect("a table");
    assert_eq!(table.last(), Some(&b'\n'));
    let table = rows(&table);
    assert_eq!(table.len(), 40);
    assert_eq!(table[39]["t_s"], 1.95);
    let last = Reference::load().rows.len() - 1;
    let difference = table[39]["p6_z"] - Reference::load().vector(last, "p6_").z;
    assert!(difference.abs() < 5e-15, "{difference:e}");
    for file in ["two_height.svg", "two_angles.svg"] {
        assert!(folder.path().join(file).exists());
    }
    let files = std::fs::read_dir(folder.path()).expect("a folder").count();
    assert_eq!(files, 4, "nothing temporary is left");
}

#[test]
fn a_first_instant_out_of_reach_is_the_solvers_failure() {
    let folder = folder();
    let path = folder.path().join("a.toml");
    std::fs::write(path, edited("theta = [", "theta = [2.2]")).expect("written");
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "a.csv"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    assert_eq!(message.lines().count(), 1);
    assert!(message.contains("theta = 2.17842"), "{message}");
}
