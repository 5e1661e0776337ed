//! The failure map: for each method how often it finds the right configuration, another one, or none.

pub mod axes;
pub mod closure;
pub mod drift_figure;
pub mod figure;
pub mod integration;
pub mod long_run;
pub mod marquardt;
pub mod method;
pub mod outcome;
pub mod page;
pub mod rows;
pub mod survey;
pub mod trial;
pub mod truth;
pub mod turning;

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::SVector;
use suspension_core::linkage::Listing;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::listing::Parts;
use suspension_core::step::stepper::Stopped;

use axes::{POINTS, Subject};
use closure::{Closures, NINE_DISTANCES, RIGID_BODY};
use long_run::{LongRun, Way, looks};
use page::Findings;
use rows::to_csv;
use survey::{Counted, Effort, Survey};
use suspension::failure::Failure;
use suspension::file::Source;
use suspension::mechanism::{DriveLaws, Mechanism, Names, Suspension};
use suspension::number::number;
use suspension::output::files::{announce, refuse_input, write_file};
use suspension::output::progress::Progress;
use suspension::prepare::{Loaded, load};
use truth::Truth;
use turning::turning_points;

/// The methods to try, and where the results are written.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The motion file.
    pub file: PathBuf,
    /// The folder of `failures.csv`, `failures.svg` and `failures.html`.
    pub folder: PathBuf,
    /// The number of trials.
    pub effort: Effort,
}

const COMMAND: &str = "suspension-laboratory failures";
const TABLE: &str = "failures.csv";

/// Tries all methods and draws the map.
///
/// # Errors
///
/// See [`Failure`]. If the user interrupts, the results so far are written.
pub fn failures(wanted: &Wanted, interrupted: &AtomicBool) -> Result<(), Failure> {
    let source = Source::read(&wanted.file)?;
    let loaded = load(&source)?;
    refuse_input(&wanted.folder.join(TABLE), "--out")?;
    let [first, last] = loaded.instants().ends();
    if first == last {
        let name = source.name();
        return Err(Failure::Input(format!(
            "{name}: a motion of one instant has no steps to try"
        )));
    }
    let trying = Trying {
        ends: [first, last],
        effort: &wanted.effort,
        interrupted,
    };
    let counted = match loaded.catalogue_name() {
        Some("five_link") => trying.compiled::<five_link::Model<f64>, 15>(&loaded),
        Some("attia2003") => trying.compiled::<attia2003::Model<f64>, 15>(&loaded),
        _ => Err(Failure::Input(format!(
            "{}: the map is of the linkages attia2003 and five_link, not of {}",
            source.name(),
            loaded.linkage()
        ))),
    }?;
    let findings = Findings {
        motion: format!(
            "{}, {} of t = {} s to {} s",
            source.name(),
            loaded.linkage(),
            number(first),
            number(last)
        ),
        effort: wanted.effort,
        counted,
    };
    write(&findings, &wanted.folder)?;
    if interrupted.load(Ordering::Relaxed) {
        let kept = findings.counted.rows.len();
        return Err(Failure::Interrupted(format!(
            "interrupted: {kept} rows were kept"
        )));
    }
    Ok(())
}

fn write(findings: &Findings, folder: &Path) -> Result<(), Failure> {
    let Counted { rows, long_runs } = &findings.counted;
    let mut files = vec![(TABLE, to_csv(rows)?)];
    if !rows.is_empty() {
        files.push(("failures.svg", findings.svg()));
        files.push(("failures.html", findings.html()));
    }
    if !long_runs.is_empty() {
        files.push(("long_runs.csv", to_csv(long_runs)?));
    }
    let mut written = Vec::new();
    for (name, text) in files {
        let path = folder.join(name);
        write_file(&path, &text)?;
        written.push(path);
    }
    announce(&written);
    Ok(())
}

/// All methods, tried between two times. A five-link suspension is tried with its knuckle closed by nine
/// distances and as a rigid body.
struct Trying<'a> {
    ends: [f64; 2],
    effort: &'a Effort,
    interrupted: &'a AtomicBool,
}

impl Trying<'_> {
    /// Tries all methods on the linkage as the macro wrote it.
    fn compiled<L, const N: usize>(self, loaded: &Loaded<'_>) -> Result<Counted, Failure>
    where
        L: Suspension<N, Listing: Default>,
    {
        let mechanism = loaded.mechanism::<L, N>()?;
        loaded.check_driven(COMMAND, &mechanism)?;
        self.on(&mechanism)
    }

    fn on<L: Suspension<N>, const N: usize>(
        self,
        mechanism: &Mechanism<L, N>,
    ) -> Result<Counted, Failure> {
        let Self {
            ends,
            effort,
            interrupted,
        } = self;
        let closures = Closures::of(mechanism);
        let models = if closures.is_some() { 4 } else { 2 };
        let mut survey = Survey {
            effort,
            metre: mechanism.unit.metre(),
            interrupted,
            counted: Counted::default(),
            progress: Progress::new(models * POINTS + 4 * looks(effort.long_run), "parts"),
        };
        let motion = Followed {
            drives: &mechanism.drives,
            ends,
        };
        let stopped = match &closures {
            None => {
                let start = &mechanism.start.position;
                motion.add(&mut survey, &mechanism.linkage, &mechanism.model, start)
            }
            Some(closures) => {
                let Closures {
                    nine_distances,
                    rigid_body,
                    start,
                } = closures;
                let first = motion.add(&mut survey, NINE_DISTANCES, nine_distances, start);
                first.and_then(|()| motion.add(&mut survey, RIGID_BODY, rigid_body, start))
            }
        };
        stopped.map(|()| survey.counted)
    }
}

/// A motion that is tried with several models.
struct Followed<'a> {
    drives: &'a DriveLaws,
    ends: [f64; 2],
}

impl Followed<'_> {
    /// Tries all methods on a model, in both number types.
    fn add<L: Suspension<N>, const N: usize>(
        &self,
        survey: &mut Survey<'_>,
        closure: &str,
        model: &L,
        start: &SVector<f64, N>,
    ) -> Result<(), Failure> {
        let truth = Truth::new(model, self.drives, start, self.ends)
            .map_err(|stopped| self.no_motion(model, &stopped))?;
        let subject = Subject {
            closure,
            truth: &truth,
            turning_points: &turning_points(&truth),
            model,
        };
        subject.try_all(survey);
        let single = L::Listing::rounded::<f32>(model);
        subject.with_model(&single).try_all(survey);
        // The formulation of bodies does not matter here.
        if closure != NINE_DISTANCES {
            for way in Way::ALL {
                long_run::add(survey, closure, LongRun::new(way, model, &truth));
                long_run::add(survey, closure, LongRun::new(way, &single, &truth));
            }
        }
        Ok(())
    }

    fn no_motion(&self, model: &impl Parts, stopped: &Stopped<f64>) -> Failure {
        let cause = stopped.refused.map_or_else(String::new, |(_, error)| {
            format!(": {}", Names::new(model).cause(&error))
        });
        let reached = number(stopped.reached);
        Failure::Solver(format!("no motion beyond t = {reached} s{cause}"))
    }
}
