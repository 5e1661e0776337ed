//! A curve of one drive, or of a measure, as a file.

mod c;
mod rust;
mod toml;

use crate::bake::baked::Baked;
use crate::bake::certify::SAMPLES;
use crate::bake::scheme::{Continuity, TERMS};
use crate::bake::source::about::{Ranged, row};
use crate::bake::source::{Language, Titled, bound, tolerance};
use crate::number::counted;

/// The data from which the text of a curve is written.
struct CurveFile<'a> {
    titled: Titled<'a>,
    argument: &'a Ranged,
    baked: &'a Baked,
}

/// The text of a file; empty without an argument.
pub(super) fn text(titled: Titled<'_>, baked: &Baked, language: Language) -> String {
    let [argument] = titled.about.arguments.as_slice() else {
        return String::new();
    };
    let file = CurveFile {
        titled,
        argument,
        baked,
    };
    match language {
        Language::Rust => rust::text(&file),
        Language::C => c::text(&file),
        Language::Toml => toml::text(&file),
    }
}

impl CurveFile<'_> {
    /// The information for a reader, line by line.
    fn header(&self) -> Vec<String> {
        let Self {
            titled: Titled { about, outputs, .. },
            argument,
            baked,
        } = self;
        let (unit, per) = (about.unit.symbol(), &argument.unit);
        let joined = match baked.wanted.continuity {
            Continuity::Position => "position",
            Continuity::Velocity => "position and first derivative",
            Continuity::Acceleration => "position, first and second derivative",
        };
        let reached = baked.reached;
        let [first, second] = [reached.first, reached.second].map(bound);
        let count = baked.segments.len();
        let bytes = count * TERMS * outputs.len() * size_of::<f64>();
        let mut lines = about.header(&baked.outputs);
        lines.extend([
            format!("Continuous where segments join: {joined}."),
            tolerance(baked.wanted.tolerance, reached.position, unit),
            format!("First derivative within {first} {unit}/{per}, second within {second} {unit}/{per}^2."),
            format!("Checked against the solver at {SAMPLES} Chebyshev points a segment; a bound for smooth motions, not a proof."),
            format!("{} of degree {}, {bytes} bytes.", counted(count, "segment"), TERMS - 1),
        ]);
        lines
    }

    /// The coefficients with one power per line, in the brackets of a language.
    fn coefficients(&self, brackets: [&str; 2]) -> String {
        let [open, close] = brackets;
        let line = |numbers: &Vec<f64>| format!("        {},\n", row(numbers, brackets));
        let segment = |rows: [Vec<f64>; TERMS]| {
            let rows: String = rows.iter().map(line).collect();
            format!("    {open}\n{rows}    {close},\n")
        };
        self.baked.rows().map(segment).collect()
    }
}
