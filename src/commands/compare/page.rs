//! The page of HTML: differences, and the curves of both in one chart each.

use maud::{Markup, html};

use crate::commands::compare::differences::{Difference, EVERYWHERE, Part};
use crate::commands::compare::report::Report;
use crate::output::page::{charts, cut_short, numbers, page};

pub(super) fn html(report: &Report) -> String {
    let [a, b] = &report.legend;
    let body = html! {
        p { "A: " code { (a) } }
        p { "B: " code { (b) } }
        @for note in &report.notes { p { (note) } }
        (cut_short(&report.missing))
        @for part in &report.parts {
            h2 { (part.heading) }
            (table(part))
        }
        @for (heading, drawn) in &report.charts {
            h2 { (heading) }
            (charts(drawn))
        }
    };
    page(report.title, &body)
}

fn table(part: &Part) -> Markup {
    let rows = part.rows();
    let differences = || rows.iter();
    let column = |value: &dyn Fn(&Difference) -> Option<f64>| numbers(differences().map(value));
    let a = column(&|difference| Some(difference.values[0]));
    let b = column(&|difference| Some(difference.values[1]));
    let more = column(&|difference| Some(difference.value()));
    let at = column(&|difference| difference.at);
    let rms = column(&|difference| difference.rms);
    let is_of_curves = part.across.is_some();
    html! {
        table {
            thead { tr {
                th { "quantity" } th.number { "A" } th.number { "B" } th.number { "B - A" } th { "unit" }
                th.number { @if is_of_curves { "at" } } th.number { @if part.has_rms() { "rms" } }
            } }
            @for (row, difference) in rows.iter().enumerate() {
                tr.first {
                    td { (difference.title) }
                    (a[row]) (b[row]) (more[row])
                    td.unit { (difference.symbol) }
                    @if is_of_curves && difference.at.is_none() { td.number { (EVERYWHERE) } } @else { (at[row]) }
                    (rms[row])
                }
            }
        }
    }
}
