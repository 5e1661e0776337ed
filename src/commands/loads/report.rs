//! What a load case does, for people.

use std::fmt::Write;

use suspension_core::listing::{DriveKind, MeasureKind};

use crate::commands::loads::found::Found;
use crate::loads::{Outcome, Structure};
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
        let Report {
            file, mechanism, ..
        } = self;
        let (case, outcomes) = (found.case, found.all());
        let places = match outcomes.len() {
            1 => "one place".to_owned(),
            several => format!("least and greatest of {several} places"),
        };
        let axes = mechanism.axes.in_words();
        let mut out = format!(
            "{file}: load case {}, {places}; axes of {axes}\n\n",
            case.name
        );
        let drives = mechanism.names.drives.iter().enumerate();
        let drives = drives.map(|(number, drive)| {
            let loads = outcomes.iter().map(|outcome| outcome.on_drives[number]);
            line(drive.name.clone(), loads, unit_of(drive))
        });
        table(&mut out, "drive", "bears", drives.collect());
        let bearing = found.first.in_measures.iter().enumerate();
        let bearing = bearing.map(|(number, (measure, _))| {
            let loads = outcomes.iter().map(|outcome| outcome.in_measures[number].1);
            let measure = &mechanism.names.measures[*measure];
            line(measure.name.clone(), loads, unit_in(measure))
        });
        table(&mut out, "measure", "bears", bearing.collect());
        let statements = &self.structure.statements;
        let links = found.first.links.iter().enumerate();
        let links = links.map(|(number, (statement, _))| {
            let forces = outcomes.iter().map(|outcome| outcome.links[number].1);
            line(statements[*statement].name.to_owned(), forces, "N")
        });
        table(&mut out, "link", "tension", links.collect());
        table(
            &mut out,
            "joint",
            joints_in_words(&outcomes),
            self.joints(&outcomes),
        );
        out.push_str(&near_a_lock(&outcomes));
        out
    }

    /// Of one place the components, of several the sizes.
    fn joints(&self, outcomes: &[&Outcome]) -> Vec<Line> {
        let joints = outcomes[0].joints.iter().enumerate();
        let joints = joints.map(|(number, (statement, point, force))| {
            let point = &self.mechanism.names.points[*point];
            let name = format!("{} at {point}", self.structure.statements[*statement].name);
            match outcomes {
                [_] => Line {
                    name,
                    numbers: force.iter().copied().collect(),
                    between: "  ",
                    unit: "N",
                },
                several => {
                    let sizes = several
                        .iter()
                        .map(|outcome| outcome.joints[number].2.norm());
                    line(name, sizes, "N")
                }
            }
        });
        joints.collect()
    }
}

/// A note where forces inside are so large that a lock must be near.
fn near_a_lock(outcomes: &[&Outcome]) -> String {
    /// Arms and rockers make forces several times as large as the load.
    const MANY: f64 = 100.0;
    let each = outcomes.iter().map(|outcome| outcome.amplification());
    let most = each.fold(0.0, f64::max);
    if most < MANY {
        return String::new();
    }
    format!(
        "The largest force inside is {most:.0} times the largest load: the mechanism is near a position where it locks.\n\n"
    )
}

fn joints_in_words(outcomes: &[&Outcome]) -> &'static str {
    match outcomes {
        [_] => "force along x, y and z",
        _ => "size of the force",
    }
}

/// A name with numbers in a unit.
struct Line {
    name: String,
    numbers: Vec<f64>,
    between: &'static str,
    unit: &'static str,
}

/// The value at one place, or the least and the greatest of several.
fn line(name: String, values: impl Iterator<Item = f64> + Clone, unit: &'static str) -> Line {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    let greatest = values.clone().fold(f64::NEG_INFINITY, f64::max);
    let numbers = match values.count() {
        1 => vec![least],
        _ => vec![least, greatest],
    };
    Line {
        name,
        numbers,
        between: " to ",
        unit,
    }
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
