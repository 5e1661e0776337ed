//! The program's two jobs: the published motion, and the motion of a file.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use crate::failure::Failure;
use crate::input::instants::Instants;
use crate::input::setup;
use crate::input::source::Source;
use crate::output::csv_file::Target;
use crate::output::files::{print, refuse_input, write_file};
use crate::output::plot::{Chart, Curve};
use crate::output::summary;
use crate::published::paper::Paper;
use crate::published::{comparison, figures};
use crate::study::sweep::{Outcome, Rows, run};
use crate::study::{End, Study, Timing};

/// The file that the published motion is solved from, and its name.
const BUILT_IN: (&str, &str) = (
    "examples/attia2003.toml",
    include_str!("../examples/attia2003.toml"),
);

/// The published motion.
pub fn built_in() -> Source {
    let (name, text) = BUILT_IN;
    Source::new(name, text)
}

/// Rows kept of a sweep for the summary and as marks in the plots.
const KEPT: usize = 12;

/// Solves the published motion, compares it with the paper and writes `out/attia2003*`.
///
/// # Errors
///
/// Where a result cannot be written, or the user interrupts.
pub fn published(interrupted: &AtomicBool) -> Result<(), Failure> {
    let source = built_in();
    let (study, instants) = setup::load(&source)?;
    let csv = PathBuf::from("out/attia2003.csv");
    let target = Target::File(csv.clone());
    let outcome = run(
        &*study,
        &instants,
        Some(&target),
        instants.count(),
        interrupted,
    )?;
    if let Some(failure) = outcome.failure(source.name(), Some(&target)) {
        return Err(failure);
    }
    let mut written = vec![csv];
    let files = Files {
        folder: Path::new("out"),
        stem: "attia2003",
    };
    written.extend(plots(
        &*study,
        &outcome,
        &instants,
        &files,
        figures::charts,
    )?);
    let mut report = comparison::text(&Paper::built_in(), &outcome.kept);
    report.push_str(&figures::text(&outcome.kept));
    report.push('\n');
    report.push_str(&summary::totals(&outcome, study.unit()));
    if let Some(timing) = study.time_a_step(instants.ends()) {
        report.push_str(&time_in_words(&timing));
    }
    print(&report)?;
    announce(&written);
    Ok(())
}

fn time_in_words(timing: &Timing) -> String {
    format!(
        "Time a step: {:.2} us for position, velocity and acceleration\n             (median of {} passes through the motion in {} steps of 1 ms)\n",
        timing.per_step.as_secs_f64() * 1e6,
        timing.passes,
        timing.steps,
    )
}

/// What to make of a file.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The motion file.
    pub file: PathBuf,
    /// Where every row goes.
    pub csv: Option<Target>,
    /// The folder for the plots.
    pub plots: Option<PathBuf>,
}

/// Solves the motion of a file.
///
/// # Errors
///
/// See [`Failure`]. Where the solver stops or the user interrupts, what was solved is written.
pub fn motion(wanted: &Wanted, interrupted: &AtomicBool) -> Result<(), Failure> {
    let source = Source::read(&wanted.file)?;
    if let Some(Target::File(csv)) = &wanted.csv {
        refuse_input(csv, &wanted.file, "--csv")?;
    }
    let (study, instants) = setup::load(&source)?;
    let outcome = run(&*study, &instants, wanted.csv.as_ref(), KEPT, interrupted)?;
    let mut written = Vec::new();
    if let Some(Target::File(path)) = &wanted.csv {
        written.push(path.clone());
    }
    if let Some(folder) = &wanted.plots {
        let stem = wanted.file.file_stem().unwrap_or_default();
        let files = Files {
            folder,
            stem: &stem.to_string_lossy(),
        };
        let charts = |rows: [&Rows; 2]| charts(&*study, rows);
        written.extend(plots(&*study, &outcome, &instants, &files, charts)?);
    }
    if wanted.csv.is_none() && wanted.plots.is_none() {
        print(&summary::text(&*study, &outcome))?;
    }
    announce(&written);
    let table = wanted.csv.as_ref();
    outcome.failure(source.name(), table).map_or(Ok(()), Err)
}

/// Names the files that were written.
pub fn announce(written: &[PathBuf]) {
    for path in written {
        eprintln!("wrote {}", path.display());
    }
}

struct Files<'a> {
    folder: &'a Path,
    stem: &'a str,
}

/// Draws the part of the motion that was solved; no file where nothing was, or where the user
/// has no time.
fn plots(
    study: &dyn Study,
    outcome: &Outcome,
    instants: &Instants,
    files: &Files<'_>,
    charts: impl Fn([&Rows; 2]) -> [(&'static str, Chart); 2],
) -> Result<Vec<PathBuf>, Failure> {
    const DENSE: usize = 401;
    let [first, _] = instants.ends();
    if outcome.solved == 0 || outcome.end == End::Cut {
        return Ok(Vec::new());
    }
    let dense = Instants::dense(first, outcome.farthest(), DENSE);
    let line = run(study, &dense, None, DENSE, &AtomicBool::new(false))?.kept;
    let every_instant_kept = outcome.kept.rows.len() == outcome.solved;
    let marks = if every_instant_kept {
        outcome.kept.clone()
    } else {
        Rows::default()
    };
    let mut written = Vec::new();
    for (name, chart) in charts([&line, &marks]) {
        let path = files.folder.join(format!("{}_{name}.svg", files.stem));
        if let Some(svg) = chart.svg() {
            write_file(&path, &svg)?;
            written.push(path);
        }
    }
    Ok(written)
}

const TIME: &str = "time t (s)";

/// Height of the wheel centre, and the angles of kingpin and wheel.
fn charts(study: &dyn Study, rows: [&Rows; 2]) -> [(&'static str, Chart); 2] {
    let points = study.points();
    let (centre, [lower, upper]) = (points.wheel_centre, points.kingpin);
    let unit = study.unit().symbol();
    let degrees = 1_f64.to_degrees();
    let height = Chart {
        title: "Height of the wheel centre".to_owned(),
        across: TIME.to_owned(),
        quantity: format!("height z ({unit})"),
        curves: vec![Curve::new(
            named("wheel centre", centre),
            &format!("{centre}_z"),
            1.0,
            rows,
        )],
    };
    let angles = Chart {
        title: "Kingpin angle and camber angle".to_owned(),
        across: TIME.to_owned(),
        quantity: "angle (deg)".to_owned(),
        curves: vec![
            Curve::new(
                format!("kingpin angle ({lower} to {upper})"),
                "kingpin_rad",
                degrees,
                rows,
            ),
            Curve::new("camber angle", "camber_rad", degrees, rows),
        ],
    };
    [("height", height), ("angles", angles)]
}

/// What a point is and its name, where that says something else.
fn named(what: &str, point: &str) -> String {
    if point.replace('_', " ") == what {
        what.to_owned()
    } else {
        format!("{what} {point}")
    }
}
