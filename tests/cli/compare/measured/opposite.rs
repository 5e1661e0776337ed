//! Tables with another sign, or places counted the other way.

use super::super::super::program::{CORNER, folder, rows, run, text};
use super::beside;

/// The notes of a comparison of a model with its own toe and camber, with an offset and noise; `signs` are those of bump, toe and
/// camber in the table.
fn notes([way, of_toe, of_camber]: [f64; 3], noise: f64) -> Vec<String> {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let arguments = [
        "sweep",
        "a.toml",
        "--drive",
        "bump=-0.06:0.06:13",
        "--csv",
        "-",
    ];
    let output = run(folder.path(), &arguments);
    let line = |(number, row): (usize, _)| {
        let row: &std::collections::BTreeMap<String, f64> = row;
        let noise = noise * (17.0 * number as f64).sin();
        format!(
            "{},{},{}\n",
            way * (row["bump_m"] - 0.3),
            of_toe * row["toe_rad"] + 0.002 + noise,
            of_camber * row["camber_rad"] - 0.03 - noise
        )
    };
    let lines: String = rows(&output.stdout).iter().enumerate().map(line).collect();
    let table = format!("bump [m],toe [rad],camber [rad]\n{lines}");
    let (_folder, output) = beside(CORNER, &table, &[]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let notes = text(&output.stdout).lines().skip(2);
    let notes = notes.take_while(|line| !line.is_empty());
    notes.map(str::to_owned).collect()
}

#[test]
fn another_sign_and_another_way_of_counting_are_noted() {
    let camber =
        "camber angle of B changes the opposite way to that of A: is its sign the other one?";
    let way = "B seems to count bump the other way: its quantities change as those of A do at the opposite places";
    for (signs, expected) in [
        ([1.0, 1.0, 1.0], &[][..]),
        ([1.0, 1.0, -1.0], &[camber]),
        ([-1.0, 1.0, 1.0], &[way]),
        // Neither the model's slope nor its opposite.
        ([1.0, 1.0, 0.0], &[]),
    ] {
        assert_eq!(notes(signs, 2e-4), expected, "{signs:?}");
    }
}

/// A rig states the travel of both wheels.
#[test]
fn all_columns_that_count_the_other_way_are_named() {
    let folder = folder();
    let axle = include_str!("../../../../examples/live_axle_watt.toml");
    std::fs::write(folder.path().join("a.toml"), axle).expect("written");
    let heave = "bump_left,bump_right=-0.06:0.06:13";
    let arguments = ["sweep", "a.toml", "--drive", heave, "--csv", "-"];
    let output = run(folder.path(), &arguments);
    let line = |row: &std::collections::BTreeMap<String, f64>| {
        let fall = 0.31 - row["bump_left_m"];
        let [recession, damper] = ["left_recession_m", "damper_left_m"].map(|name| row[name]);
        format!("{fall},{fall},{recession},{damper}\n")
    };
    let lines: String = rows(&output.stdout).iter().map(line).collect();
    let table = format!(
        "left wheel travel [m],right wheel travel [m],left recession [m],damper left [m]\n{lines}"
    );
    let (_folder, output) = beside(axle, &table, &[]);
    let note = "B seems to count left wheel travel and right wheel travel the other way: ";
    assert!(text(&output.stdout).contains(note), "{output:?}");
}

/// The wheel leans outwards by 0.011 deg per mm here, inwards in the model.
#[test]
fn changes_that_rigs_do_not_resolve_are_not_noted() {
    let notes = |step: f64| {
        let line = |at: i32| {
            let at = step * f64::from(at);
            format!("{at},{}\n", 0.011 * at)
        };
        let lines: String = (-5..6).map(line).collect();
        let table = format!("bump [mm],camber [deg]\n{lines}");
        let (_folder, output) = beside(CORNER, &table, &[]);
        text(&output.stdout).to_owned()
    };
    let expected = "camber angle of B changes the opposite way to that of A: is its sign, or that of bump, the other one?";
    assert!(notes(4.0).contains(expected), "{}", notes(4.0));
    assert!(!notes(0.1).contains("opposite"));
}
