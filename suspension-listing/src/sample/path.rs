//! Positions along the motion: from the design, each drive of a free point moves both ways along the
//! tangent.
//! Lengths drift a little on the way, which hardly affects the size of pivots.

use super::MOST_SAMPLED;
use super::entries::value;
use super::gradient::gradients;
use crate::system::{Place, Positions, System};
use crate::vector::{dot, minus};

/// The step of a drive, and its largest travel, as fractions of the longest distance.
const STEP: f64 = 0.1;
const STEPS: usize = 8;

/// The number of substeps of each step, so that lengths drift by at most a few hundredths.
const SUBSTEPS: usize = 8;

/// If a point moves farther than this per step of the drive, the motion is about to turn.
const LARGEST_RATE: f64 = 6.0;

/// A design position, and other positions to which the drives lead from there.
pub fn positions(system: &System, design: Positions) -> Vec<Positions> {
    let mut positions = vec![design.clone()];
    if system.size() > MOST_SAMPLED {
        return positions;
    }
    let step = STEP * longest(system, &design);
    let places = system.places();
    for row in driven_rows(system) {
        for step in [step, -step] {
            let substep = step / SUBSTEPS as f64;
            let substeps = std::iter::successors(Some(design.clone()), |position| {
                moved(system, &places, position, row, substep)
            });
            let steps = substeps.step_by(SUBSTEPS).skip(1);
            positions.extend(steps.take(STEPS));
        }
    }
    positions
}

/// The rows that prescribe something of a free point.
fn driven_rows(system: &System) -> Vec<usize> {
    let mut first_row = 0;
    let mut rows = Vec::new();
    for equation in &system.equations {
        let form = equation.form.equations();
        if form.drive().is_some() {
            rows.push(first_row);
        }
        first_row += form.rows();
    }
    rows
}

fn longest(system: &System, design: &Positions) -> f64 {
    let equations = system.equations.iter();
    let kept = equations.filter_map(|equation| equation.form.equations().keeps());
    let lengths = kept.map(|[from, to]| {
        let d = minus(design.at(to), design.at(from));
        dot(d, d).sqrt()
    });
    lengths.fold(0.0, f64::max)
}

/// The position after a step of one drive, by the midpoint rule; `None` if the motion ends.
fn moved(
    system: &System,
    places: &[Place<'_>],
    position: &Positions,
    row: usize,
    step: f64,
) -> Option<Positions> {
    let start = tangent(system, places, position, row)?;
    let half = displaced(position, &start, step / 2.0);
    let rate = tangent(system, places, &half, row)?;
    let is_gentle = rate.iter().all(|rate| rate.abs() <= LARGEST_RATE);
    is_gentle.then(|| displaced(position, &rate, step))
}

fn displaced(position: &Positions, rate: &[f64], step: f64) -> Positions {
    let mut displaced = position.clone();
    let coordinates = displaced.free.iter_mut().flatten();
    for (unknown, rate) in coordinates.chain(&mut displaced.scalars).zip(rate) {
        *unknown += step * rate;
    }
    displaced
}

/// The derivative of the unknowns with respect to the drive of a row.
fn tangent(
    system: &System,
    places: &[Place<'_>],
    position: &Positions,
    row: usize,
) -> Option<Vec<f64>> {
    // If it is smaller, the equations do not determine the direction.
    const SMALLEST_PIVOT: f64 = 1e-9;
    rates(system, places, position, row, SMALLEST_PIVOT)
}

/// The same derivative; `None` if a pivot is too small.
pub(super) fn rates(
    system: &System,
    places: &[Place<'_>],
    position: &Positions,
    row: usize,
    smallest_pivot: f64,
) -> Option<Vec<f64>> {
    let n = system.size();
    let gradients = gradients(system, position)?;
    let mut matrix = vec![vec![0.0; n + 1]; n];
    for place in places {
        matrix[place.row][place.column] = value(place, &gradients);
    }
    matrix[row][n] = 1.0;
    solved(matrix, smallest_pivot)
}

/// The solution of linear equations with the right-hand side as the last column; `None` if they are singular, or
/// nearly so.
fn solved(mut rows: Vec<Vec<f64>>, smallest_pivot: f64) -> Option<Vec<f64>> {
    let n = rows.len();
    for k in 0..n {
        let size = |row: &Vec<f64>| row[k].abs();
        let best = (k..n).max_by(|&a, &b| size(&rows[a]).total_cmp(&size(&rows[b])))?;
        rows.swap(k, best);
        let (above, below) = rows.split_at_mut(k + 1);
        let pivot_row = &above[k][k..];
        if pivot_row[0].abs() < smallest_pivot {
            return None;
        }
        for row in below.iter_mut().filter(|row| row[k] != 0.0) {
            let factor = row[k] / pivot_row[0];
            for (entry, of_pivot) in row[k..].iter_mut().zip(pivot_row) {
                *entry -= factor * of_pivot;
            }
        }
    }
    let mut solution = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| rows[k][j] * solution[j]).sum();
        solution[k] = (rows[k][n] - known) / rows[k][k];
    }
    Some(solution)
}
