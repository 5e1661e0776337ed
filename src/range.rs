//! The usable range of each drive: how far it leads the mechanism, and what is beyond.

pub mod course;
pub mod locking;
pub mod meeting;
mod picture;
pub mod report;
pub mod station;

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::failure::Failure;
use crate::input::setup;
use crate::input::source::Source;
use crate::job::announce;
use crate::output::csv_file::{CsvFile, Target};
use crate::output::files::{print, refuse_input, write_file};
use crate::study::Study;
use course::DriveRange;

/// What to make of a file.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The motion file.
    pub file: PathBuf,
    /// Where every place of the curves goes.
    pub csv: Option<Target>,
    /// The folder for the plots.
    pub plots: Option<PathBuf>,
}

/// Finds the range of each drive of a file's mechanism, the others held as at the first instant.
///
/// # Errors
///
/// See [`Failure`]. What was found before the user interrupts is written.
pub fn range(wanted: &Wanted, interrupted: &AtomicBool) -> Result<(), Failure> {
    let source = Source::read(&wanted.file)?;
    if let Some(Target::File(csv)) = &wanted.csv {
        refuse_input(csv, &wanted.file, "--csv")?;
    }
    let (study, instants) = setup::load(&source)?;
    let ranges = study.ranges(&instants, interrupted)?;
    let mut written = Vec::new();
    if let Some(target) = &wanted.csv {
        table(&*study, &ranges, target)?;
        if let Target::File(path) = target {
            written.push(path.clone());
        }
    }
    if let Some(folder) = &wanted.plots {
        let stem = wanted.file.file_stem().unwrap_or_default();
        for range in &ranges {
            let name = format!("{}_range_{}.svg", stem.to_string_lossy(), range.name);
            let path = folder.join(name);
            if let Some(svg) = picture::chart(&*study, range).svg() {
                write_file(&path, &svg)?;
                written.push(path);
            }
        }
    }
    if wanted.csv.as_ref() != Some(&Target::Stdout) {
        print(&report::text(&*study, &instants, &ranges))?;
    }
    announce(&written);
    if interrupted.load(Ordering::Relaxed) {
        return Err(Failure::Interrupted(format!(
            "{}: interrupted; the curves are cut short",
            source.name()
        )));
    }
    Ok(())
}

fn table(study: &dyn Study, ranges: &[DriveRange], target: &Target) -> Result<(), Failure> {
    let mut table = CsvFile::create(target, &study.range_columns())?;
    for station in ranges.iter().flat_map(|range| &range.curve) {
        table.row(&station.row)?;
    }
    table.finish()
}
