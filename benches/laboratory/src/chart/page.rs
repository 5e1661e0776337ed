//! The chart as SVG and as one HTML page.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::figure::{Figure, Mark, SIZE};
use super::latency_page;
use super::method::{ALL_OUTPUTS, Outputs, name_of, unit_of};
use super::rows::Rival;
use super::style::{LEGEND, Style, legend};
use super::survey::Survey;
use suspension::number::rounded;

/// The contents of the chart.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// The mechanism and the instants.
    pub motion: String,
    /// Our methods.
    pub survey: Survey,
    /// The median reading of the clock with nothing to time, ns.
    pub clock: u64,
    /// Other programs and libraries.
    pub rivals: Vec<Rival>,
}

impl Findings {
    /// The time steps, shortest first.
    pub fn steps(&self) -> Vec<f64> {
        let mut steps: Vec<f64> = self.survey.rows.iter().map(|row| row.step_s).collect();
        steps.sort_unstable_by(f64::total_cmp);
        steps.dedup();
        steps
    }

    fn figure(&self, outputs: Outputs, step: f64) -> Figure {
        let ours = self.survey.rows.iter().filter_map(|row| {
            let wanted = row.outputs == name_of(outputs) && row.step_s == step;
            let error = row.error().filter(|_| wanted)?;
            Some(Mark {
                name: row.name(),
                details: details(row.nanoseconds, Some(row.spread_ns), error, outputs),
                time: row.nanoseconds,
                spread: row.spread_ns,
                error,
                style: Style::new(&row.method, &row.scalar, row.lanes),
            })
        });
        let rivals = self.rivals.iter().filter_map(|rival| {
            let (time, error) = rival.point(name_of(outputs), step)?;
            Some(Mark {
                name: rival.method.clone(),
                details: [
                    rival.version.clone(),
                    rival.flags.clone(),
                    details(time, rival.spread_ns, error, outputs),
                ]
                .join("\n"),
                time,
                spread: rival.spread_ns.unwrap_or_default(),
                error,
                style: Style::rival(),
            })
        });
        Figure {
            title: format!("{}, step of {}", headline(outputs), milliseconds(step)),
            quantity: format!("worst error of {}, {}", a(outputs), unit_of(outputs)),
            // Ours are drawn on top.
            marks: rivals.chain(ours).collect(),
        }
    }

    /// The three figures of a time step, one below the other, as an SVG document.
    pub fn svg(&self, step: f64) -> String {
        let height = LEGEND.1 + 3.0 * SIZE.1;
        let figures = ALL_OUTPUTS.iter().enumerate().map(|(index, outputs)| {
            let down = format!("translate(0 {})", LEGEND.1 + SIZE.1 * index as f64);
            html! { g transform=(down) { (self.figure(*outputs, step).draw()) } }
        });
        let content = html! { (legend()) @for figure in figures { (figure) } };
        document(SIZE.0, height, &content).into_string()
    }

    fn latency_figure(&self) -> Option<Markup> {
        let Survey {
            latencies,
            latency_step,
            ..
        } = &self.survey;
        let title = format!("Time of single steps of {}", milliseconds(*latency_step));
        let drawn = || document(SIZE.0, SIZE.1, &latency_page::draw(&title, latencies));
        (!latencies.is_empty()).then(drawn)
    }

    /// The part of single steps that take longer, over time, as an SVG document.
    pub fn latency_svg(&self) -> Option<String> {
        self.latency_figure().map(Markup::into_string)
    }

