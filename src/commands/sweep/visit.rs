//! From place to place of a grid, away from the first instant, so that a lock on one side loses no other.

use std::sync::atomic::{AtomicBool, Ordering};

use suspension_core::{Inputs, Motion, Signal, SolveError, Values};

use super::grid::Grid;
use super::table::{Columns, Row};
use crate::failure::Failure;
use crate::mechanism::{DriveLaws, Mechanism, Polynomial, State, Suspension, follow};
use crate::output::progress::Progress;

/// What was found on a grid.
pub(super) struct Visited {
    /// A row each place, in the order of the grid; empty where it has no configuration.
    pub(super) rows: Vec<Row>,
    solved: usize,
    /// Where a way ended first, in words.
    stopped: Option<String>,
    interrupted: bool,
}

impl Visited {
    /// What remains to be said where places are missing.
    pub(super) fn failure(&self, source: &str) -> Option<Failure> {
        let (solved, all) = (self.solved, self.rows.len());
        let written = format!("the rows of the {solved} others were written");
        if self.interrupted {
            let missing = all - solved;
            return Some(Failure::Interrupted(format!(
                "{source}: interrupted; {missing} of {all} places are missing, {written}"
            )));
        }
        let stopped = self.stopped.as_ref()?;
        Some(Failure::Solver(format!(
            "{source}: {} of {all} places have no configuration on the way from the first instant: {stopped}; {written}",
            all - solved
        )))
    }
}

/// Solves the mechanism at each place.
pub(super) fn visit<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    grid: &Grid,
    columns: &Columns,
    interrupted: &AtomicBool,
) -> Visited {
    let places = grid.places().unwrap_or_default();
    let mut visitor = Visitor {
        mechanism,
        grid,
        columns,
        interrupted,
        progress: Progress::new(places, "places"),
        visited: Visited {
            rows: vec![Row::new(); places],
            solved: 0,
            stopped: None,
            interrupted: false,
        },
    };
    let start = Place {
        index: 0,
        drives: grid.start.clone(),
        motion: mechanism.start,
        residual: 0.0,
    };
    visitor.along_axes(0, &start);
    visitor.visited
}

/// The mechanism at a place.
#[derive(Clone)]
struct Place<const N: usize> {
    /// The place's number, as far as the axes before tell it.
    index: usize,
    drives: Vec<f64>,
    motion: Motion<f64, N>,
    residual: f64,
}

struct Visitor<'a, L: suspension_core::Linkage<N>, const N: usize> {
    mechanism: &'a Mechanism<L, N>,
    grid: &'a Grid,
    columns: &'a Columns,
    interrupted: &'a AtomicBool,
    progress: Progress,
    visited: Visited,
}

impl<L: Suspension<N>, const N: usize> Visitor<'_, L, N> {
    /// Visits the places along the axes from `level` on, both ways from `here`.
    fn along_axes(&mut self, level: usize, here: &Place<N>) {
        let grid = self.grid;
        let Some((drive, values)) = grid.axes.get(level) else {
            self.record(here);
            return;
        };
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
        let (mut below, above): (Vec<usize>, Vec<usize>) = order
            .into_iter()
            .partition(|index| values[*index] < here.drives[*drive]);
        below.reverse();
        for way in [above, below] {
            let mut place = here.clone();
            place.motion = Motion {
                positive_determinant: here.motion.positive_determinant,
                ..Motion::at_rest(here.motion.position)
            };
            for index in way {
                if self.interrupted.load(Ordering::Relaxed) {
                    self.visited.interrupted = true;
                    return;
                }
                if let Err(stopped) = self.drive_to(&mut place, *drive, values[index]) {
                    self.visited.stopped.get_or_insert(stopped);
                    break;
                }
                place.index = here.index * values.len() + index;
                self.along_axes(level + 1, &place);
            }
        }
    }

    /// Drives the mechanism to a value of a drive.
    fn drive_to(&self, place: &mut Place<N>, drive: usize, value: f64) -> Result<(), String> {
        let ends = place.drives.iter().enumerate();
        let laws = DriveLaws::new(ends.map(|(index, from)| {
            Polynomial::line(*from, if index == drive { value } else { *from })
        }));
        match follow(&self.mechanism.model, &laws, [0.0, 1.0], &mut place.motion) {
            Ok(report) => {
                place.drives[drive] = value;
                place.residual = report.residual();
                Ok(())
            }
            Err(stopped) => {
                let reached = laws.inputs::<L::Drives>(stopped.reached).drives.value;
                Err(self.stop_in_words(&reached, stopped.refused.map(|(_, error)| error)))
            }
        }
    }

    fn stop_in_words(&self, reached: &L::Drives, cause: Option<SolveError<f64>>) -> String {
        let Mechanism { names, unit, .. } = self.mechanism;
        let drives = names.drives_in_words(&self.mechanism.given(reached), *unit, None);
        let cause = cause.map_or_else(String::new, |error| format!(" ({})", names.cause(&error)));
        format!("one way ends at {drives}{cause}")
    }

    fn record(&mut self, place: &Place<N>) {
        let Self {
            mechanism, columns, ..
        } = self;
        let drives = L::Drives::from_values(place.drives.iter().copied());
        let position = &place.motion.position;
        let inputs = Inputs::still(Signal::still(drives));
        let points = Motion::at_rest(*position)
            .points(&mechanism.model, &inputs)
            .value;
        let state = State {
            residual: place.residual,
            ..mechanism.at_rest(0.0, &drives, points)
        };
        let state = mechanism.with_directions(state, &drives, position);
        let per = |drive| {
            let points = mechanism.per(drive, &drives, position)?;
            Some(mechanism.state(0.0, &drives, &points))
        };
        self.visited.rows[place.index] = columns.row(&state, per);
        self.visited.solved += 1;
        self.progress.step();
    }
}
