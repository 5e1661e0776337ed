//! The comments of a baked file about itself, for any drives.

use std::path::Path;

use crate::bake::driven::Output;
use crate::mechanism::Length;
use crate::number::{counted, exact};

/// The meaning of the numbers of a baked file.
#[derive(Clone, Debug)]
pub struct About {
    /// The file that it was baked from.
    pub file: String,
    /// The linkage's name.
    pub linkage: String,
    /// The name of the wheel.
    pub wheel: String,
    /// The drives, or the measure, of which the outputs are functions.
    pub arguments: Vec<Ranged>,
    /// The unit of lengths.
    pub unit: Length,
    /// The directions of the axes.
    pub axes: &'static str,
    /// The drives that are held, in words; empty if there are no others.
    pub held: String,
}

/// A drive over its baked range, or a measure.
#[derive(Clone, Debug)]
pub struct Ranged {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Its first and last value.
    pub range: [f64; 2],
    /// The drive that a measure stands in for.
    pub in_place_of: Option<Replaced>,
}

/// A drive in whose place a measure leads.
#[derive(Clone, Debug)]
pub struct Replaced {
    /// Its name.
    pub drive: String,
    /// Its value at the position from which the measure leads, in words. The measure may have the same values elsewhere.
    pub start: String,
}

impl Ranged {
    /// Its kind: a drive or a measure.
    pub(super) fn kind(&self) -> &'static str {
        match self.in_place_of {
            None => "drive",
            Some(_) => "measure",
        }
    }

    fn in_words(&self) -> String {
        let [from, to] = self.range.map(exact);
        format!("{} from {from} to {to} {}", self.name, self.unit)
    }

    fn line(&self) -> String {
        let range = self.in_words();
        match &self.in_place_of {
            None => format!("Drive: {range}."),
            Some(Replaced { drive, start }) => {
                format!("Measure: {range}, in place of drive {drive}, on the branch of {start}.")
            }
        }
    }
}

impl About {
    /// A description of the outputs and the drives.
    pub(super) fn subject(&self, outputs: &[Output]) -> String {
        let what = match outputs.first() {
            Some(Output::Point(_)) => "points",
            _ => "wheel",
        };
        format!("{what}_by_{}", self.names().join("_and_"))
    }

    /// The drives with their ranges.
    pub fn ranges_in_words(&self) -> String {
        let ranges: Vec<String> = self.arguments.iter().map(Ranged::in_words).collect();
        ranges.join(" and ")
    }

    fn names(&self) -> Vec<&str> {
        let arguments = self.arguments.iter();
        arguments.map(|argument| argument.name.as_str()).collect()
    }

    /// The table's name in a file: the file's own, so that two files in one program differ.
    pub(super) fn name(&self, outputs: &[Output], path: &Path) -> String {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let letter = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let mut name: String = stem.chars().map(letter).collect();
        let subject = self.subject(outputs);
        if !name.contains(&subject) {
            name = format!("{name}_{subject}");
        }
        if name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            name
        } else {
            format!("baked_{name}")
        }
    }

    /// The first lines: the outputs, their source, and the ranges.
    pub(super) fn header(&self, outputs: &[Output]) -> Vec<String> {
        let what = match outputs.first() {
            Some(Output::Point(_)) => counted(outputs.len(), "point"),
            _ => format!(
                "{} centre and spin axis (unit length, outboard)",
                self.wheel
            ),
        };
        let kind = match self.arguments.as_slice() {
            [argument] => argument.kind(),
            _ => "drives",
        };
        let mut lines = vec![
            format!(
                "The {what} of {} as a function of {kind} {}.",
                self.linkage,
                self.names().join(" and ")
            ),
            format!("Baked by `suspension bake` from {}.", self.file),
            String::new(),
        ];
        lines.extend(self.arguments.iter().map(Ranged::line));
        if !self.held.is_empty() {
            lines.push(format!("Held: {}.", self.held));
        }
        lines.push(format!(
            "Lengths in {}; axes {}.",
            self.unit.in_words(),
            self.axes
        ));
        if outputs.contains(&Output::SpinAxis) {
            lines.push("The spin axis counts as a point 1 m from the wheel centre.".to_owned());
        }
        lines
    }
}

/// The numbers' names, in order.
pub(super) fn output_names(outputs: &[Output]) -> Vec<String> {
    let coordinates = |output: &Output| {
        let name = output.name();
        ["x", "y", "z"].map(|axis| format!("{name}_{axis}"))
    };
    outputs.iter().flat_map(coordinates).collect()
}

/// Lines after a comment mark.
pub(super) fn commented(mark: &str, lines: &[String]) -> String {
    let line = |line: &String| format!("{}\n", format!("{mark} {line}").trim_end());
    lines.iter().map(line).collect()
}

/// A row of numbers in the brackets of a language.
pub(super) fn row(numbers: &[f64], [open, close]: [&str; 2]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|x| format!("{x:?}")).collect();
    format!("{open}{}{close}", numbers.join(", "))
}