    /// Returns the HTML document, which is self-contained.
    pub fn html(&self) -> String {
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    title { "Speed against accuracy" }
                    style { (PreEscaped(include_str!("page.css"))) }
                }
                body {
                    h1 { "Speed against accuracy" }
                    p { (self.motion) }
                    p { (PreEscaped(include_str!("page.txt"))) }
                    div.legend { (document(LEGEND.0, LEGEND.1, &legend())) }
                    @for step in self.steps() {
                        h2 { "Step of " (milliseconds(step)) }
                        div.figures {
                            @for outputs in ALL_OUTPUTS {
                                (document(SIZE.0, SIZE.1, &self.figure(outputs, step).draw()))
                            }
                        }
                        (self.table(step))
                    }
                    (self.rivals_table())
                    @if let Some(figure) = self.latency_figure() {
                        h2 { "Single steps" }
                        (figure)
                        (latency_page::table(&self.survey.latencies, self.clock))
                    }
                    @if !self.survey.missing.is_empty() {
                        h2 { "Not in the chart" }
                        ul { @for line in &self.survey.missing { li { (line) } } }
                    }
                }
            }
        };
        page.into_string()
    }

    fn table(&self, step: f64) -> Markup {
        let rows = self.survey.rows.iter().filter(|row| row.step_s == step);
        html! {
            details {
                summary { "Table" }
                table {
                    tr {
                        th { "method" } th { "number" } th { "lanes" } th { "computes" }
                        th { "time, ns" } th { "middle half within, ns" }
                        th { "position, m" } th { "velocity, m/s" } th { "acceleration, m/s²" }
                    }
                    @for row in rows {
                        tr {
                            td { (row.method) } td { (row.scalar) } td { (row.lanes) } td { (row.outputs) }
                            (time(Some(row.nanoseconds))) (time(Some(row.spread_ns)))
                            (number(row.error_position_m)) (number(row.error_velocity_m_s))
                            (number(row.error_acceleration_m_s2))
                        }
                    }
                }
            }
        }
    }

    fn rivals_table(&self) -> Markup {
        html! {
            @if !self.rivals.is_empty() {
                h2 { "Rivals" }
                details {
                summary { "Table" }
                table {
                    tr {
                        th { "rival" } th { "version" } th { "flags" } th { "quantity" } th { "step, s" }
                        th { "time, ns" } th { "middle half within, ns" }
                        th { "position, m" } th { "velocity, m/s" } th { "acceleration, m/s²" } th { "note" }
                    }
                    @for rival in &self.rivals {
                        tr {
                            td { (rival.method) } td { (rival.version) } td { (rival.flags) } td { (rival.quantity) }
                            (number(rival.step_s)) (time(rival.nanoseconds)) (time(rival.spread_ns))
                            (number(rival.error_position_m)) (number(rival.error_velocity_m_s))
                            (number(rival.error_acceleration_m_s2)) td { (rival.note) }
                        }
                    }
                }
                }
            }
        }
    }
}

/// An SVG document.
pub fn document(width: f64, height: f64, content: &Markup) -> Markup {
    let view = format!("0 0 {width} {height}");
    html! {
        svg xmlns="http://www.w3.org/2000/svg" viewBox=(view) width=(width) height=(height) font-family="sans-serif" {
            rect width="100%" height="100%" fill="white" {}
            (content)
        }
    }
}

fn number(value: Option<f64>) -> Markup {
    html! { td.number { @if let Some(value) = value { (rounded(value, 3)) } } }
}

fn time(nanoseconds: Option<f64>) -> Markup {
    html! { td.number { @if let Some(time) = nanoseconds { (format!("{time:.1}")) } } }
}

fn details(time: f64, spread: Option<f64>, error: f64, outputs: Outputs) -> String {
    let spread = spread.map_or_else(String::new, |spread| {
        format!(" (middle half within {} ns)", rounded(spread, 2))
    });
    let (time, error) = (rounded(time, 3), rounded(error, 2));
    format!("{time} ns{spread}\nerror {error} {}", unit_of(outputs))
}

fn headline(outputs: Outputs) -> &'static str {
    match outputs {
        Outputs::Position => "Position",
        Outputs::Velocity => "Position and velocity",
        Outputs::Acceleration => "Position, velocity and acceleration",
    }
}

fn a(outputs: Outputs) -> &'static str {
    match outputs {
        Outputs::Position => "a coordinate",
        Outputs::Velocity => "a velocity",
        Outputs::Acceleration => "an acceleration",
    }
}

fn milliseconds(step: f64) -> String {
    format!("{} ms", rounded(step * 1e3, 6))
}
