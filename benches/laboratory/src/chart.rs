//! The chart: the time of a step against its error, for every method.

pub mod axis;
pub mod baked;
pub mod by_series;
pub mod course;
pub mod figure;
pub mod formulation;
pub mod in_lanes;
pub mod labels;
pub mod latency;
pub mod latency_page;
pub mod method;
pub mod methods;
pub mod newton;
pub mod page;
pub mod pareto;
pub mod reference;
pub mod rows;
pub mod style;
pub mod survey;
pub mod timing;
pub mod tracked;
pub mod trial;

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::{Const, DimMin};
use suspension_core::linkage::Listing;
use suspension_core::linkages::{attia2003, five_link};

use course::Course;
use methods::Methods;
use page::Findings;
use reference::Reference;
use survey::{Effort, MILLISECOND, Plan, Survey, nearest_to};
use suspension::failure::Failure;
use suspension::file::Source;
use suspension::mechanism::Suspension;
use suspension::number::{number, rounded};
use suspension::output::files::{announce, refuse_input, write_file};
use suspension::prepare::{Loaded, load};
use suspension_double_double::DoubleDouble;

/// The contents of a chart, and where it is written.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The motion file; without one the published motion.
    pub file: Option<PathBuf>,
    /// The path of the table, in place of `chart.csv` in the folder.
    pub csv: Option<PathBuf>,
    /// The folder of the other files: `chart.svg`, `chart.html`, and `rivals.csv` if there is one.
    pub folder: PathBuf,
    /// The number of measurements.
    pub effort: Effort,
}

/// The last instant of the published motion in the chart, s: beyond, the mechanism nears a
/// singularity.
const LAST_OF_PUBLISHED: f64 = 1.9;

/// Steps of the shortest length that fit into memory.
const MOST_STEPS: f64 = 2e5;

/// Measures all methods and draws the chart.
///
/// # Errors
///
/// See [`Failure`]. If the user interrupts, the results so far are written.
pub fn chart(wanted: &Wanted, interrupted: &AtomicBool) -> Result<(), Failure> {
    let source = wanted
        .file
        .as_deref()
        .map_or_else(|| Ok(published()), Source::read)?;
    let csv = wanted.csv.clone();
    let csv = csv.unwrap_or_else(|| wanted.folder.join("chart.csv"));
    let rivals = rows::from_csv(&wanted.folder.join("rivals.csv"))?;
    let loaded = load(&source)?;
    refuse_input(&csv, "--csv")?;
    let [first, last] = loaded.instants().ends();
    let last = wanted.file.as_ref().map_or(LAST_OF_PUBLISHED, |_| last);
    check_steps(&source, [first, last], wanted.effort.steps[0])?;
    let measuring = Measuring {
        ends: [first, last],
        effort: &wanted.effort,
        interrupted,
    };
    let survey = measuring.survey_of(&source, &loaded)?;
    let motion = format!(
        "{}, {} of t = {} s to {} s",
        source.name(),
        loaded.linkage(),
        number(first),
        number(last)
    );
    let findings = Findings {
        motion,
        clock: latency::clock(),
        survey,
        rivals,
    };
    write(&findings, &wanted.folder, csv)?;
    if !findings.survey.missing.is_empty() {
        let count = findings.survey.missing.len();
        eprintln!("note: {count} measurements are not in the chart; the page says why");
    }
    if interrupted.load(Ordering::Relaxed) {
        let kept = findings.survey.rows.len();
        return Err(Failure::Interrupted(format!(
            "interrupted: {kept} rows were kept"
        )));
    }
    Ok(())
}

/// Refuses a motion of less than a step, and of more steps than fit into memory.
fn check_steps(source: &Source, [first, last]: [f64; 2], step: f64) -> Result<(), Failure> {
    let steps = (last - first).abs() / step;
    if (1.0..MOST_STEPS).contains(&steps) {
        return Ok(());
    }
    Err(Failure::Input(format!(
        "{}: a motion from t = {} s to {} s has {} steps of {} s; a chart takes from 1 to {}",
        source.name(),
        number(first),
        number(last),
        rounded(steps.floor(), 3),
        number(step),
        number(MOST_STEPS)
    )))
}

/// Returns the published motion.
fn published() -> Source {
    Source::new(
        "examples/attia2003.toml",
        include_str!("../../../examples/attia2003.toml"),
    )
}

fn write(findings: &Findings, folder: &Path, csv: PathBuf) -> Result<(), Failure> {
    let mut written = vec![csv];
    write_file(&written[0], &rows::to_csv(&findings.survey.rows)?)?;
    if let Some(step) = nearest_to(MILLISECOND, findings.steps().into_iter()) {
        let latencies = findings.latency_svg().map(|text| ("latency.svg", text));
        let page = [
            ("chart.svg", findings.svg(step)),
            ("chart.html", findings.html()),
        ];
        for (name, text) in page.into_iter().chain(latencies) {
            let path = folder.join(name);
            write_file(&path, &text)?;
            written.push(path);
        }
    }
    announce(&written);
    Ok(())
}

/// The motion between two times, with which all methods are measured.
struct Measuring<'a> {
    ends: [f64; 2],
    effort: &'a Effort,
    interrupted: &'a AtomicBool,
}

impl Measuring<'_> {
    /// Measures the linkage that a file names.
    fn survey_of(self, source: &Source, loaded: &Loaded<'_>) -> Result<Survey, Failure> {
        match loaded.catalogue_name() {
            Some("five_link") => self.survey::<five_link::Model<f64>, 15>(loaded),
            Some("attia2003") => self.survey::<attia2003::Model<f64>, 15>(loaded),
            _ => Err(Failure::Input(format!(
                "{}: a chart is measured of the linkages attia2003 and five_link, not of {}",
                source.name(),
                loaded.linkage()
            ))),
        }
    }

    /// Lanes and `lu()` of nalgebra are not available for every linkage that a program can run.
    fn survey<L, const N: usize>(self, loaded: &Loaded<'_>) -> Result<Survey, Failure>
    where
        L: Suspension<N, Listing: Default> + 'static,
        Const<N>: DimMin<Const<N>, Output = Const<N>>,
    {
        let mechanism = &loaded.mechanism::<L, N>()?;
        loaded.check_driven("suspension-laboratory chart", mechanism)?;
        let Self {
            ends,
            effort,
            interrupted,
        } = self;
        let model = &mechanism.model;
        let course = Course::<<L::Listing as Listing<N>>::Drives<f64>>::new(
            &mechanism.drives,
            ends,
            effort.steps[0],
        );
        let exact = L::Listing::rounded::<DoubleDouble>(model);
        let reference =
            Reference::new(model, &exact, &mechanism.start, &course).map_err(|(t, error)| {
                let cause = mechanism.names.cause(&error);
                Failure::Solver(format!("no motion at t = {} s: {cause}", number(t)))
            })?;
        let [position, ..] = &reference.instants()[0];
        let single = L::Listing::rounded::<f32>(model);
        let tables = baked::tables(mechanism, &course);
        let mut methods = Methods { rows: Vec::new() };
        methods.add_scalar(model, model, position);
        methods.add_scalar(model, &single, position);
        methods.add_lanes::<L::Listing, f64>(model);
        methods.add_lanes::<L::Listing, f32>(&single);
        for (name, tables) in &tables {
            methods.add_baked(name, tables);
        }
        let plan = Plan {
            methods,
            course: &course,
            reference: &reference,
            effort,
            metre: mechanism.unit.metre(),
            interrupted,
        };
        Ok(plan.survey())
    }
}
