//! What a load case does, for people.

use std::fmt::Write;

use suspension_core::listing::{DriveKind, MeasureKind};

use crate::commands::loads::found::Found;
use crate::loads::Structure;
use crate::mechanism::{Description, Drive, Measure};
use crate::number::{aligned, fixed};

/// Decimals of a force: a tenth of a newton.
const DECIMALS: usize = 1;

/// What the text is about.
pub(super) struct Report<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a Description,
    pub(super) structure: &'a Structure<'a>,
}

impl Report<'_> {
    /// A case at all places that have an answer.
    pub(super) fn text(&self, found: &Found<'_>) -> String {
        let Self {
            file,
            mechanism,
            structure,
        } = self;
        let (case, first, names) = (found.case, &found.first, &mechanism.names);
        let places = match found.places {
            1 => "one place".to_owned(),
            several => format!("least and greatest of {several} places"),
        };
        let axes = mechanism.axes.in_words();
        let mut out = format!(
            "{file}: load case {}, {places}; axes of {axes}\n\n",
            case.name
        );
        let mut ranges = found.ranges.iter();
        let mut line = |name: &str, unit| {
            let range = ranges.next();
            let numbers = range.map_or(&[][..], |range| &range[..found.places.min(2)]);
            Line {
                name: name.to_owned(),
                numbers: numbers.to_vec(),
                between: " to ",
                unit,
            }
        };
        let drives = names.drives.iter();
        let drives = drives.map(|drive| line(&drive.name, unit_of(drive)));
        table(&mut out, "drive", "bears", drives.collect());
        let bearing = first.in_measures.iter().map(|(measure, _)| {
            let measure = &names.measures[*measure];
            line(&measure.name, unit_in(measure))
        });
        table(&mut out, "measure", "bears", bearing.collect());
        let links = first.links.iter();
        let links = links.map(|(statement, _)| line(structure.statements[*statement].name, "N"));
        table(&mut out, "link", "tension", links.collect());
        let joints = first.joints.iter().map(|(statement, point, force)| {
            let statement = structure.statements[*statement].name;
            let of_several = line(&format!("{statement} at {}", names.points[*point]), "N");
            match found.places {
                1 => Line {
                    numbers: force.iter().copied().collect(),
                    between: "  ",
                    ..of_several
                },
                _ => of_several,
            }
        });
        let heading = match found.places {
            1 => "force along x, y and z",
            _ => "size of the force",
        };
        table(&mut out, "joint", heading, joints.collect());
        out.push_str(&near_a_lock(found.amplification));
        out
    }
}

/// A note where forces inside are so large that a lock must be near.
fn near_a_lock(most: f64) -> String {
    /// Arms and rockers make forces several times as large as the load.
    const MANY: f64 = 100.0;
    if most < MANY {
        return String::new();
    }
    format!(
        "The largest force inside is {most:.0} times the largest load: the mechanism is near a position where it locks.\n\n"
    )
}

/// A name with numbers in a unit: the value at one place, or the least and the greatest of several.
struct Line {
    name: String,
    numbers: Vec<f64>,
    between: &'static str,
    unit: &'static str,
}

/// The unit of what a measure bears.
pub(super) fn unit_in(measure: &Measure) -> &'static str {
    match measure.kind {
        MeasureKind::Angle => "N m",
        MeasureKind::Length => "N",
    }
}

/// The unit of what a drive bears.
pub(super) fn unit_of(drive: &Drive) -> &'static str {
    match drive.kind {
        DriveKind::Angle | DriveKind::Turn => "N m",
        DriveKind::Coordinate => "N",
    }
}

/// Lines under a heading, with decimal points below each other.
fn table(out: &mut String, what: &str, heading: &str, lines: Vec<Line>) {
    let Some(first) = lines.first() else {
        return;
    };
    let column = |number: usize| {
        let numbers = lines
            .iter()
            .map(|line| fixed(line.numbers[number], DECIMALS));
        aligned(numbers.collect(), [' ', ' '])
    };
    let columns: Vec<Vec<String>> = (0..first.numbers.len()).map(column).collect();
    let names = lines.iter().map(|line| line.name.len());
    let width = names.chain([what.len()]).max().unwrap_or(0);
    // Writing into a string has no way to fail.
    let _ = writeln!(out, "{what:width$}  {heading}");
    for (number, line) in lines.iter().enumerate() {
        let numbers: Vec<&str> = columns
            .iter()
            .map(|column| column[number].as_str())
            .collect();
        let numbers = numbers.join(line.between);
        let _ = writeln!(out, "{:width$}  {numbers} {}", line.name, line.unit);
    }
    out.push('\n');
}
