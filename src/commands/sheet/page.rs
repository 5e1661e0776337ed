//! The page.

use maud::{Markup, PreEscaped, html};

use crate::characteristics::{Curves, Derivative, Line, Parameter};
use crate::mechanism::Description;
use crate::output::page::{charts, numbers, page};
use crate::output::plot::{Chart, Curve};

/// All that the page shows.
pub(super) struct Page<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a Description,
    pub(super) drawings: Vec<String>,
    /// The drives at the design position, in words.
    pub(super) drives: String,
    /// What could not be solved.
    pub(super) missing: Vec<String>,
    pub(super) parameters: Vec<Parameter>,
    pub(super) curves: Vec<Curves>,
}

impl Page<'_> {
    /// The page as HTML.
    pub(super) fn html(&self) -> String {
        let Description { linkage, unit, .. } = self.mechanism;
        let body = html! {
            p {
                "Motion file " code { (self.file) } ". Axes of ISO 8855: x forward, y left, z up; lengths in "
                (unit.symbol()) ", angles in degrees. Angles and offsets of a wheel have the same sign on both sides of the vehicle."
            }
            div.drawings {
                @for drawing in &self.drawings { (PreEscaped(drawing)) }
            }
            @for missing in &self.missing {
                p { strong { "The curves are cut short: " } (missing) }
            }
            h2 { "At the design position: " (self.drives) }
            (self.table())
            @for curves in &self.curves {
                (charts(&format!("Over {}", curves.drive), &self.charts(curves)))
            }
        };
        page(&format!("Kinematics of {linkage}"), &body)
    }

    fn charts(&self, curves: &Curves) -> Vec<Chart> {
        let lines = curves.lines.iter();
        let chart = |line: &Line| Chart {
            title: line.title.clone(),
            across: curves.across(self.mechanism.unit),
            quantity: line.symbol.clone(),
            curves: vec![Curve {
                name: String::new(),
                line: curves.points(line),
                marks: Vec::new(),
            }],
        };
        lines.map(chart).collect()
    }

    fn table(&self) -> Markup {
        let names = &self.mechanism.names;
        let vehicle = names.vehicle;
        let drives = [(0, vehicle.travel), (1, vehicle.steer)];
        let drives = drives
            .into_iter()
            .filter_map(|(way, drive)| Some((way, &names.drives[drive?])));
        let drives: Vec<_> = drives.collect();
        let parameters = &self.parameters;
        let values = numbers(parameters.iter().map(|parameter| Some(parameter.value)));
        let per = |way: usize| {
            let derivatives = parameters
                .iter()
                .map(|parameter| parameter.per[way].as_ref());
            let cells = numbers(derivatives.clone().map(|per| Some(per?.value)));
            let symbols = derivatives.map(symbol);
            cells.into_iter().zip(symbols).collect::<Vec<_>>()
        };
        let per: Vec<_> = drives.iter().map(|(way, _)| per(*way)).collect();
        html! {
            table {
                tr {
                    th { "quantity" } th.number { "value" } th { "unit" }
                    @for (_, drive) in &drives { th.number { "per " (drive.name) } th { "unit" } }
                    th { "definition" }
                }
                @for (row, (parameter, value)) in parameters.iter().zip(values).enumerate() {
                    tr {
                        td { (parameter.name) }
                        (value) td.unit { (parameter.symbol) }
                        @for per in &per { (per[row].0) td.unit { (per[row].1) } }
                        td.definition { (definition(parameter)) }
                    }
                }
            }
        }
    }
}

/// The unit of a derivative that there is.
fn symbol(derivative: Option<&Derivative>) -> &str {
    let derivative = derivative.filter(|derivative| derivative.value.is_finite());
    derivative.map_or("", |derivative| &derivative.symbol)
}

fn definition(parameter: &Parameter) -> String {
    let quantity = parameter.quantity;
    let sign = match quantity.sign {
        "" => String::new(),
        sign => format!("; {sign}"),
    };
    format!("{}{sign} ({})", quantity.definition, quantity.source)
}
