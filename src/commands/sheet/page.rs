//! The page of HTML.

use maud::{Markup, PreEscaped, html};
use nalgebra::Vector3;

use crate::characteristics::{Curves, Derivative, Parameter, Rises};
use crate::commands::sheet::by_quantity::grouped;
use crate::commands::sheet::curves::section;
use crate::commands::sheet::derivatives::Derivatives;
use crate::mechanism::{Description, Names};
use crate::output::capitalised::capitalised;
use crate::output::drawing::usual_radius;
use crate::output::page::{cut_short, in_digits, numbers, page};
use crate::quantities::{MEASURES, Quantity, from_design};

pub(super) struct Page<'a> {
    pub(super) file: &'a str,
    pub(super) mechanism: &'a Description,
    /// The positions of all points at the design position.
    pub(super) points: Vec<Vector3<f64>>,
    pub(super) drawings: Vec<String>,
    /// The drives at the design position, in words.
    pub(super) drives: String,
    /// The time and cause of an early end of the file's own motion.
    pub(super) motion_ends: Option<String>,
    /// Sentences on the range of the curves over roll, if that is shorter than the travel, and on springs that turn within it or pull a wheel up.
    pub(super) notes: Vec<String>,
    /// Sentences on curves that could not be solved.
    pub(super) missing: Vec<String>,
    pub(super) parameters: Vec<Parameter>,
    /// How far wheels rise per unit of the drives of travel; `None` if the drives do not move the wheels independently.
    pub(super) rises: Option<Rises>,
    pub(super) curves: Vec<Curves>,
    /// The names of measures, each with what the listing says of them.
    pub(super) measures: Vec<[String; 2]>,
}

