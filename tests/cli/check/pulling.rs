//! Springs whose load has the wrong sign.

use super::super::program::{folder, run, text};
use super::{check, line};

/// A spring upright above the hub of an arm: its whole force acts on the wheel.
fn sprung(load: f64) -> String {
    format!(
        "unit = \"m\"\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3 }}\n\
             springs.coil = {{ along = \"spring\", rate = 30000.0, load = {load:?} }}\nstatements = \"\"\"\n\
             fixed: front at [0.2, 0.3, 0.3], rear at [-0.2, 0.3, 0.3], top at [0.0, 0.8, 0.8];\n\
             free: hub at [0.0, 0.8, 0.3];\nhinge arm: front, rear -> hub;\npoint axle: arm at [0.0, 0.7, 0.3];\n\
             drive bump: hub.z;\nmeasure spring: length(hub -> top);\nwheel: axle -> hub;\n\"\"\"\n"
    )
}

#[test]
fn a_spring_that_pulls_the_wheel_up_is_noted() {
    let of = |load: f64| {
        let output = check(&sprung(load), &[]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        output
    };
    let pulling = of(-4000.0);
    let note = line(&pulling, "note");
    let expected = "a.toml: springs pull the wheel up with 4000 N at the design position: is the sign of their load right? It \
                    is positive where it makes the measure larger";
    assert!(note.ends_with(expected), "{note}");
    for load in [4000.0, 0.0] {
        let report = of(load);
        assert!(!text(&report.stdout).contains("springs pull"), "{report:?}");
    }
}

#[test]
fn the_sheet_says_so_too() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), sprung(-4000.0)).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let note = "pull the wheel up with 4000 N at the design position";
    assert!(text(&output.stderr).contains(note), "{output:?}");
    let page = std::fs::read_to_string(folder.path().join("out/a_sheet.html")).expect("a page");
    assert!(page.contains(note), "{page}");
}
