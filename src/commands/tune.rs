//! `suspension tune`: hardpoints moved within boxes until curves are met.

mod report;
mod rewritten_file;

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use clap::Args;

use crate::failure::Failure;
use crate::file::{MotionFile, Source};
use crate::grid::doubt;
use crate::kinematics::Kinematics;
use crate::mechanism::{CountedFrom, Description, GridAxis};
use crate::number::number;
use crate::output::default_path::name_of;
use crate::output::files::{announce, print, refuse_existing};
use crate::output::notes::{print_notes, print_notes_on, with_notes_printed};
use crate::output::progress::Progress;
use crate::output::target::Target;
use crate::prepare::{Loaded, load};
use crate::tune::{self, MOST_STEPS, Move, Tuned, tune};
use report::Report;
use rewritten_file::{left_recordings, rewritten};

/// The arguments of `suspension tune`.
#[derive(Args, Clone, Debug)]
#[command(after_long_help = NOTES)]
pub struct Arguments {
    /// The motion file (TOML) with [tune], see below.
    file: PathBuf,
    /// Write the motion file with the hardpoints found to PATH, or to standard output for `-`, in place of the report. Without it
    /// the file is NAME_tuned.toml beside FILE, which must not exist yet.
    #[arg(short, long, value_name = "PATH")]
    out: Option<PathBuf>,
}

impl Arguments {
    /// Moves the hardpoints and writes the file.
    ///
    /// # Errors
    ///
    /// See [`Failure`]; also [`Failure::Solver`] if a target is not met, although the file is written.
    pub fn run(&self, interrupted: &AtomicBool) -> Result<(), Failure> {
        let source = Source::read(&self.file)?;
        let usual = tuned_path(&self.file);
        if self.out.is_none() {
            refuse_existing(&usual, &usual)?;
        }
        let out = Target::from(self.out.clone().unwrap_or(usual));
        let stated = MotionFile::parse(&source)?;
        refuse_rough_points(&source, &stated)?;
        let loaded = load(&source)?;
        let mechanism = &*with_notes_printed(loaded.at_design()?);
        let (moves, targets) = loaded.tuning(mechanism)?;
        out.refuse_input("--out")?;
        if let Some(path) = out.path() {
            refuse_unreadable(path, &source, mechanism)?;
        }
        let whole = (source.name(), mechanism);
        tell_doubts(&loaded, whole, (&moves, &targets));
        let mut progress = Progress::new(MOST_STEPS, "steps");
        let tuned = tune(whole, &moves, &targets, interrupted, || progress.step())?;
        drop(progress);
        let report = Report {
            file: source.name(),
            mechanism,
            moves: &moves,
            targets: &targets,
            tuned: &tuned,
        };
        if out != Target::Stdout {
            print(&report.text())?;
        }
        let notes = [report.held(), report.idle()].into_iter().flatten();
        print_notes_on(source.name(), notes);
        let left = left_recordings(&stated, mechanism, &tuned.drives);
        print_notes_on(source.name(), left);
        let text = rewritten(&source, &stated, &loaded, mechanism, &tuned);
        check(out.path().unwrap_or(&self.file), &text, (mechanism, &tuned))?;
        out.write(&text)?;
        announce(out.path());
        ended(&report)
    }
}

/// Notes what is probably a mistake in moves and targets.
fn tell_doubts(
    loaded: &Loaded<'_>,
    (file, mechanism): (&str, &dyn Kinematics),
    (moves, targets): (&[Move], &[tune::Target]),
) {
    print_notes(loaded.one_sided_moves(mechanism));
    print_notes(loaded.doubtful_boxes(moves));
    print_notes_on(file, doubtful_ranges(mechanism, targets));
}

/// Returns why the result is not the one that the file asks for, if it is not.
fn ended(report: &Report<'_>) -> Result<(), Failure> {
    let file = report.file;
    if report.tuned.interrupted {
        let message = format!("{file}: interrupted; the best so far was written");
        return Err(Failure::Interrupted(message));
    }
    report.unmet().map_or(Ok(()), |unmet| {
        Err(Failure::Solver(format!("{file}: {unmet}")))
    })
}

/// Returns sentences on doubtful values of drives in the targets.
fn doubtful_ranges(mechanism: &dyn Kinematics, targets: &[tune::Target]) -> Vec<String> {
    let of_axis = |target: &tune::Target, axis: &GridAxis| {
        let (drive, _) = *axis.drives.iter().find(|(_, part)| *part > 0.0)?;
        let kind = mechanism.names.drives[drive].kind;
        let scale = mechanism.unit.file_factor(kind);
        let ends = [*axis.values.first()?, *axis.values.last()?];
        let [from, to] = ends.map(|end| number((end - mechanism.design[drive]) * scale));
        let key = match axis.drives_in_words(mechanism) {
            one if axis.drives.len() == 1 => one,
            joined => format!("\"{joined}\""),
        };
        let way = format!("; write {key} = [{from}, {to}]");
        let ends = ends.map(|end| end * scale);
        let range = (ends, mechanism.unit);
        let doubt = doubt(mechanism, drive, range, CountedFrom::Start, &way)?;
        Some(format!("[tune.targets.{}]: {doubt}", target.name))
    };
    let each = targets.iter();
    let each = each.flat_map(|target| target.over.iter().map(move |axis| (target, axis)));
    each.filter_map(|(target, axis)| of_axis(target, axis))
        .collect()
}

