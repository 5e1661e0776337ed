//! The paper's Tables 2 and 3 beside our results, as text.

use std::fmt::Write;

use crate::published::paper::{Column, Pair, Paper, beside};
use crate::study::sweep::Rows;

/// Columns that are printed next to each other.
struct Block<'a> {
    title: String,
    columns: Vec<&'a Column>,
    /// Digits after the point of our numbers.
    digits: usize,
    /// What differences are multiplied with, and their digits after the point.
    difference: (f64, usize),
}

/// Both tables, the misprints and the largest differences.
pub fn text(paper: &Paper, rows: &Rows) -> String {
    let mut out = String::from(
        "Multi-link five-point suspension, Attia 2003: the printed tables and ours, difference = \
         ours - printed\n\nTable 2: drive angle in degrees; knuckle points in m, differences in mm\n",
    );
    for block in table2(paper) {
        out.push_str(&block.text(paper, rows));
    }
    out.push_str("\nTable 3: angular velocity and acceleration of the knuckle\n");
    for block in table3(paper) {
        out.push_str(&block.text(paper, rows));
    }
    out.push_str(&misprints(paper));
    out.push_str(&largest(paper, rows));
    out
}

fn table2(paper: &Paper) -> Vec<Block<'_>> {
    let (angles, points): (Vec<_>, Vec<_>) =
        paper.table2.iter().partition(|c| c.name.ends_with("_deg"));
    let angles = Block {
        title: "Drive angle".to_owned(),
        columns: angles,
        digits: 4,
        difference: (1.0, 4),
    };
    let points = points.chunks(3).map(|axes| Block {
        title: format!("Point {}", stem(&axes[0].name).trim_start_matches('p')),
        columns: axes.to_vec(),
        digits: 5,
        difference: (1e3, 2),
    });
    std::iter::once(angles).chain(points).collect()
}

fn table3(paper: &Paper) -> Vec<Block<'_>> {
    let titled = [
        ("omega", "Angular velocity, rad/s"),
        ("alpha", "Angular acceleration, rad/s^2"),
    ];
    titled
        .map(|(name, title)| Block {
            title: title.to_owned(),
            columns: (paper.table3.iter())
                .filter(|column| stem(&column.name) == name)
                .collect(),
            digits: 4,
            difference: (1.0, 4),
        })
        .into()
}

/// A column's name without its axis.
fn stem(name: &str) -> &str {
    name.rsplit_once('_').map_or(name, |(stem, _)| stem)
}

/// The axis in a column's name, or nothing.
fn axis(name: &str) -> &str {
    match name.rsplit_once('_') {
        Some((_, axis @ ("x" | "y" | "z"))) => axis,
        _ => "",
    }
}

impl Block<'_> {
    fn text(&self, paper: &Paper, rows: &Rows) -> String {
        let columns = self.columns.iter();
        let columns: Vec<Vec<Pair<'_>>> = columns.map(|c| beside(paper, c, rows)).collect();
        let mut out = format!("\n{}\n  t (s)", self.title);
        for column in &self.columns {
            let printed = format!("{} printed", axis(&column.name));
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

fn pairs<'a>(paper: &'a Paper, columns: &'a [Column], rows: &Rows) -> Vec<Pair<'a>> {
    let columns = columns.iter().filter(|c| !c.name.ends_with("_deg"));
    columns.flat_map(|c| beside(paper, c, rows)).collect()
}

fn largest(paper: &Paper, rows: &Rows) -> String {
    let mut out = String::from("\nLargest differences\n");
    for (name, columns) in [("Table 2", &paper.table2), ("Table 3", &paper.table3)] {
        let pairs = pairs(paper, columns, rows);
        let by_units = |a: &&Pair<'_>, b: &&Pair<'_>| a.units().total_cmp(&b.units());
        let Some(worst) = pairs.iter().max_by(by_units) else {
            continue;
        };
        let rounded = pairs.iter().filter(|pair| pair.units() <= 0.5).count();
        let _ = writeln!(
            out,
            "  {name}: {:.2} units of the last printed digit, {} at t = {} s: printed {}, ours {:.5}\n  \
             {:9}{rounded} of {} entries within half a unit",
            worst.units(),
            worst.column,
            worst.t,
            worst.entry.printed,
            worst.ours,
            "",
            pairs.len(),
        );
    }
    out
}
