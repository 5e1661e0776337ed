//! Springs whose load has the wrong sign.

use super::super::program::text;
use super::{check, line};

/// A spring upright above the hub of an arm: its whole force acts on the wheel.
#[test]
fn a_spring_that_pulls_the_wheel_up_is_noted() {
    let of = |load: f64| {
        let file = format!(
            "unit = \"m\"\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3 }}\n\
             springs.coil = {{ along = \"spring\", rate = 30000.0, load = {load:?} }}\nstatements = \"\"\"\n\
             fixed: front at [0.2, 0.3, 0.3], rear at [-0.2, 0.3, 0.3], top at [0.0, 0.8, 0.8];\n\
             free: hub at [0.0, 0.8, 0.3];\nhinge arm: front, rear -> hub;\npoint axle: arm at [0.0, 0.7, 0.3];\n\
             drive bump: hub.z;\nmeasure spring: length(hub -> top);\nwheel: axle -> hub;\n\"\"\"\n"
        );
        let output = check(&file, &[]);
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
