//! Links and joints that bear nothing.

use super::super::program::{folder, run, text};
use super::{BRAKING, force, loaded, table};

/// Parts without load at any place are named in one line, instead of rows of zeros; the written table contains them.
#[test]
fn parts_without_load_are_named_in_one_line() {
    let folder = folder();
    let case = "[loads.a]\nrack = [0.0, 100.0, 0.0]\nlower_ball = [0.0, 0.0, 3e-3]\n";
    let braking = format!("{BRAKING}bump = \"damper\"\n");
    let bar =
        "drop_link, rocker at drop_upper, bar at bar_inner, bar at drop_lower, bar at bar_outer";
    for (case, more, unloaded, kept) in [
        (
            &*braking,
            &[][..],
            &*format!("{bar}, upright at wheel_centre"),
            "upright at lower_ball",
        ),
        (
            &braking,
            &["--drive", "bump=-0.05:0.05:3"],
            &format!("{bar}, upright at wheel_centre"),
            "upright at lower_ball",
        ),
        (
            case,
            &[],
            "pushrod, drop_link, ",
            "lower_wishbone at lower_ball",
        ),
    ] {
        std::fs::write(folder.path().join("a.toml"), loaded(case)).expect("written");
        let output = run(folder.path(), &[&["loads", "a.toml"], more].concat());
        let report = text(&output.stdout);
        assert_eq!(report.matches("no load in: ").count(), 1, "{report}");
        assert!(
            report.contains(&format!("\n\nno load in: {unloaded}")),
            "{report}"
        );
        for name in unloaded.split(", ").filter(|name| !name.is_empty()) {
            assert!(!report.contains(&format!("\n{name} ")), "{name}: {report}");
        }
        assert!(
            report.contains(&format!("\n{kept} ")),
            "small forces are shown: {report}"
        );
    }
    let row = &table(&loaded(&braking), &[])[0];
    assert!(force(row, "braking_upright_wheel_centre").norm() < 1e-8);
}
