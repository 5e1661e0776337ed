//! A pushrod or a damper on the upper wishbone.

use std::collections::BTreeMap;

use super::super::program::folder;
use super::{CORNER, Imported, import, swept, table};

/// The table with a rod from the upper wishbone to the rocker.
fn pulled() -> String {
    let file = table(&CORNER);
    let moved = file.replace(
        "prod_outboard, 2, -520, 150",
        "pullrod_outer, 12, -500, 325",
    );
    moved.replace("prod_inboard", "pullrod_inner")
}

/// A damper from the upper wishbone to the chassis, without pushrod and rocker.
fn coilover() -> String {
    table(&CORNER[..9]) + "shock_lower, 5, -470, 310\nshock_upper, 0, -400, 620\n"
}

/// How far the distance between two points of a corner changes over travel.
fn stretch(imported: &Imported, rows: &[BTreeMap<String, f64>], names: [&str; 2]) -> f64 {
    let fixed = imported.points();
    let at = |row: &BTreeMap<String, f64>, name: &str| {
        let moves = |axis| row.get(&format!("{name}_{axis}")).copied();
        [0, 1, 2].map(|i| moves(["x", "y", "z"][i]).unwrap_or_else(|| fixed[name][i]))
    };
    let apart = rows.iter().map(|row| {
        let [a, b] = names.map(|name| at(row, name));
        (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
    });
    let (least, most) = apart.fold((f64::MAX, 0.0_f64), |(least, most), d| {
        (least.min(d), most.max(d))
    });
    most - least
}

#[test]
fn a_damper_to_the_chassis_may_have_an_inner_and_an_outer_end() {
    let folder = folder();
    let file = coilover();
    let other = file
        .replace("shock_lower", "Shock outboard")
        .replace("shock_upper", "Shock inboard");
    let [file, other] = [file, other].map(|file| import(folder.path(), "a.csv", &file, &[]));
    assert_eq!(other.points(), file.points(), "{}", other.notes);
}

#[test]
fn an_outer_end_near_the_upper_ball_joint_moves_with_the_upper_wishbone() {
    let folder = folder();
    for (file, point, outer, layout) in [
        (
            pulled(),
            "pushrod_lower",
            "pullrod_outer",
            "a pushrod from the upper wishbone to a rocker",
        ),
        (
            coilover(),
            "damper_lower",
            "shock_lower",
            "a damper with its spring from the upper wishbone to the chassis",
        ),
    ] {
        let imported = import(folder.path(), "a.csv", &file, &[]);
        let said = format!(
            "`{outer}` is nearer to `uca_outer` than to `lca_outer`, so it is on the upper wishbone. To put it on the lower one, \
             move {point} to lower_wishbone in the statements of the corner"
        );
        assert!(imported.notes.contains(&said), "{}", imported.notes);
        assert!(imported.notes.contains(layout), "{}", imported.notes);
        let rows = swept(folder.path(), "motion.toml", &["bump=-20:20:9", "steer=0"]);
        assert_eq!(rows.len(), 9);
        for other in ["upper_front", "upper_rear", "upper_ball"] {
            let stretch = stretch(&imported, &rows, [point, other]);
            assert!(stretch < 1e-10, "{point} to {other}: {stretch:e}");
        }
        assert!(stretch(&imported, &rows, [point, "lower_ball"]) > 0.1);
    }
}

#[test]
fn an_outer_end_near_the_lower_ball_joint_keeps_the_layout() {
    let folder = folder();
    let imported = import(folder.path(), "a.csv", &table(&CORNER), &[]);
    assert_eq!(imported.text("linkage"), "double_wishbone_rocker");
    assert!(!imported.notes.contains("nearer"), "{}", imported.notes);
}

#[test]
fn both_corners_of_an_axle_have_it_on_the_upper_wishbone() {
    let folder = folder();
    import(folder.path(), "a.csv", &pulled(), &[]);
    let alone = swept(folder.path(), "motion.toml", &["bump=15", "steer=0"]);
    // The listing of the corner may be written again, also for a rear axle.
    for file in [pulled(), pulled(), format!("Rear suspension\n{}", pulled())] {
        import(folder.path(), "a.csv", &file, &["--axle"]);
        let axle = swept(
            folder.path(),
            "motion.toml",
            &["left_bump=15", "right_bump=15"],
        );
        for damper in ["left_damper_mm", "right_damper_mm"] {
            assert!(
                (axle[0][damper] - alone[0]["damper_mm"]).abs() < 1e-10,
                "{damper}"
            );
        }
    }
}

/// A tension strut and a lateral link under an upper wishbone: the names of a split lower arm.
#[test]
fn a_tension_strut_is_the_diagonal_link_of_a_split_lower_arm() {
    let points = [
        ("UCA front", [-120.0, -470.0, 560.0]),
        ("UCA rear", [160.0, -480.0, 540.0]),
        ("UCA outer", [35.0, -680.0, 570.0]),
        ("Tension strut inner", [-360.0, -380.0, 190.0]),
        ("Tension strut outer", [-55.0, -690.0, 180.0]),
        ("Lateral link inner", [30.0, -350.0, 180.0]),
        ("Lateral link outer", [10.0, -710.0, 170.0]),
        ("Tie rod inner", [150.0, -340.0, 220.0]),
        ("Tie rod outer", [140.0, -680.0, 220.0]),
        ("Wheel centre", [0.0, -760.0, 320.0]),
        ("Damper upper", [40.0, -540.0, 860.0]),
        ("Damper lower", [30.0, -600.0, 570.0]),
    ];
    let folder = folder();
    let imported = import(
        folder.path(),
        "front.csv",
        &table(&points),
        &["--unit", "mm"],
    );
    assert_eq!(imported.text("linkage"), "split_lower_arm");
    let points = imported.points();
    assert_eq!(
        points["diagonal_inner"].map(f64::abs),
        [360.0, 380.0, 190.0]
    );
    assert_eq!(points["diagonal_ball"].map(f64::abs), [55.0, 690.0, 180.0]);
}
