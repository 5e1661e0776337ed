//! A baked motion as a file that people read and compilers take.

mod c;
mod rust;
mod toml;

use std::path::Path;

use crate::bake::certify::SAMPLES;
use crate::bake::driven::Output;
use crate::bake::fit::Baked;
use crate::bake::scheme::{Continuity, TERMS};
use crate::number::{exact, rounded};

/// The language of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// A `static` of `suspension_core::baked::Curve`.
    Rust,
    /// A header in C99 with a function that evaluates.
    C,
    /// The numbers alone.
    Toml,
}

impl Language {
    /// The ending of a file's name.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Rust => "rs",
            Self::C => "h",
            Self::Toml => "toml",
        }
    }
}

/// A baked motion and what its numbers mean.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The curve.
    pub baked: Baked,
    /// The file that it was baked from.
    pub file: String,
    /// The linkage's name.
    pub linkage: String,
    /// The drive's name.
    pub drive: String,
    /// The drive's unit.
    pub drive_unit: &'static str,
    /// The unit of lengths.
    pub unit: &'static str,
    /// Where the axes point.
    pub axes: &'static str,
    /// Drives that are held, in words; empty where there is one drive only.
    pub held: String,
}

impl Sheet {
    /// What by which drive.
    pub fn subject(&self) -> String {
        let what = match self.baked.outputs.first() {
            Some(Output::Point(_)) => "points",
            _ => "wheel",
        };
        format!("{what}_by_{}", self.drive)
    }

    /// The curve's name in a file: the file's own, so that two files in one program differ.
    fn name(&self, path: &Path) -> String {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let letter = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let mut name: String = stem.chars().map(letter).collect();
        let subject = self.subject();
        if !name.contains(&subject) {
            name = format!("{name}_{subject}");
        }
        if name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            name
        } else {
            format!("baked_{name}")
        }
    }

    /// The text of a file at a path.
    pub fn text(&self, language: Language, path: &Path) -> String {
        let name = self.name(path);
        match language {
            Language::Rust => rust::text(self, &name),
            Language::C => c::text(self, &name),
            Language::Toml => toml::text(self, &name),
        }
    }

    /// How many numbers the outputs are.
    fn width(&self) -> usize {
        3 * self.baked.outputs.len()
    }

    /// The numbers' names, in order.
    fn output_names(&self) -> Vec<String> {
        let coordinates = |output: &Output| {
            let name = output.name();
            ["x", "y", "z"].map(|axis| format!("{name}_{axis}"))
        };
        self.baked.outputs.iter().flat_map(coordinates).collect()
    }

    /// What a reader needs to know, line by line.
    fn header(&self) -> Vec<String> {
        let Self {
            baked,
            file,
            linkage,
            drive,
            drive_unit,
            unit,
            axes,
            held,
        } = self;
        let [from, to] = baked.wanted.range.map(exact);
        let count = baked.segments.len();
        let what = match baked.outputs.first() {
            Some(Output::Point(_)) => format!("{} points", baked.outputs.len()),
            _ => "wheel centre and spin axis (unit length, outboard)".to_owned(),
        };
        let joined = match baked.wanted.continuity {
            Continuity::Position => "position",
            Continuity::Velocity => "position and first derivative",
            Continuity::Acceleration => "position, first and second derivative",
        };
        let Reach {
            position,
            first,
            second,
        } = Reach::of(baked);
        let bytes = count * TERMS * self.width() * size_of::<f64>();
        let mut lines = vec![
            format!("The {what} of {linkage} as a function of drive {drive}."),
            format!("Baked by `suspension bake` from {file}."),
            String::new(),
            format!("Drive: {drive} from {from} to {to} {drive_unit}."),
        ];
        if !held.is_empty() {
            lines.push(format!("Held: {held}."));
        }
        lines.extend([
            format!("Lengths in {unit}; axes {axes}."),
            format!("Continuous where segments join: {joined}."),
            format!("Tolerance asked: {} {unit}; reached: {position} {unit}.", rounded(baked.wanted.tolerance, 3)),
            format!("First derivative within {first} {unit}/{drive_unit}, second within {second} {unit}/{drive_unit}^2."),
            format!("The spin axis counts as a point 1 m from the wheel centre. Checked against the solver at {SAMPLES}"),
            "Chebyshev points a segment; a bound for smooth motions, not a proof.".to_owned(),
            format!("{count} segments of degree {}, {bytes} bytes.", TERMS - 1),
        ]);
        lines
    }

    /// The coefficients with one power a line, in the brackets of a language.
    fn coefficients(&self, [open, close]: [&str; 2]) -> String {
        let row = |row: &Vec<f64>| {
            let numbers: Vec<String> = row.iter().map(|x| format!("{x:?}")).collect();
            format!("        {open}{}{close},\n", numbers.join(", "))
        };
        let segment = |rows: [Vec<f64>; TERMS]| {
            let rows: String = rows.iter().map(row).collect();
            format!("    {open}\n{rows}    {close},\n")
        };
        self.baked.rows().map(segment).collect()
    }
}

/// What is reached, rounded up to two digits: still bounds.
struct Reach {
    position: String,
    first: String,
    second: String,
}

impl Reach {
    fn of(baked: &Baked) -> Self {
        let [position, first, second] = {
            let reached = baked.reached;
            [reached.position, reached.first, reached.second].map(|bound| {
                // Rounding to two digits takes off at most one part in twenty.
                let digits = rounded(bound, 2);
                match digits.parse::<f64>() {
                    Ok(below) if below < bound => rounded(bound * 1.05, 2),
                    _ => digits,
                }
            })
        };
        Self {
            position,
            first,
            second,
        }
    }
}
