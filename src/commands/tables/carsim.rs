//! Tables over jounce, as the library files of CarSim have them.

use std::fmt::Write;

use crate::commands::tables::wheel::{Place, Wheel, exact_zero};
use crate::mechanism::Description;
use crate::number::rounded;

/// A table: its keyword, what it has, and how it is read.
type Row = (&'static str, &'static str, fn(&Wheel, &Place) -> f64);

const TABLES: [Row; 5] = [
    ("CAMBER_TABLE", "camber, deg", |_, place| {
        place.camber.to_degrees()
    }),
    ("TOE_TABLE", "toe, deg", |_, place| place.toe.to_degrees()),
    ("SUSP_DIVE_TABLE", "dive, deg", |_, place| {
        place.dive.to_degrees()
    }),
    ("SUSP_X_TABLE", "forward, mm", |_, place| {
        1e3 * place.moved.x
    }),
    ("SUSP_LAT_TABLE", "inboard, mm", |wheel, place| {
        -1e3 * wheel.side * place.moved.y
    }),
];

const DIGITS: usize = 7;

/// The file.
pub(super) fn text(file: &str, mechanism: &Description, wheel: &Wheel) -> String {
    let number = |value: f64| rounded(exact_zero(value), DIGITS);
    let side = if wheel.side < 0.0 { "right" } else { "left" };
    let mut text = format!(
        "PARSFILE\n# Kinematics of {}, {side} wheel, of {file}, by suspension {}\n\
         # Over jounce, mm: changes from the design position, whose angles, deg, are\n\
         A_CAMBER {}\nA_TOE {}\n",
        mechanism.linkage,
        env!("CARGO_PKG_VERSION"),
        number(wheel.camber.to_degrees()),
        number(wheel.toe.to_degrees()),
    );
    for (keyword, what, value) in TABLES {
        // Writing into a string has no way to fail.
        let _ = writeln!(text, "\n# {what}\n{keyword} SPLINE");
        for place in &wheel.places {
            let (jounce, value) = (1e3 * place.moved.z, value(wheel, place));
            let _ = writeln!(text, "{}, {}", number(jounce), number(value));
        }
        text.push_str("ENDTABLE\n");
    }
    text + "\nEND\n"
}
