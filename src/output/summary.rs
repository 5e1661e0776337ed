//! A motion in a few lines of text.

use std::fmt::Write;

use crate::mechanism::{Description, Unit};
use crate::number::fixed;
use crate::output::record::Outcome;
use crate::quantities::{Column, Shown, catalogue, columns};

/// The catalogue's quantities at the kept instants, and the totals.
pub fn text(mechanism: &Description, outcome: &Outcome) -> String {
    let Description {
        linkage,
        names,
        unit,
        axes,
        ..
    } = mechanism;
    let unit = *unit;
    let kept = &outcome.kept;
    let columns = columns(catalogue(), names).into_iter();
    let columns: Vec<Column> = columns
        .filter(|column| column.quantity.shown != Shown::InTables)
        .collect();
    let headings: Vec<String> = columns.iter().map(|column| column.heading(unit)).collect();
    let width = |heading: &String| heading.len().max(9);
    let mut out = format!("Linkage {linkage}, axes of {}\n\n", axes.in_words());
    for heading in &headings {
        let _ = write!(out, "  {heading:>0$}", width(heading));
    }
    out.push('\n');
    for state in kept {
        for (column, heading) in columns.iter().zip(&headings) {
            let (scale, _) = column.dimension.for_people(unit);
            let decimals = column.dimension.decimals(unit);
            let value = column.value(state) * scale;
            let _ = write!(out, "  {:>1$}", fixed(value, decimals), width(heading));
        }
        out.push('\n');
    }
    if kept.len() < outcome.solved {
        let _ = writeln!(
            out,
            "  ({} of {} instants; --csv writes all)",
            kept.len(),
            outcome.solved
        );
    }
    let _ = write!(out, "\n{}", totals(outcome, unit));
    out
}

/// What the solver did.
pub fn totals(outcome: &Outcome, unit: Unit) -> String {
    format!(
        "Newton iterations: {} for {} instant{}, at most {} for one, steps in between included\nLargest residual: {:.1e} {}\n",
        outcome.iterations,
        outcome.solved,
        if outcome.solved == 1 { "" } else { "s" },
        outcome.most_iterations,
        outcome.residual,
        unit.symbol(),
    )
}
