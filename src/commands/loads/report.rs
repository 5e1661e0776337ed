//! What a load case does, for people.

use suspension_core::listing::{DriveKind, MeasureKind};

use crate::commands::loads::found::Found;
use crate::loads::Structure;
use crate::mechanism::{Description, Drive, Measure};
use crate::number::fixed;
use crate::output::text_table::{TextColumn, laid_out};

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
        let (places, between) = match found.places {
            1 => ("one place".to_owned(), "  "),
            several => (format!("least and greatest of {several} places"), " to "),
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
                unit,
            }
        };
        let mut table = |headings, lines: Vec<Line>| table(&mut out, between, headings, &lines);
        let drives = names.drives.iter();
        let drives = drives.map(|drive| line(&drive.name, unit_of(drive)));
        table(["drive", "bears"], drives.collect());
        let bearing = first.in_measures.iter().map(|(measure, _)| {
            let measure = &names.measures[*measure];
            line(&measure.name, unit_in(measure))
        });
        table(["measure", "bears"], bearing.collect());
        let links = first.links.iter();
        let links = links.map(|(statement, _)| line(structure.statements[*statement].name, "N"));
        table(["link", "tension"], links.collect());
        let joints = first.joints.iter().map(|(statement, point, force)| {
            let statement = structure.statements[*statement].name;
            let of_several = line(&format!("{statement} at {}", names.points[*point]), "N");
            match found.places {
                1 => Line {
                    numbers: force.iter().copied().collect(),
                    ..of_several
                },
                _ => of_several,
            }
        });
        let heading = match found.places {
            1 => "force along x, y and z",
            _ => "size of the force",
        };
        table(["joint", heading], joints.collect());
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

/// Lines under a heading, with decimal points below each other and their numbers apart by what is between them.
fn table(out: &mut String, between: &str, [what, heading]: [&str; 2], lines: &[Line]) {
    let column = |number: usize| {
        let numbers = lines.iter().map(|line| line.numbers[number]);
        TextColumn::numbers(numbers.map(|number| fixed(number, DECIMALS)))
    };
    let numbers = 0..lines.first().map_or(0, |line| line.numbers.len());
    let numbers = numbers.map(column);
    let Some(numbers) = numbers.reduce(|column, next| column.then(between, next)) else {
        return;
    };
    let names = TextColumn::left(lines.iter().map(|line| &line.name));
    let units = TextColumn::left(lines.iter().map(|line| line.unit));
    let numbers = numbers.then(" ", units).under(heading);
    out.push_str(&laid_out(0, [names.under(what), numbers]));
    out.push('\n');
}
