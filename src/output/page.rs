//! Self-contained HTML pages, which any browser shows and prints.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::number::{aligned, rounded, without_rounding};
use crate::output::plot::Chart;

const STYLE: &str = "
@page { size: A4; margin: 12mm; }
body { font-family: sans-serif; max-width: 1180px; margin: 1.5em auto; padding: 0 1em; color: #222; }
table { border-collapse: collapse; font-size: 90%; width: 100%; }
th, td { padding: 0.2em 0.7em; text-align: left; vertical-align: top; }
th { border-bottom: 1px solid #888; }
th:first-child { min-width: 8em; }
tr.first td { border-top: 1px solid #ddd; }
th.number, td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; padding-right: 0.2em; }
td.unit { white-space: nowrap; color: #555; padding-left: 0.2em; }
table.wide { font-size: 70%; }
table.wide.wider { font-size: 62%; }
.scrolled { overflow-x: auto; }
table.wide th, table.wide td { padding-left: 0.3em; padding-right: 0.3em; }
tr.definition td, table.wide tr.definition td { color: #555; font-size: 85%; padding: 0 0.7em 0.3em 2em; }
.drawings { display: grid; grid-template-columns: 1fr 1fr; gap: 0.6em; }
.drawings svg { width: 100%; height: auto; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(340px, 1fr)); gap: 0.6em; }
.charts svg { width: 100%; height: auto; }
.legend { position: sticky; top: 0; background: #fff; margin: 0; padding: 0.4em 0; }
.legend > span { margin-right: 1.6em; white-space: nowrap; }
.legend .line { display: inline-block; width: 2em; border-top: 3px solid; margin-right: 0.4em; vertical-align: middle; }
@media print {
  .scrolled { overflow-x: visible; }
  body { font-size: 8.5pt; margin: 0; padding: 0; max-width: none; }
  th, td { padding: 0.05em 0.4em; }
  .charts { grid-template-columns: repeat(4, 1fr); gap: 0.2em; }
  h1 { font-size: 15pt; margin: 0; }
  h2 { font-size: 11pt; margin: 0.6em 0 0.2em; break-after: avoid; }
  svg, tr, tbody.group { break-inside: avoid; }
  tr:has(+ tr.definition) { break-after: avoid; }
}
";

/// Width and height of a chart in pixels.
const CHART: (u32, u32) = (480, 330);

/// Digits of a number in a table.
const DIGITS: usize = 6;

/// Returns a page.
pub fn page(title: &str, body: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { (title) }
                (PreEscaped(with_code(&body.0)))
            }
        }
    };
    page.into_string()
}

/// Returns text with the names that sentences have between backticks set as code.
fn with_code(text: &str) -> String {
    let mut pieces = text.split('`');
    let mut set = pieces.next().unwrap_or_default().to_owned();
    while let Some(name) = pieces.next() {
        match pieces.next() {
            Some(behind) => set += &format!("<code>{name}</code>{behind}"),
            None => set += &format!("`{name}"),
        }
    }
    set
}

/// Returns the sentences on curves that end early.
pub fn cut_short(sentences: &[String]) -> Markup {
    html! {
        @for sentence in sentences { p { strong { "The curves are cut short: " } (sentence) } }
    }
}

/// Returns charts beside and below each other.
pub fn charts(charts: &[Chart]) -> Markup {
    html! {
        div.charts {
            @for svg in charts.iter().filter_map(|chart| chart.svg_of(CHART)) {
                (PreEscaped(svg))
            }
        }
    }
}

/// Returns the cells of a column of numbers with aligned decimal points; a dash for NaN, an empty cell for `None`.
pub fn numbers(values: impl Iterator<Item = Option<f64>>) -> Vec<Markup> {
    /// As wide as a digit, and as a decimal point.
    const SPACES: [char; 2] = ['\u{2007}', '\u{2008}'];
    let shown = |value: Option<f64>| value.map_or_else(String::new, in_digits);
    let cells = aligned(values.map(shown).collect(), SPACES);
    cells
        .into_iter()
        .map(|cell| html! { td.number { (cell) } })
        .collect()
}

/// Formats a value with the digits of tables; rounding errors become zero.
pub fn in_digits(value: f64) -> String {
    if value.is_finite() {
        rounded(without_rounding(value), DIGITS)
    } else {
        "\u{2013}".to_owned()
    }
}
