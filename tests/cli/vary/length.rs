//! The length of a link, and a move of `[tune]`.

use std::collections::BTreeMap;

use super::super::program::{CORNER, folder, run, text};
use super::{Name, compare_with_sweep, corner, varied};

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

/// The shim moves both points of the arm across, and one of them moves upwards too.
#[test]
fn a_move_is_added_to_coordinates_of_its_points() {
    let shim = "[tune.moves.shim]\npoints = [\"upper_front\", \"upper_rear\"]\nalong = \"y\"\nby = [-0.01, 0.01]\n\
                [tune.targets.toe]\nof = \"toe\"\nvalue = 0.0\nwithin = 0.1\n";
    let plain = format!("angle = \"deg\"\n{CORNER}");
    let file = |points: &str| format!("{plain}[points]\n{points}");
    let moved = "upper_front = [0.15, 0.424, 0.424]\nupper_rear = [-0.15, 0.424, 0.42]\n";
    let twice = "upper_front = [0.15, 0.428, 0.42]\nupper_rear = [-0.15, 0.424, 0.42]\n";
    for (words, points) in [("shim,upper_front.z", moved), ("upper_front.y,shim", twice)] {
        let (_, numbers) = varied(&format!("{plain}{shim}"), &format!("{words}=0.004")).remove(1);
        assert!(compare_with_sweep(&numbers, &file(points), "bump") > 80);
    }
}
