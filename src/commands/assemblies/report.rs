//! Assemblies as text and as rows of a table.

use std::fmt::Write;

use crate::assemblies::PartTally;
use crate::commands::assemblies::listed::Listed;
use crate::file::Dimension;
use crate::kinematics::Assembly;
use crate::mechanism::{Names, Unit};
use crate::number::{fixed, number};
use crate::output::table::Column;
use crate::quantities::{self, CAMBER, CENTRE, DRIVES, MARKERS, POSITIONS, Quantity, TOE};

/// The columns of a table, one row an assembly.
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
        Column::new("smallest_pivot", |assembly| assembly.smallest_pivot),
    ]);
    columns.extend(of_state(&[&CAMBER, &TOE, &POSITIONS, &MARKERS]));
    columns
}

/// Assemblies for people.
pub(super) struct Report {
    unit: Unit,
    /// What is shown of the wheel.
    wheel: Vec<quantities::Column>,
}

impl Report {
    pub(super) fn new(names: &Names, unit: Unit) -> Self {
        let wheel = quantities::columns([&CENTRE, &CAMBER], names);
        Self { unit, wheel }
    }

    /// The assemblies in a table, and how sure it is that they are all.
    pub(super) fn text(&self, listed: &Listed) -> String {
        let mut out = format!("At {}:\n\n", listed.drives_in_words);
        if listed.assemblies.is_empty() {
            let _ = write!(
                out,
                "  no assembly: the mechanism cannot be put together there\n\n{}",
                certainty(listed)
            );
            return out;
        }
        let headings = self.headings();
        let widths: Vec<_> = headings
            .iter()
            .map(|heading| heading.len().max(9))
            .collect();
        for (heading, width) in headings.iter().zip(&widths) {
            let _ = write!(out, "  {heading:>width$}");
        }
        out.push('\n');
        for assembly in &listed.assemblies {
            for (cell, width) in self.cells(assembly).iter().zip(&widths) {
                let _ = write!(out, "  {cell:>width$}");
            }
            out.push('\n');
        }
        let _ = write!(out, "\n{}", certainty(listed));
        out
    }

    fn headings(&self) -> Vec<String> {
        let symbol = self.unit.symbol();
        let mut headings = vec![
            "assembly".to_owned(),
            format!("distance ({symbol})"),
            format!("farthest ({symbol})"),
            "smallest pivot".to_owned(),
        ];
        headings.extend(self.wheel.iter().map(|column| column.heading(self.unit)));
        headings.push("mirrored".to_owned());
        headings
    }

    fn cells(&self, assembly: &Assembly) -> Vec<String> {
        let written = |dimension: Dimension, value: f64| {
            let (scale, _) = dimension.for_people(self.unit);
            let decimals = dimension.decimals(self.unit);
            fixed(value * scale, decimals)
        };
        let mut cells = vec![
            assembly.number.to_string(),
            written(Dimension::Length, assembly.distance),
            written(Dimension::Length, assembly.farthest),
            format!("{:.1e}", assembly.smallest_pivot),
        ];
        let wheel = self.wheel.iter();
        cells.extend(wheel.map(|column| written(column.dimension, column.value(&assembly.state))));
        cells.push(match assembly.mirrored.as_slice() {
            [] => "-".to_owned(),
            points => points.join(" "),
        });
        cells
    }
}

/// How sure it is that the list is complete, and why.
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
        [part] => format!("{verdict}:\n{real} and {}", of_part(part, "a mechanism")),
        parts => {
            let count = parts.len();
            let lines: String = parts.iter().map(one_of_several).collect();
            format!(
                "{verdict}:\n{real} assemblies, put together part by part, in {count} parts:\n{lines}"
            )
        }
    }
}

fn one_of_several(part: &PartTally) -> String {
    let times = match part.times {
        1 => String::new(),
        times => format!(", with each of {times} assemblies of the parts that it needs"),
    };
    let names = part.unknowns.join(", ");
    let rest = of_part(part, "a part").replace('\n', "\n  ");
    format!(
        "- {names}{times}:\n  {} real and {}\n",
        part.real,
        rest.trim_end()
    )
}

/// What became of the assemblies of a part that are not real, and how sure it is.
fn of_part(part: &PartTally, whole: &str) -> String {
    let unconfirmed = match part.unconfirmed {
        0 => String::new(),
        count => format!(" ({count} beside a fold, real or complex is not to be told)"),
    };
    let evidence = &part.evidence;
    let trace = match evidence.trace {
        Some(bend) => format!("the trace test leaves {} of a straight line", rounded(bend)),
        None => {
            "the trace test does not apply, as nothing gives a free point's coordinate".to_owned()
        }
    };
    let loops = match evidence.loops {
        1 => "one loop".to_owned(),
        loops => format!("{loops} loops, the last {}", evidence.quiet),
    };
    let times = match part.times {
        0 | 1 => String::new(),
        times => format!("{times} times "),
    };
    format!(
        "{} complex assemblies, {} at infinity, \
         {} not accounted for{unconfirmed},\nof {times}the {} that such {whole} has with general \
         lengths ({} random starts, {loops} without a\nnew one; {trace}).\n",
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