impl Page<'_> {
    pub(super) fn html(&self) -> String {
        let Description {
            linkage,
            unit,
            axes,
            names,
            ..
        } = self.mechanism;
        let body = html! {
            p {
                "Axes of " (axes.in_words()) "; lengths in "
                (unit.length.in_words()) ", angles in degrees. Angles and offsets of a wheel have the same sign on both sides of the vehicle."
            }
            @if names.wheels.iter().any(|wheel| wheel.radius.is_none()) {
                p {
                    "The motion file states no " code { "wheel_radius" } ": contact point, scrub radius, mechanical trail and \
                     roll centre are left out, and the wheel is drawn with a radius of " (in_digits(usual_radius(*unit))) " " (unit.symbol()) ". State it under [vehicle]."
                }
            }
            div.drawings {
                @for drawing in &self.drawings { (PreEscaped(drawing)) }
            }
            @if let Some(why) = &self.motion_ends {
                p { strong { "The file's own motion is out of reach: " } (why) }
            }
            @for note in &self.notes { p { (capitalised(note)) "." } }
            (cut_short(&self.missing))
            h2 { "At the design position: " (self.drives) }
            div.scrolled { (self.table()) }
            (self.quantities_with_curves_only())
            @for curves in &self.curves {
                (section(curves, &self.parameters, self.mechanism))
            }
            h2 { "Points at the design position (" (unit.symbol()) ")" }
            (self.hardpoints())
        };
        page(&format!("Kinematics of {} ({linkage})", self.file), &body)
    }

    /// Returns the table of all parameters, the wheels below each other and under each quantity its definition.
    fn table(&self) -> Markup {
        /// With derivatives with respect to more drives the columns are narrower, and with more still narrower.
        const MOST: [usize; 2] = [3, 4];
        let derivatives = Derivatives::collect(self.mechanism, self.rises.as_ref());
        let groups = grouped(&self.parameters, |parameter| &parameter.title.of_wheel);
        let cells = self.cells(&groups, &derivatives);
        let has_names = self
            .parameters
            .iter()
            .any(|parameter| parameter.title.wheel.is_some());
        let columns = 2 * (1 + derivatives.len()) + 1 + usize::from(has_names);
        let mut cells = cells.into_iter();
        html! {
            table.wide[derivatives.len() > MOST[0]].wider[derivatives.len() > MOST[1]] {
                thead {
                    tr {
                        th { "quantity" }
                        @if has_names { th { "wheel" } }
                        th.number { "value" } th { "unit" }
                        @for per in &derivatives { th.number { (per.heading) } th { "unit" } }
                    }
                }
                @for (number, group) in groups.iter().enumerate() {
                    tbody.group {
                        @for (row, parameter) in group.iter().enumerate() {
                            tr.first[row == 0] {
                                @if row == 0 {
                                    td rowspan=[(group.len() > 1).then_some(group.len())] { (parameter.title.of_wheel) }
                                }
                                @if has_names { td { (parameter.title.wheel.as_deref().unwrap_or_default()) } }
                                @for cell in cells.next().into_iter().flatten() { (cell) }
                            }
                        }
                        @let next = groups.get(number + 1).map(|next| next[0].quantity);
                        @if next != Some(group[0].quantity) {
                            tr.definition {
                                td colspan=(columns) {
                                    (definition(group[0].quantity))
                                    @if *group[0].quantity == MEASURES {
                                        @for [names, text] in &self.measures { br; code { (names) } ": " (text) }
                                    }
                                }
                            }
                        }
                    }
                }
            }
        }
    }

    /// Lists the quantities that have curves but are zero at the design position, so that the table omits them.
    fn quantities_with_curves_only(&self) -> Markup {
        let is_shown = |quantity: &&Quantity| {
            let mut lines = self.curves.iter().flat_map(|curves| &curves.lines);
            lines.any(|line| line.title.of_wheel == quantity.title)
        };
        let shown: Vec<&Quantity> = from_design().filter(is_shown).collect();
        html! {
            @if !shown.is_empty() {
                h2 { "In the curves, and zero at the design position" }
                table {
                    @for quantity in shown {
                        tr.first { td { (quantity.title) } }
                        tr.definition { td { (definition(quantity)) } }
                    }
                }
            }
        }
    }

    /// Returns the table of all points, in the file's coordinates.
    fn hardpoints(&self) -> Markup {
        let Names {
            points,
            chassis,
            free,
            ..
        } = &self.mechanism.names;
        let is = |point: usize| match point {
            point if point < *chassis => "on the chassis",
            point if point < chassis + free => "moves",
            _ => "carried by a body",
        };
        let coordinate = |axis: usize| numbers(self.points.iter().map(|at| Some(at[axis])));
        let [x, y, z] = [0, 1, 2].map(coordinate);
        html! {
            table {
                thead {
                    tr { th { "point" } th { "" } th.number { "x" } th.number { "y" } th.number { "z" } }
                }
                @for (point, name) in points.iter().enumerate() {
                    tr.first { td { (name) } td.unit { (is(point)) } (x[point]) (y[point]) (z[point]) }
                }
            }
        }
    }

    /// Returns the numbers of each row with their units.
    fn cells(
        &self,
        groups: &[Vec<&Parameter>],
        derivatives: &[Derivatives<'_>],
    ) -> Vec<Vec<Markup>> {
        let parameters: Vec<&Parameter> = groups.iter().flatten().copied().collect();
        let with_units = |numbers: Vec<Markup>, units: Vec<String>| {
            let cells = numbers.into_iter().zip(units);
            cells
                .map(|(number, unit)| html! { (number) td.unit { (unit) } })
                .collect::<Vec<_>>()
        };
        let values = numbers(parameters.iter().map(|parameter| Some(parameter.value)));
        let units = parameters.iter().map(|parameter| parameter.symbol.clone());
        let mut columns = vec![with_units(values, units.collect())];
        for per in derivatives {
            let each = parameters.iter();
            let each = each.map(|parameter| per.derivative(parameter, self.mechanism.unit));
            let each: Vec<Option<Derivative>> = each.collect();
            let values = numbers(each.iter().map(|per| Some(per.as_ref()?.value)));
            columns.push(with_units(values, each.into_iter().map(symbol).collect()));
        }
        let row = |row: usize| columns.iter().map(|column| column[row].clone()).collect();
        (0..parameters.len()).map(row).collect()
    }
}

/// Returns the unit of a derivative, or an empty text without one.
fn symbol(derivative: Option<Derivative>) -> String {
    let derivative = derivative.filter(|derivative| derivative.value.is_finite());
    derivative.map_or_else(String::new, |derivative| derivative.symbol)
}

/// Returns the definition of a quantity, after its name in commands and files.
fn definition(quantity: &Quantity) -> Markup {
    let Quantity {
        name,
        definition,
        sign,
        source,
        vehicle,
        ..
    } = quantity;
    html! {
        @if !name.is_empty() { code { (name) } ": " }
        (definition) @if !sign.is_empty() { ". " (capitalised(sign)) } " (" (source)
        @if !vehicle.is_empty() { "; " (vehicle) " of [vehicle]" } ")"
    }
}
