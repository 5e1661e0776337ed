//! A sweep in a few lines of text.

use std::fmt::Write;

use crate::input::file::Unit;
use crate::study::Study;
use crate::study::sweep::{Outcome, Rows};

/// The wheel at the kept instants, and the totals.
pub fn text(study: &dyn Study, outcome: &Outcome) -> String {
    let unit = study.unit();
    let kept = &outcome.kept;
    let columns = columns(study);
    let widths: Vec<usize> = columns.iter().map(|c| c.heading.len().max(9)).collect();
    let mut out = format!("Linkage {}\n\n", study.linkage());
    for (column, width) in columns.iter().zip(&widths) {
        let _ = write!(out, "  {:>width$}", column.heading);
    }
    out.push('\n');
    let values: Vec<Vec<f64>> = columns.iter().map(|c| c.values(kept)).collect();
    for row in 0..kept.rows.len() {
        for ((column, width), values) in columns.iter().zip(&widths).zip(&values) {
            let _ = write!(out, "  {:>width$.*}", column.digits, values[row]);
        }
        out.push('\n');
    }
    if kept.rows.len() < outcome.solved {
        let _ = writeln!(
            out,
            "  ({} of {} instants; --csv writes all)",
            kept.rows.len(),
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

struct ColumnOfText {
    heading: String,
    source: String,
    scale: f64,
    digits: usize,
}

impl ColumnOfText {
    fn values(&self, rows: &Rows) -> Vec<f64> {
        let values = rows.column(&self.source).unwrap_or_default();
        values.into_iter().map(|value| value * self.scale).collect()
    }
}

fn columns(study: &dyn Study) -> Vec<ColumnOfText> {
    let unit = study.unit();
    let degrees = 1_f64.to_degrees();
    let column = |heading: String, source: String, scale, digits| ColumnOfText {
        heading,
        source,
        scale,
        digits,
    };
    let digits = match unit {
        Unit::Metre => 5,
        Unit::Millimetre => 2,
    };
    let names = study.columns();
    let centre = study.points().wheel_centre;
    let mut columns = vec![column("t (s)".into(), "t_s".into(), 1.0, 4)];
    let drives = names
        .iter()
        .skip(1)
        .take_while(|name| !name.ends_with("_x"));
    let quantity = |name: &String| match name.rsplit_once('_') {
        Some((name_alone, "rad")) => {
            column(format!("{name_alone} (deg)"), name.clone(), degrees, 3)
        }
        Some((name_alone, unit)) => {
            column(format!("{name_alone} ({unit})"), name.clone(), 1.0, digits)
        }
        None => column(name.clone(), name.clone(), 1.0, digits),
    };
    columns.extend(drives.map(quantity));
    for axis in ["x", "y", "z"] {
        let heading = format!("centre {axis} ({})", unit.symbol());
        columns.push(column(heading, format!("{centre}_{axis}"), 1.0, digits));
    }
    for angle in ["camber", "toe", "kingpin", "caster"] {
        let heading = format!("{angle} (deg)");
        columns.push(column(heading, format!("{angle}_rad"), degrees, 3));
    }
    columns.extend(study.measures().iter().map(quantity));
    columns
}