fn tuned_path(file: &Path) -> PathBuf {
    file.with_file_name(format!("{}_tuned.toml", name_of(file)))
}

/// Refuses a folder in which the files that the motion file names are missing.
fn refuse_unreadable(
    out: &Path,
    source: &Source,
    mechanism: &dyn Kinematics,
) -> Result<(), Failure> {
    let there = Source::new(out.display().to_string(), source.text());
    let read_there = load(&there).and_then(|loaded| {
        loaded.at_design()?;
        loaded.tuning(mechanism).map(|_| ())
    });
    read_there.map_err(|failure| {
        Failure::Input(format!(
            "--out {}: the file would not be read there: {failure}",
            out.display()
        ))
    })
}

/// Refuses a file with `[lengths]` or `[design]`: its points are a start of the assembly, not those of the design.
fn refuse_rough_points(source: &Source, file: &MotionFile) -> Result<(), Failure> {
    let lengths = file.lengths.as_ref().map(toml::Spanned::span);
    let design = file.design.as_ref().map(toml::Spanned::span);
    lengths.or(design).map_or(Ok(()), |place| {
        let message = "suspension tune moves the points of the design: state these in [points], without [lengths] and [design]; \
                       suspension motion prints them";
        Err(source.refuse(&place, message))
    })
}

/// Checks that the text gives the points that were found when it is read at a place.
fn check(at: &Path, text: &str, (mechanism, tuned): (&Description, &Tuned)) -> Result<(), Failure> {
    let source = Source::new(at.display().to_string(), text);
    let loaded = load(&source)?;
    let points = loaded.at_design()?.points();
    let is_near = |[a, b]: [&nalgebra::Vector3<f64>; 2]| {
        let size = 1.0 + a.amax().max(b.amax());
        (a - b).amax() <= rewritten_file::ROUNDING * size
    };
    let mut pairs = points.iter().zip(&tuned.points);
    let off = pairs.position(|(a, b)| !is_near([a, b]));
    off.map_or(Ok(()), |point| {
        Err(Failure::Input(format!(
            "{}: the file would not put `{}` where it was found: state it as coordinates, on a line of its own, in [points]",
            source.name(),
            mechanism.names.points[point]
        )))
    })
}

const NOTES: &str = "\
The motion file states what may be moved and what is to be reached, in its units: with unit = \"mm\" boxes and travel are in mm,
with angle = \"deg\" angles are in degrees. The numbers below are for a file in m and rad, those in parentheses for mm and degrees:

  [tune.moves.tie_rod_height]
  points = [\"tie_ball\"]             # these move together; a ball joint is one point
  mirrored = [\"right_tie_ball\"]     # points of the other side, which move as in a mirror
  along = \"z\"                       # \"x\", \"y\", \"z\" or a direction [x, y, z], in the file's axes
  by = [-0.020, 0.020]              # the box: from the least to the greatest ([-20.0, 20.0])

  [tune.moves.turnbuckle]
  length = \"tie_rod\"                # or a link's length, the drives held
  mirrored = [\"right_tie_rod\"]      # links of the other side, which become longer by as much
  by = [-0.005, 0.005]              # ([-5.0, 5.0])

  [tune.targets.bump_steer]
  of = \"toe\"                        # a measure, or a quantity by its name in tables without the unit
  over = { bump = [-0.060, 0.060] } # drives, from the design position ([-60.0, 60.0]); without `over` at that position.
                                    # As for sweep, { \"bump_left,-bump_right\" = ... } moves drives together, here in roll
  change = 0.0                      # from the design position; or value = ...; for one drive also a list, whose length
                                    # is the number of evenly spaced places: change = [0.1, 0.0, 0.2], or measured points
  within = 0.00035                  # the allowed error, in the unit of the quantity (0.02)

  [tune.targets.motion_ratio]
  of = \"damper\"
  per = \"bump\"                      # its derivative with respect to a drive
  value = -0.65
  within = 0.005

Measured points are pairs of a change of the drive from the design position and the number there, in any order and with any
spacing, in the units of the file; those within the range under over count. They are stated as a list or in a CSV file, whose
first line has headings, perhaps with a line of units below it; columns are the headings of the drive's column and of the
number's:

  value = [[-0.052, 0.0021], [-0.017, 0.0008], [0.049, -0.0019]]
  value = { csv = \"measured.csv\", columns = [\"travel\", \"toe\"] }

For each trial the suspension is built from the trial's points and solved at the places of each target: thirteen along each
drive, or those of its list or points. Starting from the points of the file, tune minimises the sum of squares of the targets'
errors, each divided by the allowed error. Trials that lock are left out. Tune finds a design near the file's points; it may
miss a better one far from them.

Tune prints a table of the moves and of the targets. It writes the motion file with the points found and leaves all else as
it is. Where a move changes the value of a drive at the design position, the constant of its law in [drives] changes by as
much: the first coefficient, the mean of a sine, the offset of a recording that states one. A marker that the file states as
an offset from a point moves with it; where a move turns its body, the offset changes.

Exit codes: 0 all targets are met, 1 a result cannot be written, 2 wrong input, 3 some targets are not met (the file is
written), or the design locks before all places of a target, 130 interrupted (the best so far is written).

Example:
  suspension tune examples/macpherson.toml";
