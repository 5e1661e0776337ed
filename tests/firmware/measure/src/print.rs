//! The table that people read.

use std::fmt::Write;

use crate::figures::{Measured, Table};

const HEADS: [&str; 7] = [
    "target and mode",
    "instructions",
    "least",
    "stack, bytes",
    "of that used",
    "size, bytes",
    "largest residual, m",
];

fn cells(target: &str, mode: &str, measured: &Measured) -> [String; 7] {
    let Measured {
        figures,
        least,
        used_stack,
        residual,
        ..
    } = measured;
    [
        format!("{target}/{mode}"),
        figures.instructions.to_string(),
        least.to_string(),
        figures.stack.to_string(),
        used_stack.to_string(),
        figures.size.to_string(),
        if *residual > 0.0 {
            format!("{residual:.1e}")
        } else {
            "-".to_owned()
        },
    ]
}

fn rows(measured: &Table<Measured>) -> Vec<[String; 7]> {
    let each = measured.iter().flat_map(|(target, modes)| {
        modes
            .iter()
            .map(move |(mode, measured)| cells(target, mode, measured))
    });
    std::iter::once(HEADS.map(str::to_owned))
        .chain(each)
        .collect()
}

/// In columns.
pub(crate) fn plain(measured: &Table<Measured>) -> String {
    let rows = rows(measured);
    let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or(0);
    let widths: [usize; 7] = std::array::from_fn(width);
    let mut text = String::new();
    for row in &rows {
        for (column, (cell, width)) in row.iter().zip(widths).enumerate() {
            let written = if column == 0 {
                write!(text, "{cell:width$}")
            } else {
                write!(text, "  {cell:>width$}")
            };
            written.expect("a string takes any text");
        }
        text.push('\n');
    }
    text
}

/// As Markdown.
pub(crate) fn markdown(measured: &Table<Measured>) -> String {
    let mut rows = rows(measured)
        .into_iter()
        .map(|row| format!("| {} |\n", row.join(" | ")));
    let head = rows.next().unwrap_or_default();
    let rule = format!("| --- |{}\n", " ---: |".repeat(6));
    head + &rule + &rows.collect::<String>()
}

#[cfg(test)]
mod tests {
    use super::{markdown, plain};
    use crate::figures::{Figures, Measured, Table};

    fn table() -> Table<Measured> {
        let figures = Figures {
            instructions: 1700,
            stack: 2048,
            size: 16384,
        };
        let measured = Measured {
            figures,
            least: 1699,
            used_stack: 900,
            is_hosts: true,
            residual: 1.5e-9,
        };
        [("m4f".to_owned(), [("exact".to_owned(), measured)].into())].into()
    }

    #[test]
    fn printed_columns_are_as_wide_as_their_widest_cell() {
        let text = plain(&table());
        let lengths: Vec<usize> = text.lines().map(str::len).collect();
        assert_eq!(lengths.len(), 2);
        assert_eq!(lengths[0], lengths[1], "{text}");
    }

    #[test]
    fn the_markdown_table_has_a_rule_under_its_headings() {
        let text = markdown(&table());
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(
            lines[1],
            "| --- | ---: | ---: | ---: | ---: | ---: | ---: |"
        );
        assert_eq!(
            lines[2],
            "| m4f/exact | 1700 | 1699 | 2048 | 900 | 16384 | 1.5e-9 |"
        );
    }
}
