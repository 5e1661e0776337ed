//! The page.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::charts::Charts;
use super::parameters::{Parameter, symbol_per};
use crate::mechanism::Mechanism;
use crate::number::rounded;
use crate::quantities::Kind;

/// All that the page shows.
pub(super) struct Page<'a, L, const N: usize> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a Mechanism<L, N>,
    pub(super) drawing: Option<String>,
    /// The drives there, in words.
    pub(super) drives: String,
    /// What could not be solved.
    pub(super) missing: Vec<String>,
    pub(super) parameters: Vec<Parameter>,
    pub(super) charts: Vec<Charts>,
}

const STYLE: &str = "
body { font-family: sans-serif; max-width: 1180px; margin: 1.5em auto; padding: 0 1em; color: #222; }
table { border-collapse: collapse; font-size: 90%; }
th, td { padding: 0.2em 0.7em; text-align: left; border-bottom: 1px solid #ddd; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.definition { color: #555; font-size: 90%; }
.drawing svg { max-width: 100%; height: auto; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(340px, 1fr)); gap: 0.6em; }
.charts svg { width: 100%; height: auto; }
@media print { .charts { grid-template-columns: repeat(3, 1fr); } h2 { break-after: avoid; } svg { break-inside: avoid; } }
";

/// Width and height of a chart.
const CHART: (u32, u32) = (480, 330);

/// Digits of a value.
const DIGITS: usize = 6;

impl<L, const N: usize> Page<'_, L, N> {
    /// The page as HTML.
    pub(super) fn html(&self) -> String {
        let Mechanism { linkage, unit, .. } = self.mechanism;
        let title = format!("Kinematics of {linkage}");
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
                    p {
                        "Motion file " code { (self.file) } ". Axes of ISO 8855: x forward, y left, z up; lengths in "
                        (unit.symbol()) ", angles in degrees. Angles and offsets of a wheel have the same sign on both sides of the vehicle."
                    }
                    @if let Some(drawing) = &self.drawing {
                        div.drawing { (PreEscaped(drawing)) }
                    }
                    @for missing in &self.missing {
                        p { strong { "The curves are cut short: " } (missing) }
                    }
                    h2 { "At the design position: " (self.drives) }
                    (self.table())
                    @for charts in &self.charts {
                        h2 { (charts.heading) }
                        div.charts {
                            @for svg in charts.charts.iter().filter_map(|chart| chart.svg_of(CHART)) {
                                (PreEscaped(svg))
                            }
                        }
                    }
                }
            }
        };
        page.into_string()
    }

    fn table(&self) -> Markup {
        let Mechanism { names, unit, .. } = self.mechanism;
        let vehicle = names.vehicle;
        let drives = [vehicle.travel, vehicle.steer].map(|drive| Some(&names.drives[drive?]));
        html! {
            table {
                tr {
                    th { "quantity" } th { "value" }
                    @for drive in drives.iter().flatten() { th { "per " (drive.name) } }
                    th { "definition" }
                }
                @for parameter in &self.parameters {
                    tr {
                        td { (parameter.name) }
                        (number(Some(parameter.value), &parameter.symbol))
                        @for (drive, per) in drives.iter().zip(parameter.per) {
                            @if let Some(drive) = drive {
                                (number(per, &symbol_per(&parameter.symbol, Kind::from(drive.kind), *unit)))
                            }
                        }
                        td.definition { (definition(parameter)) }
                    }
                }
            }
        }
    }
}

/// A number with its unit; an empty cell where there is none.
fn number(value: Option<f64>, symbol: &str) -> Markup {
    html! {
        td.number {
            @match value.filter(|value| value.is_finite()) {
                Some(value) => { (shown(value)) " " (symbol) }
                None => { "" }
            }
        }
    }
}

/// What is rounding is shown as zero.
fn shown(value: f64) -> String {
    const ROUNDING: f64 = 1e-12;
    rounded(if value.abs() < ROUNDING { 0.0 } else { value }, DIGITS)
}

fn definition(parameter: &Parameter) -> String {
    let quantity = parameter.quantity;
    let sign = match quantity.sign {
        "" => String::new(),
        sign => format!("; {sign}"),
    };
    format!("{}{sign} ({})", quantity.definition, quantity.source)
}
