//! The page of HTML: differences, and the curves of both suspensions in one chart each.

use maud::{Markup, html};

use crate::characteristics::{Curves, Line};
use crate::commands::compare::comparison::Comparison;
use crate::commands::compare::differences::{Difference, EVERYWHERE, Part, pairs, title_of_both};
use crate::commands::compare::report::{legend, notes};
use crate::commands::compare::short_name::short_names;
use crate::commands::compare::side::Side;
use crate::output::page::{charts, numbers, page};
use crate::output::plot::{Chart, Curve};

pub(super) fn html(sides: [&Side; 2], comparison: &Comparison<'_>) -> String {
    let [a, b] = legend(sides);
    let body = html! {
        p { "A: " code { (a) } }
        p { "B: " code { (b) } }
        @for note in notes(sides) { p { (note) } }
        @for missing in sides.iter().flat_map(|side| &side.missing) {
            p { strong { "The curves are cut short: " } (missing) }
        }
        @for part in &comparison.parts {
            h2 { (part.heading) }
            (table(part))
        }
        @for over in &comparison.over {
            @let [a, b] = &over.curves;
            h2 { "Over " (a.title) }
            (charts(&both(sides, a, b)))
        }
    };
    page("Two suspensions compared", &body)
}

fn both(sides: [&Side; 2], a: &Curves, b: &Curves) -> Vec<Chart> {
    let [name_a, name_b] = short_names(sides.map(|side| side.file.as_str()));
    let curve = |name: &str, curves: &Curves, line: &Line| Curve {
        name: name.to_owned(),
        line: curves.points(line),
        marks: Vec::new(),
    };
    let chart = |[of_a, of_b]: [&Line; 2]| Chart {
        title: title_of_both([&of_a.title, &of_b.title]),
        across: a.axis_label(sides[0].unit),
        quantity: of_a.symbol.clone(),
        curves: vec![curve(&name_a, a, of_a), curve(&name_b, b, of_b)],
    };
    pairs(a, b).into_iter().map(chart).collect()
}

fn table(part: &Part) -> Markup {
    let differences = || part.differences.iter();
    let column = |value: &dyn Fn(&Difference) -> Option<f64>| numbers(differences().map(value));
    let a = column(&|difference| Some(difference.values[0]));
    let b = column(&|difference| Some(difference.values[1]));
    let more = column(&|difference| Some(difference.value()));
    let at = column(&|difference| difference.at);
    html! {
        table {
            thead { tr {
                th { "quantity" } th.number { "A" } th.number { "B" } th.number { "B - A" } th { "unit" }
                th.number { @if part.is_of_curves { "at" } }
            } }
            @for (row, difference) in part.differences.iter().enumerate() {
                tr.first {
                    td { (difference.quantity) }
                    (a[row]) (b[row]) (more[row])
                    td.unit { (difference.symbol) }
                    @if part.is_of_curves && difference.at.is_none() { td.number { (EVERYWHERE) } } @else { (at[row]) }
                }
            }
        }
    }
}
