//! Assemblies as text and as rows of a table.

use crate::assemblies::PartTally;
use crate::commands::assemblies::search::Listed;
use crate::file::Dimension;
use crate::kinematics::Assembly;
use crate::mechanism::{Names, Unit};
use crate::number::number;
use crate::output::file_table::Column;
use crate::output::text_table::{TextColumn, laid_out};
use crate::quantities::{self, CAMBER, CENTRE, DRIVES, MARKERS, POSITIONS, Quantity, TOE};

/// Returns the columns of the table with one assembly per row.
pub(super) fn columns(names: &Names, unit: Unit) -> Vec<Column<Assembly>> {
    let of_state = |quantities: &[&'static Quantity]| {
        let columns = quantities::columns(quantities.iter().copied(), names).into_iter();
        let columns = columns.filter(|column| column.dimension.is_of_positions());
        columns.map(|column| Column::of_state(column, unit, |assembly: &Assembly| &assembly.state))
    };
    let symbol = unit.symbol();
    let mut columns: Vec<_> = of_state(&[&DRIVES]).collect();
    columns.extend([
        Column::of_counts("assembly", |assembly: &Assembly| assembly.number as f64),
        Column::new(format!("distance_{symbol}"), |assembly| assembly.distance),
        Column::new(format!("farthest_{symbol}"), |assembly| assembly.farthest),
        Column::of_counts("mirrored", |assembly| assembly.mirrored.len() as f64),
        Column::new("smallest_singular_value", |assembly| {
            assembly.smallest_singular_value
        }),
    ]);
    columns.extend(of_state(&[&CAMBER, &TOE, &POSITIONS, &MARKERS]));
    columns
}

/// Returns the table of assemblies, and a sentence on whether the list is complete.
pub(super) fn text(names: &Names, unit: Unit, listed: &Listed) -> String {
    let table = match listed.assemblies.as_slice() {
        [] => "  no assembly: the mechanism cannot be put together there\n".to_owned(),
        assemblies => laid_out(2, text_columns(names, unit, assemblies)),
    };
    let drives = &listed.drives_in_words;
    format!("At {drives}:\n\n{table}\n{}", certainty(listed))
}

fn text_columns(names: &Names, unit: Unit, assemblies: &[Assembly]) -> Vec<TextColumn> {
    let each = || assemblies.iter();
    let length = |name: &str, value: fn(&Assembly) -> f64| {
        let values = each().map(value);
        TextColumn::values(values, Dimension::Length, unit)
            .headed(format!("{name} ({})", unit.symbol()))
    };
    let wheel = quantities::columns([&CENTRE, &CAMBER], names).into_iter();
    let wheel = wheel.map(|column| {
        let values = each().map(|assembly| column.value(&assembly.state));
        let (_, symbol) = column.dimension.display_scale(unit);
        let heading = format!("{} ({symbol})", column.heading());
        TextColumn::values(values, column.dimension, unit).headed(heading)
    });
    let singular_values =
        each().map(|assembly| format!("{:.1e}", assembly.smallest_singular_value));
    let mirrored = each().map(|assembly| match assembly.mirrored.as_slice() {
        [] => "        -".to_owned(),
        points => format!("{:>9}", points.join(" ")),
    });
    let mut columns = vec![
        TextColumn::right(each().map(|assembly| assembly.number)).headed(" assembly"),
        length("distance", |assembly| assembly.distance),
        length("farthest", |assembly| assembly.farthest),
        TextColumn::right(singular_values).headed("smallest singular value"),
    ];
    columns.extend(wheel);
    // A long list of names continues to the right of the heading.
    columns.push(TextColumn::left(mirrored).headed(" mirrored"));
    columns
}

/// Says whether the list is complete, and why.
fn certainty(listed: &Listed) -> String {
    let tally = &listed.tally;
    let verdict = match tally.doubts().as_slice() {
        [] => "The list is complete by all that was tried".to_owned(),
        doubts => format!("The list may not be complete ({})", doubts.join("; ")),
    };
    let turned = match tally.turned {
        0 => String::new(),
        count => format!(" ({count} more at other quarters of a driven angle)"),
    };
    let real = format!("{} real{turned}", tally.real);
    match tally.parts.as_slice() {
        [] => format!("{verdict}:\n{real}; all equations are linear.\n"),
        [part] => format!(
            "{verdict}:\n{real} and {}{WORDS}",
            part_summary(part, "a mechanism")
        ),
        parts => {
            let count = parts.len();
            let lines: String = parts.iter().map(one_of_several).collect();
            format!(
                "{verdict}:\n{real} assemblies, put together part by part, in {count} parts:\n{lines}{WORDS}"
            )
        }
    }
}

/// The explanation of the counts.
const WORDS: &str = "\
Only real assemblies can be built. The coordinates of a complex assembly are complex numbers; those of one at infinity
grow without bound as general dimensions change to those of the file. They are counted too, because the trace test
is of all assemblies together: it fails if one is missing.\n";

fn one_of_several(part: &PartTally) -> String {
    let times = match part.times {
        1 => String::new(),
        times => format!(", with each of {times} assemblies of the parts that it needs"),
    };
    let names = part.unknowns.join(", ");
    let rest = part_summary(part, "a part").replace('\n', "\n  ");
    format!(
        "- {names}{times}:\n  {} real and {}\n",
        part.real,
        rest.trim_end()
    )
}

/// Says for one part how many assemblies are not real, and whether its count is complete.
fn part_summary(part: &PartTally, whole: &str) -> String {
    let unconfirmed = match part.unconfirmed {
        0 => String::new(),
        count => format!(" (it is not known whether {count} beside a fold are real or complex)"),
    };
    let evidence = &part.evidence;
    let trace = match evidence.trace {
        Some(bend) if bend.is_finite() => {
            format!("the trace test leaves {} of a straight line", rounded(bend))
        }
        Some(_) => "the trace test lost one of them on its way".to_owned(),
        None => {
            "the trace test does not apply, as nothing gives a free point's coordinate".to_owned()
        }
    };
    let loops = match evidence.loops {
        1 => "one loop".to_owned(),
        loops => format!("{loops} loops, the last {}", evidence.quiet),
    };
    let loops = match evidence.ended_after {
        None => format!("{loops} without a\nnew one; {trace}"),
        Some(paths) => format!("{loops} without a\nnew one, ended after {paths} paths"),
    };
    let times = match part.times {
        0 | 1 => String::new(),
        times => format!("{times} times "),
    };
    format!(
        "{} complex assemblies, {} at infinity, \
         {} not accounted for{unconfirmed},\nof {times}the {} that such {whole} has with general \
         dimensions ({} random starts, {loops}).\n",
        part.complex,
        part.infinite,
        part.unaccounted(),
        part.generic,
        evidence.starts,
    )
}

fn rounded(bend: f64) -> String {
    if bend.is_finite() {
        format!("{bend:.0e}")
    } else {
        number(bend)
    }
}
