//! The summary of a motion.

use std::fmt::Write;

use crate::mechanism::{Description, Unit};
use crate::number::counted;
use crate::output::motion::record::Outcome;
use crate::output::text_table::{TextColumn, in_parts};

use crate::quantities::{Shown, WIDTH, catalogue, columns};

/// Returns the catalogue's quantities at the kept instants, and the totals.
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
    let columns = columns.filter(|column| column.quantity.shown != Shown::InTables);
    let mut columns = columns.map(|column| {
        let values = kept.iter().map(|state| column.value(state));
        let (_, symbol) = column.dimension.display_scale(unit);
        let cells = TextColumn::values(values, column.dimension, unit);
        cells.headed_with_unit(&column.heading(), &symbol)
    });
    let time = columns.next();
    let table = time.map(|time| in_parts(2, WIDTH, &time, columns.collect()));
    let table = table.unwrap_or_default();
    let mut out = format!("Linkage {linkage}, axes of {}\n\n{table}", axes.in_words());
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

/// Returns a sentence on the solver's iterations and residual.
pub fn totals(outcome: &Outcome, unit: Unit) -> String {
    format!(
        "Newton iterations: {} for {}, at most {} for one, steps in between included\nLargest residual: {:.1e} {}\n",
        outcome.iterations,
        counted(outcome.solved, "instant"),
        outcome.most_iterations,
        outcome.residual,
        unit.symbol(),
    )
}
