//! The program without a command: the published motion, and the paper's tables beside our results.

mod compared_column;
mod comparison;
mod figures;
pub mod paper;
mod timing;

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use crate::failure::Failure;
use crate::file::Source;
use crate::load::load;
use crate::output::files::{announce, print};
use crate::output::motion::plots::draw;
use crate::output::motion::record::record;
use crate::output::motion::summary;
use crate::output::notes::noted;
use crate::output::rows::Forms;
use crate::output::svg_folder::SvgFolder;
use crate::output::target::Target;
use paper::Paper;
use timing::Timing;

/// The name and the text of the motion file of the published motion.
const BUILT_IN: (&str, &str) = (
    "examples/attia2003.toml",
    include_str!("../../examples/attia2003.toml"),
);

/// The folder of the results, and the beginning of the files' names.
const WRITTEN: (&str, &str) = ("out", "attia2003");

/// Solves the published motion, compares it with the paper and writes `out/attia2003*`.
///
/// # Errors
///
/// If a result cannot be written, or the user interrupts.
pub fn run(interrupted: &AtomicBool) -> Result<(), Failure> {
    let (name, text) = BUILT_IN;
    let source = Source::new(name, text);
    let loaded = load(&source)?;
    let mechanism = &*noted(loaded.at_first_instant()?);
    let (folder, stem) = WRITTEN;
    let csv = PathBuf::from(format!("{folder}/{stem}.csv"));
    let forms = Forms {
        csv: Some(Target::File(csv.clone())),
        ..Forms::default()
    };
    let instants = &mechanism.instants;
    let keep = instants.count();
    let outcome = record(mechanism, instants, &forms, keep, interrupted)?;
    if let Some(failure) = outcome.failure(name, &forms) {
        return Err(failure);
    }
    let mut written = vec![csv];
    let folder = SvgFolder {
        folder: Path::new(folder),
        stem,
    };
    written.extend(draw(mechanism, &outcome, &folder, figures::charts)?);
    let paper = Paper::built_in();
    let mut report = comparison::text(&paper, &mechanism.names, &outcome.kept);
    report.push_str(&figures::text(&mechanism.names, &outcome.kept));
    report.push('\n');
    report.push_str(&summary::totals(&outcome, mechanism.unit));
    if let Some(timing) = timing::time_a_step(mechanism) {
        report.push_str(&in_words(&timing));
    }
    print(&report)?;
    announce(&written);
    Ok(())
}

fn in_words(timing: &Timing) -> String {
    format!(
        "Time a step: {:.2} us for position, velocity and acceleration\n             (median of {} passes through the motion in {} steps of 1 ms;\n             this build is quick to make, not the fastest: docs/speed.md has the times of others)\n",
        timing.per_step.as_secs_f64() * 1e6,
        timing.passes,
        timing.steps,
    )
}
