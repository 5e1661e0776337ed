//! Tables of corners that lack a point, or whose unit is in doubt.

use super::super::program::folder;
use super::refused::refusal;
use super::{CORNER, import, table};

/// A double wishbone with a coil-over, front left by its heading, in millimetres times `scale`, without the point `without`.
fn coilover(without: &str, scale: f64) -> String {
    let points = [
        ("Lower wishbone front pivot", [152.5, 358.0, 142.0]),
        ("Lower wishbone rear pivot", [-188.0, 362.5, 146.5]),
        ("Lower ball joint", [8.2, 712.4, 136.3]),
        ("Upper wishbone front pivot", [118.0, 432.6, 421.0]),
        ("Upper wishbone rear pivot", [-132.5, 437.1, 408.2]),
        ("Upper ball joint", [-21.4, 668.9, 438.7]),
        ("Tie rod inner", [121.3, 349.2, 188.6]),
        ("Tie rod outer", [128.9, 690.7, 184.1]),
        ("Damper top", [2.1, 498.3, 640.5]),
        ("Damper bottom", [4.6, 618.8, 158.2]),
        ("Wheel centre", [0.0, 782.5, 318.0]),
    ];
    let points = points.into_iter().filter(|(name, _)| *name != without);
    let rows = points.map(|(name, at)| {
        let [x, y, z] = at.map(|coordinate| coordinate * scale);
        format!("{name},{x:.3},{y:.3},{z:.3}\n")
    });
    format!("Front left suspension\n{}", rows.collect::<String>())
}

/// Its wishbones and its damper without the joints of the knuckle would be links of a live axle.
#[test]
fn a_corner_that_lacks_a_point_is_no_live_axle() {
    for (without, missing) in [
        ("Lower ball joint", "lower_ball"),
        ("Upper ball joint", "upper_ball"),
        ("Tie rod inner", "rack"),
        ("Tie rod outer", "tie_ball"),
    ] {
        let message = refusal("a.csv", &coilover(without, 1.0), &[]);
        let expected = format!(
            "a.csv: no layout has all its points here; the nearest, double_wishbone_coilover, lacks `{missing}`"
        );
        assert!(message.starts_with(&expected), "{message}");
    }
    let folder = folder();
    let whole = import(
        folder.path(),
        "a.csv",
        &coilover("", 1.0),
        &["--unit", "mm"],
    );
    assert_eq!(
        whole.motion["linkage"].as_str(),
        Some("double_wishbone_coilover")
    );
}

#[test]
fn a_corner_in_centimetres_is_no_live_axle_in_inches() {
    let message = refusal("a.csv", &coilover("", 0.1), &[]);
    assert!(
        message.contains("state the unit with --unit; convert lengths in cm to mm"),
        "{message}"
    );
}

#[test]
fn a_layout_that_would_use_more_of_the_points_is_noted() {
    let folder = folder();
    let points = CORNER.into_iter();
    let points: Vec<_> = points.filter(|(name, _)| *name != "prod_inboard").collect();
    let imported = import(folder.path(), "a.csv", &table(&points), &[]);
    assert_eq!(imported.motion["linkage"].as_str(), Some("double_wishbone"));
    let expected = "note: a.csv: double_wishbone_rocker would use 5 more of the points, but lacks `pushrod_upper` (or ";
    assert!(imported.notes.contains(expected), "{}", imported.notes);
    let whole = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    assert!(
        !whole.notes.contains("more of the points"),
        "{}",
        whole.notes
    );
}
