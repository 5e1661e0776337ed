//! The length of a link, and a move of `[tune]`.

use std::collections::BTreeMap;

use super::super::program::{folder, run, text};
use super::{Name, corner, varied};

/// `tune` finds the change that gives the same toe.
#[test]
fn a_varied_length_is_the_one_that_tune_finds() {
    let plain = corner("");
    let shortest = varied(&plain, "tie_rod=-0.001:0.001:3").remove(0);
    assert_eq!(shortest.0, -0.001);
    let folder = folder();
    let toe = |numbers: &BTreeMap<Name, (f64, String)>| {
        numbers[&("toe".to_owned(), "design".to_owned())].0
    };
    let tuned = format!(
        "{plain}[tune.moves.rod]\nlength = \"tie_rod\"\nby = [-0.002, 0.002]\n[tune.targets.toe]\nof = \"toe\"\nvalue = {:?}\n\
         within = 1e-9\n",
        toe(&shortest.1)
    );
    std::fs::write(folder.path().join("t.toml"), &tuned).expect("written");
    let output = run(folder.path(), &["tune", "t.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    let line = report.lines().find(|line| line.contains("rod"));
    let words: Vec<&str> = line.expect("the move").split_whitespace().collect();
    let by: f64 = words[1].parse().expect("a number");
    assert!((by + 0.001).abs() < 1e-6, "{report}");
    // A move of [tune] has its own name.
    let by_move = varied(&tuned, "rod=-0.001").remove(0);
    assert_eq!(toe(&by_move.1), toe(&shortest.1));
}
