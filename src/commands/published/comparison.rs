//! The paper's Tables 2 and 3 beside our results, as text.

use std::fmt::Write;

use crate::commands::published::compared_column::{Compared, Pair};
use crate::commands::published::paper::Paper;
use crate::mechanism::{Names, State};
use crate::quantities::{ALPHA, Axis, DRIVES, OMEGA, Quantity, catalogue, columns};

/// Columns that are printed next to each other.
struct Block<'a> {
    title: String,
    columns: &'a [Compared<'a>],
    /// Digits after the decimal point of our numbers.
    digits: usize,
    /// The factor of the differences, and their digits after the decimal point.
    difference: (f64, usize),
}

/// Returns both tables, the misprints and the largest differences. The states are those at the paper's instants.
pub(super) fn text(paper: &Paper, names: &Names, states: &[State]) -> String {
    let ours = columns(catalogue(), names);
    let [table2, table3] = [&paper.table2, &paper.table3].map(|table| Compared::all(table, &ours));
    let mut out = String::from(
        "Multi-link five-point suspension, Attia 2003: the printed tables and ours, difference = \
         ours - printed\n\nTable 2: drive angle in degrees; knuckle points in m, differences in mm\n",
    );
    for block in blocks_of_table2(&table2) {
        out.push_str(&block.text(paper, states));
    }
    out.push_str("\nTable 3: angular velocity and acceleration of the knuckle\n");
    for block in blocks_of_table3(&table3) {
        out.push_str(&block.text(paper, states));
    }
    out.push_str(&misprints(paper));
    out.push_str("\nLargest differences\n");
    for (name, table) in [("Table 2", &table2), ("Table 3", &table3)] {
        out.push_str(&largest(name, paper, table, states));
    }
    out
}

/// Groups the columns of one quantity, drives first.
fn blocks_of_table2<'a>(columns: &'a [Compared<'a>]) -> impl Iterator<Item = Block<'a>> {
    let things = columns.chunk_by(|a, b| a.ours.name == b.ours.name);
    let mut things: Vec<_> = things.collect();
    things.sort_by_key(|columns| !columns[0].ours.is(&DRIVES));
    things.into_iter().map(|columns| {
        let Compared { ours, .. } = &columns[0];
        if ours.is(&DRIVES) {
            Block {
                title: "Drive angle".to_owned(),
                columns,
                digits: 4,
                difference: (1.0, 4),
            }
        } else {
            Block {
                title: format!("Point {}", ours.name.trim_start_matches('p')),
                columns,
                digits: 5,
                difference: (1e3, 2),
            }
        }
    })
}

fn blocks_of_table3<'a>(columns: &'a [Compared<'a>]) -> impl Iterator<Item = Block<'a>> {
    let titled: [(&Quantity, _); 2] = [
        (&OMEGA, "Angular velocity, rad/s"),
        (&ALPHA, "Angular acceleration, rad/s^2"),
    ];
    let things = columns.chunk_by(|a, b| a.ours.name == b.ours.name);
    let things: Vec<_> = things.collect();
    titled.into_iter().filter_map(move |(quantity, title)| {
        let columns = things.iter().find(|columns| columns[0].ours.is(quantity))?;
        Some(Block {
            title: title.to_owned(),
            columns,
            digits: 4,
            difference: (1.0, 4),
        })
    })
}

impl Block<'_> {
    fn text(&self, paper: &Paper, states: &[State]) -> String {
        let columns = self.columns.iter();
        let columns: Vec<Vec<Pair<'_>>> = columns.map(|c| c.pairs(paper, states)).collect();
        let mut out = format!("\n{}\n  t (s)", self.title);
        for column in self.columns {
            let axis = column.ours.axis.as_ref().map(Axis::to_string);
            let printed = format!("{} printed", axis.unwrap_or_default());
            let _ = write!(out, " | {printed:>9}  {:>9}  {:>7}", "ours", "differ.");
        }
        out.push('\n');
        for (index, t) in paper.times.iter().enumerate() {
            let _ = write!(out, "  {t:5.2}");
            for pair in columns.iter().filter_map(|column| column.get(index)) {
                out.push_str(&self.cell(pair));
            }
            out.push('\n');
        }
        out
    }

    fn cell(&self, pair: &Pair<'_>) -> String {
        let (scale, digits) = self.difference;
        let mark = if pair.entry.misprinted { '*' } else { ' ' };
        format!(
            " | {:>9}{mark} {:>9.*}  {:>+7.digits$}",
            pair.entry.printed,
            self.digits,
            pair.ours,
            pair.difference() * scale,
        )
    }
}

fn misprints(paper: &Paper) -> String {
    let mut out = String::from(
        "\nMisprints of the paper (*); differences are taken from the corrected number\n",
    );
    for misprint in &paper.misprints {
        let _ = writeln!(
            out,
            "  {}: printed {}, read {}\n      {}",
            misprint
                .place
                .replacen("table", "Table ", 1)
                .replacen('.', ", ", 1),
            misprint.printed,
            misprint.corrected,
            misprint.why
        );
    }
    out
}

/// Returns the largest difference in a table, without the angles of drives.
fn largest(name: &str, paper: &Paper, table: &[Compared<'_>], states: &[State]) -> String {
    let columns = table.iter().filter(|c| !c.ours.is(&DRIVES));
    let pairs: Vec<_> = columns.flat_map(|c| c.pairs(paper, states)).collect();
    let by_units = |a: &&Pair<'_>, b: &&Pair<'_>| a.units().total_cmp(&b.units());
    let Some(worst) = pairs.iter().max_by(by_units) else {
        return String::new();
    };
    let rounded = pairs.iter().filter(|pair| pair.units() <= 0.5).count();
    format!(
        "  {name}: {:.2} units of the last printed digit, {} at t = {} s: printed {}, ours {:.5}\n  \
         {:9}{rounded} of {} entries within half a unit\n",
        worst.units(),
        worst.column,
        worst.t,
        worst.entry.printed,
        worst.ours,
        "",
        pairs.len(),
    )
}
