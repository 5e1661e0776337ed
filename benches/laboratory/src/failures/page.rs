//! The map as SVG and as one HTML page.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::closure::NINE_DISTANCES;
use super::drift_figure;
use super::figure::{Line, WIDTH, draw, height};
use super::method::Method;
use super::rows::Row;
use super::survey::{Counted, Effort};
use crate::chart::page::document;
use suspension::number::rounded;

/// All that the page shows.
#[derive(Clone, Debug)]
pub struct Findings {
    /// The mechanism and the instants.
    pub motion: String,
    /// The number of trials.
    pub effort: Effort,
    /// The counts.
    pub counted: Counted,
}

impl Findings {
    /// The map in `f64`, of nine distances only the methods that start anywhere: as an SVG
    /// document.
    pub fn svg(&self) -> String {
        let lines = self.lines("f64", |line| {
            let begins_anywhere = [Method::Plain, Method::Damped, Method::Marquardt];
            line.closure != NINE_DISTANCES
                || begins_anywhere.iter().any(|it| it.name() == line.method)
        });
        self.map(&self.title(), "f64", &lines).into_string()
    }

    fn title(&self) -> String {
        let Effort { starts, seed, .. } = self.effort;
        format!("Where methods fail: {starts} trials a bar, seed {seed}")
    }

    /// The lines of a map, in the order in which they were tried.
    fn lines(&self, scalar: &str, wanted: impl Fn(&Line) -> bool) -> Vec<Line> {
        let mut lines: Vec<Line> = Vec::new();
        for row in self.counted.rows.iter().filter(|row| row.scalar == scalar) {
            let line = Line::of(row);
            if wanted(&line) && !lines.contains(&line) {
                lines.push(line);
            }
        }
        let order = |line: &Line| Method::ALL.iter().position(|it| it.name() == line.method);
        lines.sort_by_key(|line| (line.closure != NINE_DISTANCES, order(line)));
        lines
    }

    fn map(&self, title: &str, scalar: &str, lines: &[Line]) -> Markup {
        let rows: Vec<&Row> = self
            .counted
            .rows
            .iter()
            .filter(|row| row.scalar == scalar)
            .collect();
        document(WIDTH, height(lines.len()), &draw(title, lines, &rows))
    }

    /// Everything, as an HTML document without links to others.
    pub fn html(&self) -> String {
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    title { "Where methods fail" }
                    style { (PreEscaped(include_str!("../chart/page.css"))) }
                }
                body {
                    h1 { "Where methods fail" }
                    p { (self.motion) "; " (self.effort.starts) " trials a point, seed " (self.effort.seed) }
                    p { (PreEscaped(include_str!("page.txt"))) }
                    @for scalar in ["f64", "f32"] {
                        @let lines = self.lines(scalar, |_| true);
                        @if !lines.is_empty() {
                            h2 { "Computed in " (scalar) }
                            (self.map("", scalar, &lines))
                            (self.table(scalar))
                        }
                    }
                    (self.long_runs())
                }
            }
        };
        page.into_string()
    }

    fn long_runs(&self) -> Markup {
        let rows = &self.counted.long_runs;
        html! {
            @if !rows.is_empty() {
                h2 { "Long runs" }
                (document(drift_figure::SIZE.0, drift_figure::SIZE.1, &drift_figure::draw(rows)))
                details {
                    summary { "Rows" }
                    table {
                        tr {
                            th { "method" } th { "closure" } th { "number" } th { "steps" }
                            th { "largest residual, m" } th { "iterations a step" } th { "ended" }
                        }
                        @for row in rows {
                            tr {
                                td { (row.method) } td { (row.closure) } td { (row.scalar) } td.number { (row.steps) }
                                td.number { (rounded(row.drift_m, 2)) } td.number { (rounded(row.iterations_a_step, 4)) }
                                td { (row.ended) }
                            }
                        }
                    }
                }
            }
        }
    }

    fn table(&self, scalar: &str) -> Markup {
        html! {
            details {
                summary { "Counts" }
                table {
                    tr {
                        th { "axis" } th { "value" } th { "method" } th { "closure" } th { "trials" } th { "right" }
                        th { "wrong" } th { "of them mirrored" } th { "no root" } th { "largest residual, m" }
                    }
                    @for row in self.counted.rows.iter().filter(|row| row.scalar == scalar) {
                        tr {
                            td { (row.axis.in_words()) } td.number { (rounded(row.value, 3)) }
                            td { (row.method) } td { (row.closure) }
                            @for count in [row.trials, row.right, row.wrong_branch, row.mirrored, row.no_root] {
                                td.number { (count) }
                            }
                            td.number { (rounded(row.residual_m, 2)) }
                        }
                    }
                }
            }
        }
    }
}
