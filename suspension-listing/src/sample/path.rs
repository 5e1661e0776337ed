//! Positions along the motion: from the design, each drive of a free point is moved both ways by the
//! tangent.
//! Lengths drift a little on the way, which the size of pivots does not notice.

use super::{Design, derivative};
use crate::system::{Equation, System};

/// A step of a drive, and the farthest that it goes, as parts of the longest distance.
const STEP: f64 = 0.1;
const STEPS: usize = 8;

/// Each step is made in so many, so that lengths drift by a few parts in a hundred at most.
const SUBSTEPS: usize = 8;

/// Where a point moves farther than this for each step of the drive, the motion is about to turn.
const LARGEST_RATE: f64 = 6.0;

/// More unknowns than a compiler should be held up with.
const MOST_UNKNOWNS: usize = 60;

/// The design position, where all of it is stated, and others that the drives lead to from there.
pub fn positions(system: &System) -> Vec<Design> {
    let points = system.free.iter().chain(&system.fixed);
    let is_stated = points.map(|point| point.name.to_string());
    if !is_stated
        .into_iter()
        .all(|name| system.design.contains_key(&name))
    {
        return Vec::new();
    }
    let mut positions = vec![system.design.clone()];
    if system.size() > MOST_UNKNOWNS {
        return positions;
    }
    let step = STEP * longest(system);
    for row in driven_rows(system) {
        for step in [step, -step] {
            let substep = step / SUBSTEPS as f64;
            let substeps = std::iter::successors(Some(system.design.clone()), |design| {
                moved(system, design, row, substep)
            });
            let steps = substeps.step_by(SUBSTEPS).skip(1);
            positions.extend(steps.take(STEPS));
        }
    }
    positions
}

/// The rows that prescribe a coordinate of a free point.
fn driven_rows(system: &System) -> Vec<usize> {
    let mut first_row = 0;
    let mut rows = Vec::new();
    for equation in &system.equations {
        if matches!(equation, Equation::Coordinate { .. }) {
            rows.push(first_row);
        }
        first_row += equation.rows().len();
    }
    rows
}

fn longest(system: &System) -> f64 {
    let lengths = system
        .equations
        .iter()
        .filter_map(|equation| match equation {
            Equation::Distance { from, to, .. } => {
                let at = |name: &syn::Ident| system.design.get(&name.to_string()).copied();
                let d = super::minus(at(&to.name)?, at(&from.name)?);
                Some(super::dot(d, d).sqrt())
            }
            _ => None,
        });
    lengths.fold(0.0, f64::max)
}

/// The design after a step of one drive, by the midpoint rule; `None` where the motion ends.
fn moved(system: &System, design: &Design, row: usize, step: f64) -> Option<Design> {
    let half = displaced(system, design, &tangent(system, design, row)?, step / 2.0);
    let rate = tangent(system, &half, row)?;
    let is_gentle = rate.iter().all(|rate| rate.abs() <= LARGEST_RATE);
    is_gentle.then(|| displaced(system, design, &rate, step))
}

fn displaced(system: &System, design: &Design, rate: &[f64], step: f64) -> Design {
    let mut design = design.clone();
    for (point, rate) in system.free.iter().zip(rate.chunks_exact(3)) {
        if let Some(position) = design.get_mut(&point.name.to_string()) {
            for (coordinate, rate) in position.iter_mut().zip(rate) {
                *coordinate += step * rate;
            }
        }
    }
    design
}

/// How the unknowns change with the drive of a row.
fn tangent(system: &System, design: &Design, row: usize) -> Option<Vec<f64>> {
    let n = system.size();
    let mut matrix = vec![vec![0.0; n + 1]; n];
    for place in system.places() {
        let value = derivative(
            place.equation,
            place.row_of_equation,
            place.point,
            place.axis,
            design,
        );
        matrix[place.row][place.column] = value?;
    }
    matrix[row][n] = 1.0;
    solved(matrix)
}

/// The solution of linear equations with the right-hand side as last column; `None` where they
/// are singular.
fn solved(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let n = rows.len();
    for k in 0..n {
        let size = |row: &Vec<f64>| row[k].abs();
        let best = (k..n).max_by(|&a, &b| size(&rows[a]).total_cmp(&size(&rows[b])))?;
        rows.swap(k, best);
        let pivot_row = rows[k].clone();
        if pivot_row[k].abs() < 1e-9 {
            return None;
        }
        for row in rows.iter_mut().skip(k + 1).filter(|row| row[k] != 0.0) {
            let factor = row[k] / pivot_row[k];
            for (entry, of_pivot) in row.iter_mut().zip(&pivot_row).skip(k) {
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
