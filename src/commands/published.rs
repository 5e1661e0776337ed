//! The program without a command: the published motion, and the paper's tables beside our results.

mod compared_column;
mod comparison;
mod figures;
pub mod paper;
mod timing;

use std::path::Path;
use std::sync::atomic::AtomicBool;

use crate::failure::Failure;
use crate::file::Source;
use crate::output::default_path::in_out;
use crate::output::destinations::table_targets;
use crate::output::files::{announce, print};
use crate::output::motion::plots::draw;
use crate::output::motion::record::record;
use crate::output::motion::summary;
use crate::output::notes::with_notes_printed;
use crate::output::svg_folder::SvgFolder;
use crate::prepare::load;
use paper::Paper;

/// The name and the text of the motion file of the published motion.
const BUILT_IN: (&str, &str) = (
    "examples/attia2003.toml",
    include_str!("../../examples/attia2003.toml"),
);

/// Solves the published motion, compares it with the paper and writes `out/attia2003*`.
///
/// # Errors
///
/// If a result cannot be written, or the user interrupts.
pub fn run(interrupted: &AtomicBool) -> Result<(), Failure> {
    let (name, text) = BUILT_IN;
    let source = Source::new(name, text);
    let loaded = load(&source)?;
    let mechanism = &*with_notes_printed(loaded.at_first_instant()?);
    let csv = in_out(Path::new(name), ".csv");
    let tables = table_targets([&Some(csv.clone()), &None, &None]);
    let instants = &mechanism.instants;
    let keep = instants.count();
    let outcome = record(mechanism, instants, &tables, keep, interrupted)?;
    if let Some(failure) = outcome.failure(name, &tables) {
        return Err(failure);
    }
    let mut written = vec![csv];
    let folder = SvgFolder::new(Path::new("out"), Path::new(name));
    written.extend(draw(mechanism, &outcome, &folder, figures::charts)?);
    let paper = Paper::built_in();
    let mut report = comparison::text(&paper, &mechanism.names, &outcome.kept);
    report.push_str(&figures::text(&mechanism.names, &outcome.kept));
    report.push('\n');
    report.push_str(&summary::totals(&outcome, mechanism.unit));
    report.extend(timing::text(mechanism));
    print(&report)?;
    announce(&written);
    Ok(())
}
