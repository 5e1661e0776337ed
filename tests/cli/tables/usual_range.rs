//! The range of a table without `--travel`.

use super::super::program::{folder, run, text};

/// The usual range is one of heights of the wheel.
#[test]
fn a_range_of_a_scaled_drive_is_noted_by_how_far_the_wheel_rises() {
    let file = "unit = \"m\"\ntime = { instants = [0.0] }\ndrives = { bump = 300.0 }\nstatements = \"\"\"\n\
                fixed: front at [0.2, 0.3, 0.3], rear at [-0.2, 0.3, 0.3];\nfree: hub at [0.0, 0.8, 0.3];\n\
                hinge arm: front, rear -> hub;\npoint axle: arm at [0.0, 0.7, 0.3];\ndrive bump: 1000 hub.z;\n\
                wheel: axle -> hub;\n\"\"\"\n";
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    for (options, note) in [
        (&["carmaker"][..], ""),
        (
            &["carsim"],
            "note: a.toml: over the usual range of bump the wheel rises by 0.00012 m; --travel sets another range\n",
        ),
        (&["carsim", "--travel", "-60:60"], ""),
        (
            &["carsim", "--travel", "-0.06:0.06"],
            "note: a.toml: bump is from -0.06 m to 0.06 m: is it in another unit?\n",
        ),
    ] {
        let tables = ["tables", "a.toml", "--out", "-", "--as"];
        let output = run(folder.path(), &[&tables, options].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert_eq!(text(&output.stderr), note, "{options:?}");
    }
}
