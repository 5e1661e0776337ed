//! Tables in which several columns say where the model is.

use super::super::super::program::text;
use super::super::rig::{axle, swept};
use super::super::rows;
use super::beside;

/// The axle of the catalogue with one of its statements replaced, and these values of drives.
fn changed([from, to]: [&str; 2], drives: &str) -> String {
    let listing = include_str!("../../../../suspension-core/src/linkages/steered_axle.linkage");
    assert!(listing.contains(from), "{listing}");
    let listing = listing.replace(from, to);
    axle()
        .replace(
            "linkage = \"steered_axle\"",
            &format!("statements = \"\"\"\n{listing}\"\"\""),
        )
        .replace("bump_left = 0.3\nbump_right = 0.3", drives)
}

/// The same axle, led by the mean of the heights of its wheels, and by how much higher the left one is.
pub(super) fn in_heave_and_roll() -> String {
    let heights = "0.5 left_wheel_centre.z + 0.5 right_wheel_centre.z";
    changed(
        [
            "drive bump_left: left_wheel_centre.z;",
            &format!(
                "drive heave: {heights};\ndrive roll: left_wheel_centre.z - right_wheel_centre.z;"
            ),
        ],
        "heave = 0.3\nroll = 0.0",
    )
}

/// The same axle, led by the lengths of its dampers.
fn by_dampers() -> String {
    let at_design = 0.005_f64.hypot(0.25).hypot(0.48);
    changed(
        [
            "drive bump_left: left_wheel_centre.z;",
            "fixed: left_top at [0.0, 0.45, 0.65];\ndrive bump_left: length(left_top -> left_lower_ball);",
        ],
        &format!("bump_left = {at_design:?}\nbump_right = {at_design:?}"),
    )
}

/// The table with empty headings in place of these.
fn without(table: &str, headings: &[&str]) -> String {
    let (first, lines) = table.split_once('\n').expect("headings");
    let each = first
        .split(',')
        .map(|heading| match headings.contains(&heading) {
            true => "",
            false => heading,
        });
    format!("{}\n{lines}", each.collect::<Vec<_>>().join(","))
}

fn grid() -> String {
    let drives = [
        "bump_left=-0.03:0.03:4",
        "bump_right=-0.03:0.04:3",
        "steer=-0.02:0.02:3",
    ];
    let drives = drives.iter().flat_map(|drive| ["--drive", drive]);
    let options: Vec<&str> = drives.chain(["--derivatives", "0"]).collect();
    swept(&axle(), &options)
}

