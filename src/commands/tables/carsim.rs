//! Tables over jounce in the format of CarSim's library files.

use std::fmt::Write;

use crate::commands::tables::wheel_motion::{Change, WheelMotion};
use crate::mechanism::Description;
use crate::number::{rounded, without_rounding};

/// A table: its keyword, its description, and the function that computes it.
type Row = (&'static str, &'static str, fn(&WheelMotion, &Change) -> f64);

const TABLES: [Row; 5] = [
    ("CAMBER_TABLE", "camber, deg", |_, change| {
        change.camber.to_degrees()
    }),
    ("TOE_TABLE", "toe, deg", |_, change| change.toe.to_degrees()),
    ("SUSP_DIVE_TABLE", "dive, deg", |_, change| {
        change.dive.to_degrees()
    }),
    ("SUSP_X_TABLE", "forward, mm", |_, change| {
        1e3 * change.moved.x
    }),
    ("SUSP_LAT_TABLE", "inboard, mm", |wheel, change| {
        -1e3 * wheel.side * change.moved.y
    }),
];

const DIGITS: usize = 7;

pub(super) fn text(file: &str, mechanism: &Description, wheel: &WheelMotion) -> String {
    let number = |value: f64| rounded(without_rounding(value), DIGITS);
    let place = wheel.in_words();
    let mut text = format!(
        "PARSFILE\n# Kinematics of {}, {place}, of {file}, by suspension {}\n\
         # Over jounce, mm: changes from the design position, whose angles, deg, are\n\
         A_CAMBER {}\nA_TOE {}\n",
        mechanism.linkage,
        env!("CARGO_PKG_VERSION"),
        number(wheel.camber.to_degrees()),
        number(wheel.toe.to_degrees()),
    );
    for (keyword, what, value) in TABLES {
        // Writing into a string cannot fail.
        let _ = writeln!(text, "\n# {what}\n{keyword} SPLINE");
        for change in &wheel.changes {
            let (jounce, value) = (1e3 * change.moved.z, value(wheel, change));
            let _ = writeln!(text, "{}, {}", number(jounce), number(value));
        }
        text.push_str("ENDTABLE\n");
    }
    text + "\nEND\n"
}
