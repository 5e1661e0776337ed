//! The wheel of an axle that is baked.

use super::super::program::{folder, run, text};

const AXLE: &str = include_str!("../../../examples/steered_axle.toml");

#[test]
fn the_wheel_that_the_drive_moves_is_baked() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), AXLE).expect("written");
    let left = "The left wheel centre and spin axis";
    let right = "The right wheel centre and spin axis";
    for (arguments, expected) in [
        (&["--drive", "bump_left=0.26:0.34"][..], left),
        (&["--drive", "bump_right=0.26:0.34"], right),
        (&["--drive", "steer=0.33:0.34"], left),
        (&["--drive", "steer=0.33:0.34", "--wheel", "right"], right),
        (
            &["--drive", "bump_right=0.26:0.34", "--wheel", "left"],
            left,
        ),
        (
            &[
                "--drive",
                "steer=0.33:0.34",
                "--drive",
                "bump_right=0.28:0.3",
            ],
            right,
        ),
    ] {
        let bake = [
            "bake",
            "a.toml",
            "--as",
            "toml",
            "-o",
            "-",
            "--tolerance",
            "1e-5",
        ];
        let output = run(folder.path(), &[&bake, arguments].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let baked = text(&output.stdout);
        assert!(baked.contains(expected), "{arguments:?}: {baked}");
        let still = arguments == ["--drive", "bump_right=0.26:0.34", "--wheel", "left"];
        let note = match still {
            true => {
                "note: a.toml: bump_right does not move the left wheel: what is baked is constant\n"
            }
            false => "",
        };
        assert_eq!(text(&output.stderr), note, "{arguments:?}");
    }
}

/// A rear axle that steers moves none of the front wheels.
#[test]
fn a_drive_of_no_travel_bakes_the_first_wheel_that_it_moves() {
    let folder = folder();
    let wheel = |name: &str, y: f64| {
        format!(
            "fixed: {name}_low at [0.0, {y:?}, 0.2], {name}_high at [0.0, {y:?}, 0.4];\n\
             free: {name}_middle at [0.0, {:?}, 0.3];\nhinge {name}_knuckle: {name}_low, {name}_high -> {name}_middle;\n\
             point {name}_hub: {name}_knuckle at [0.0, {:?}, 0.3];\ndrive {name}_steer: {name}_middle.x;\n\
             wheel {name}: {name}_hub -> {name}_middle;\n",
            y * 1.2,
            y * 1.1
        )
    };
    let statements = wheel("left", 0.7) + &wheel("right", -0.7);
    let file = format!(
        "unit = 'm'\ntime = {{ instants = [0.0] }}\ndrives = {{ left_steer = 0.0, right_steer = 0.0 }}\nstatements = '''\n{statements}'''\n"
    );
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    for (wheel, other) in [("left", "right"), ("right", "left")] {
        let drive = format!("{wheel}_steer=-0.05:0.05");
        let output = run(
            folder.path(),
            &["bake", "a.toml", "--drive", &drive, "-o", "-"],
        );
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let baked = text(&output.stdout);
        assert!(
            baked.contains(&format!("The {wheel} wheel centre")),
            "{baked}"
        );
        assert!(!baked.contains(&format!("The {other} wheel")), "{baked}");
    }
}

#[test]
fn a_wrong_wheel_is_refused_and_a_named_one_is_in_the_name_of_the_file() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), AXLE).expect("written");
    let bake = ["bake", "a.toml", "--drive", "bump_left=0.26:0.34"];
    for (arguments, expected) in [
        (
            &["--wheel", "rigt"][..],
            "a.toml: unknown wheel `rigt`; known are left, right; did you mean `right`?",
        ),
        (
            &["--wheel", "left", "--points", "all"],
            "--points all bakes the points of all wheels; leave --wheel out",
        ),
    ] {
        let output = run(folder.path(), &[&bake, arguments].concat());
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert_eq!(text(&output.stderr).trim_end(), expected);
    }
    let output = run(folder.path(), &[&bake[..], &["--wheel", "left"]].concat());
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let path = folder.path().join("out/a_left_wheel_by_bump_left.rs");
    let baked = std::fs::read_to_string(path).expect("a file");
    assert!(baked.contains("A_LEFT_WHEEL_BY_BUMP_LEFT"), "{baked}");
}