/// Drives lead; without their columns wheel travel does.
#[test]
fn a_grid_over_three_drives_is_equal_to_its_own_model() {
    let grid = grid();
    let bumps = &["bump_left_m", "bump_right_m"];
    for (table, along) in [
        (grid.clone(), "line of the table"),
        (without(&grid, bumps), "line of the table"),
    ] {
        let (_folder, output) = beside(&axle(), &table, &["--absolute", "--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert!(text(&output.stdout).contains(along), "{output:?}");
        let found = rows(&output);
        assert!(found.len() > 300, "{}", found.len());
        for (names, [.., difference]) in &found {
            assert!(difference.abs() < 1e-9, "{names:?} {difference}");
        }
    }
}

/// The numbers of an axle led by heights, beside the same axle led otherwise. What steering does while the other drives are
/// held is different, as these are others.
#[test]
fn wheel_travel_of_both_sides_leads_the_model_whatever_its_drives() {
    let table = without(&grid(), &["bump_left_m", "bump_right_m"]);
    for model in [by_dampers(), in_heave_and_roll()] {
        let (_folder, output) = beside(&model, &table, &["--absolute", "--csv", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let mut found = rows(&output);
        let in_steering = ["overall steering ratio", "virtual steering axis"];
        found.retain(|(names, _)| !in_steering.iter().any(|it| names[1].contains(it)));
        assert!(found.len() > 200, "{}", found.len());
        for (names, [.., difference]) in &found {
            assert!(difference.abs() < 1e-9, "{names:?} {difference}");
        }
    }
}

/// Travel and rack in mm, with the noise of a rig; how much higher the left wheel is has a known difference in mm.
fn rig(places: impl Iterator<Item = [f64; 3]>) -> String {
    let heading = "left wheel travel [mm],right wheel travel [mm],steer [mm],roll travel [mm],rack_left_y [mm]\n";
    let lines = places.enumerate().map(|(line, [left, right, rack])| {
        let noise = |of: f64| (17.0 * of * line as f64).sin();
        let (left, right) = (left + 0.03 * noise(1.0), right + 0.03 * noise(1.1));
        let rack = rack + 0.01 * noise(1.2);
        let higher = left - right + if line % 10 == 6 { 1.6 } else { 1.0 };
        format!(
            "{left:?},{right:?},{rack:?},{higher:?},{:?}\n",
            340.0 + rack
        )
    });
    format!("# Rig 17\n\n{heading}{}", lines.collect::<String>())
}

#[test]
fn the_column_that_changes_most_is_the_axis_beside_noise() {
    let cycle = || (0..41).map(|line| 50.0 * (f64::from(line) * 0.157).sin());
    let parallel = rig(cycle().map(|at| [at, at, 0.0]));
    let roll = rig(cycle().map(|at| [at, -at, 0.0]));
    let steering = rig(cycle().map(|at| [0.0, 0.0, 0.5 * at]));
    for (table, along) in [
        (parallel, "travel of the left wheel (mm)"),
        (roll, "travel of the left wheel (mm)"),
        (steering, "change of steer (mm)"),
    ] {
        for model in [axle(), by_dampers(), in_heave_and_roll()] {
            let (_folder, output) = beside(&model, &table, &["--csv", "-"]);
            assert_eq!(output.status.code(), Some(0), "{output:?}");
            assert!(!text(&output.stderr).contains("`steer`"), "{output:?}");
            assert_eq!(text(&output.stdout).matches(along).count(), 6, "{output:?}");
            let found = rows(&output);
            let [(names, higher), (_, rack), (_, offset), ..] = &found[..] else {
                panic!("{found:?}")
            };
            assert_eq!(names[1], "roll_travel");
            assert!((higher[3] - 1.6).abs() < 1e-9, "{higher:?}");
            assert!(rack[3].abs() < 1e-9, "{rack:?}");
            // The first line is at the design position.
            assert!(
                offset[0] == 0.0 && (offset[3] - 1.0).abs() < 1e-9,
                "{offset:?}"
            );
        }
    }
}

/// On a grid of bump and steering neither says where the model is.
#[test]
fn places_without_an_axis_are_counted_by_the_lines_of_the_file() {
    let grid = [-40.0, 40.0, 0.0].map(|left| [-20.0, 20.0, 0.0].map(|rack| [left, 0.0, rack]));
    let table = rig(grid.into_iter().flatten());
    let (five, rest) = table.split_at(table.match_indices('\n').nth(7).expect("lines").0);
    let table = format!("{five}\n# back{rest}");
    let line_of = |number: usize| number as f64 + 5.0;
    let (folder, output) = beside(&axle(), &table, &["--csv", "-", "--html", "c.html"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let found = rows(&output);
    let [(_, whole), _, (_, offset), _, (_, rest), _] = &found[..] else {
        panic!("{found:?}")
    };
    for (row, line, off) in [(whole, 6, 1.6), (offset, 8, 1.0), (rest, 6, 0.6)] {
        assert!(
            row[0] == line_of(line) && (row[3] - off).abs() < 1e-9,
            "{row:?}"
        );
    }
    let page = std::fs::read_to_string(folder.path().join("c.html")).expect("a page");
    for expected in [
        "Over the lines of the table",
        "at a line of the table",
        "A follows left wheel travel (-40",
        " and steer (-20",
        " mm) of B in each line",
    ] {
        assert!(page.contains(expected), "{expected}");
    }
}

#[test]
fn a_column_that_holds_the_model_away_from_the_design_position_is_stated() {
    let table =
        "bump_left [mm],bump_right [mm],steer [mm],left toe [deg]\n-20,0,15.5,0\n30,0,15.5,0\n";
    let (_folder, output) = beside(&axle(), table, &[]);
    let expected = "A follows bump_left (-20 to 30 mm) and steer (15.5 mm) of B in each line\n";
    assert!(text(&output.stdout).contains(expected), "{output:?}");
    let noisy = table.replacen("15.5", "15.52", 1);
    let (_folder, output) = beside(&axle(), &noisy, &[]);
    assert_eq!(text(&output.stderr), "", "{output:?}");
    assert!(
        text(&output.stdout).contains("and steer (15.5 to 15.52 mm) of B"),
        "{output:?}"
    );
}

/// The travel of a wheel is compared where a column of its drive says where it is.
#[test]
fn a_drive_leads_before_the_travel_of_its_wheel() {
    let table = "bump_left [mm],left wheel travel [mm],right wheel travel [mm]\n0,0,0\n10,12,5\n";
    let (_folder, output) = beside(&axle(), table, &["--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let found = rows(&output);
    assert_eq!(found.len(), 3, "{found:?}");
    let (names, [at, _, _, difference]) = &found[0];
    assert_eq!(names[1], "left wheel travel");
    assert!(*at == 10.0 && (difference - 2.0).abs() < 1e-9, "{found:?}");
}
