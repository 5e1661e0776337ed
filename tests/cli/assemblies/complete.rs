//! Lists of assemblies that are complete, or say that they may not be.

use std::collections::BTreeSet;

use super::length;
use crate::program::{folder, rows, run, text};

/// Where the curve of the wheel tends to infinity along planes of the drive's coordinate, a general plane intersects it;
/// where roots tend to infinity as lengths become the mechanism's, they are distinguished from lost ones.
#[test]
fn the_list_of_assemblies_of_a_layout_is_complete() {
    let folder = folder();
    for (file, tally) in [
        (
            include_str!("../../../examples/double_wishbone_pushrod.toml"),
            "\n24 real assemblies, put together part by part, in 3 parts:\n",
        ),
        (
            include_str!("../../../examples/macpherson.toml"),
            "8 real and 12 complex assemblies, 4 at infinity, 0 not",
        ),
    ] {
        std::fs::write(folder.path().join("layout.toml"), file).expect("written");
        let output = run(folder.path(), &["assemblies", "layout.toml"]);
        let listed = text(&output.stdout);
        assert!(
            listed.contains("The list is complete by all that was tried:"),
            "{listed}"
        );
        assert!(listed.contains(tally), "{listed}");
    }
}

/// One side of an axle after the other, as far as they follow from the rack: 8 assemblies of the left side, which determines
/// the rack, times 2 positions of its other end, times 4 of the right side on average.
#[test]
fn the_list_of_assemblies_of_a_steered_axle_is_complete() {
    let folder = folder();
    let axle = include_str!("../../../examples/steered_axle.toml");
    std::fs::write(folder.path().join("axle.toml"), axle).expect("written");
    let output = run(
        folder.path(),
        &["assemblies", "axle.toml", "--csv", "all.csv"],
    );
    let listed = text(&output.stdout);
    let expected = "The list is complete by all that was tried:\n64 real assemblies, put together part by part, in 3 parts:\n";
    assert!(listed.contains(expected), "{listed}");
    let rows = rows(&std::fs::read(folder.path().join("all.csv")).expect("a table"));
    assert_eq!(rows.len(), 64);
    let links = ["left", "right"].into_iter().flat_map(|side| {
        let of_side = |point: &str| format!("{side}_{point}");
        let balls = ["lower_ball", "upper_ball", "tie_ball", "wheel_centre"].map(of_side);
        let [lower, upper, tie, centre] = balls;
        let rack = format!("rack_{side}");
        [
            [lower.clone(), upper.clone()],
            [lower.clone(), tie.clone()],
            [upper, tie.clone()],
            [lower, centre],
            [rack, tie],
        ]
    });
    let rack = ["rack_left", "rack_right"].map(str::to_owned);
    for link in links.chain([rack]) {
        let [first, ..] = rows.as_slice() else {
            panic!("no rows")
        };
        for row in &rows {
            assert!((length(row, &link) - length(first, &link)).abs() < 1e-12);
        }
    }
    // All assemblies differ, by micrometres of all free points.
    let placed = rows.iter().map(|row| {
        let coordinates = row.iter().filter(|(name, _)| name.contains("_ball_"));
        let rounded = coordinates.map(|(_, x)| (x * 1e6).round() as i64);
        rounded
            .chain([(row["rack_right_y"] * 1e6).round() as i64])
            .collect::<Vec<_>>()
    });
    assert_eq!(placed.collect::<BTreeSet<_>>().len(), 64);
}

/// A double wishbone with random errors of up to 40 mm in all points: its wishbones' axes are skew.
fn skew_double_wishbone(seed: u64) -> String {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut points = String::new();
    for (name, at) in [
        ("lower_front", [0.2, 0.35, 0.16]),
        ("lower_rear", [-0.2, 0.35, 0.16]),
        ("upper_front", [0.15, 0.42, 0.42]),
        ("upper_rear", [-0.15, 0.42, 0.42]),
        ("rack", [0.11, 0.34, 0.2]),
        ("lower_ball", [0.005, 0.7, 0.17]),
        ("upper_ball", [-0.015, 0.66, 0.44]),
        ("tie_ball", [0.12, 0.68, 0.21]),
        ("wheel_centre", [0.0, 0.75, 0.3]),
    ] {
        let at = at.map(|x: f64| x + 0.08 * (random.f64() - 0.5));
        points += &format!("{name} = {at:?}\n");
    }
    format!(
        "linkage = \"double_wishbone\"\nunit = \"m\"\ntime = {{ instants = [0.0] }}\n\
         [points]\n{points}[drives]\nbump = 0.3\nsteer = 0.34\n"
    )
}

#[test]
fn a_skew_wishbone_lists_32_assemblies_or_reports_an_incomplete_list() {
    const SEEDS: u64 = 6;
    let folder = folder();
    let mut complete = 0;
    for seed in 0..SEEDS {
        let file = skew_double_wishbone(seed);
        std::fs::write(folder.path().join("a.toml"), &file).expect("written");
        let arguments = ["assemblies", "a.toml", "--drive", "bump", "--at", "0.3"];
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(0), "seed {seed}: {output:?}");
        let report = text(&output.stdout);
        if report.contains("The list is complete") {
            assert!(report.contains("of the 32 that"), "seed {seed}: {report}");
            complete += 1;
        }
    }
    assert!(complete + 1 >= SEEDS, "{complete} of {SEEDS}");
}

/// The double wishbone of the README's `import`, with nearly parallel axes: of 32 general assemblies eight are tens of
/// thousands of its sizes away, because only lengths are general. Counts of 24, 32 and 33 were found before, depending on
/// the last digits of the points.
#[test]
fn the_count_of_assemblies_does_not_depend_on_last_digits() {
    let folder = folder();
    let table = include_str!("../../../examples/hardpoints.csv");
    std::fs::write(folder.path().join("points.csv"), table).expect("written");
    let output = run(folder.path(), &["import", "points.csv", "--out", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let path = folder.path().join("a.toml");
    let imported = std::fs::read_to_string(&path).expect("a file");
    for lower_rear in [
        "[-150.0, 175.0, 120.0]",
        "[-150.0, 175.000001, 120.0]",
        "[-150.0, 170.0, 125.0]",
    ] {
        let file = imported.replace("[-150.0, 175.0, 120.0]", lower_rear);
        std::fs::write(&path, file).expect("written");
        let output = run(folder.path(), &["assemblies", "a.toml"]);
        let listed = text(&output.stdout);
        assert!(
            listed.contains("The list is complete by all that was tried:")
                && listed.contains("of the 32 that such a part has"),
            "{lower_rear}: {listed}"
        );
    }
}
