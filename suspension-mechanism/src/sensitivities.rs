//! How quantities at the design position, and their derivatives with respect to the drives, change with each hardpoint
//! coordinate and each link's length.
//!
//! A hardpoint is moved, the suspension built anew of its points and read at its new design position; a length is changed
//! with the drives held. Six such suspensions on either side give the derivative by the central difference of sixth order:
//! `(45 (f1 - f_1) - 9 (f2 - f_2) + f3 - f_3) / (60 h)`, `h` a thousandth of the suspension's size.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::characteristics::columns;
use crate::kinematics::{Changes, Kinematics};
use crate::mechanism::{Description, From, Grid, Order, Place};
use crate::quantities::{Axis, Column, Reader};

/// What is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// A coordinate of a point, by number.
    Coordinate(usize, Axis),
    /// A length, by number.
    Length(usize),
}

/// What a change does.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// The change.
    pub change: Change,
    /// Of each column the derivatives of its value and of its derivatives with respect to each drive, per unit of length;
    /// NaN where a neighbour has no such value.
    pub of: Vec<Vec<f64>>,
}

/// The columns that are read, of the file's lengths and of radians: value, then the derivative with respect to each drive.
pub struct Sensitivities {
    /// The quantities.
    pub columns: Vec<Column>,
    /// What they are at the design position.
    pub values: Vec<Vec<f64>>,
    /// What each change does; those that no suspension can be built with are left out.
    pub each: Vec<Sensitivity>,
}

/// How far neighbours are from each other, as a part of the suspension's size.
const STEP: f64 = 1e-3;

/// What can be changed: the coordinates of all points, and lengths by number, those of links.
pub fn changes(mechanism: &Description, lengths: &[usize]) -> Vec<Change> {
    let points = 0..mechanism.names.points.len();
    let coordinates =
        points.flat_map(|point| Axis::ALL.map(|axis| Change::Coordinate(point, axis)));
    let lengths = lengths.iter().copied().map(Change::Length);
    coordinates.chain(lengths).collect()
}

/// The sensitivities of a mechanism at its design position; `None` where the user interrupts.
pub fn sensitivities(
    mechanism: &dyn Kinematics,
    changes: &[Change],
    interrupted: &AtomicBool,
    mut on_change: impl FnMut(),
) -> Option<Sensitivities> {
    let columns = columns(mechanism);
    let step = STEP * size(mechanism);
    let mut each = Vec::new();
    for &change in changes {
        if interrupted.load(Ordering::Relaxed) {
            return None;
        }
        on_change();
        let at = |steps: i32| -> Option<Vec<Vec<f64>>> {
            let changes = changes_by(change, f64::from(steps) * step);
            read(&*mechanism.changed(&changes)?, &columns)
        };
        let neighbours = [-3, -2, -1, 1, 2, 3].map(at);
        let neighbours: Option<Vec<_>> = neighbours.into_iter().collect();
        each.extend(neighbours.map(|neighbours| Sensitivity {
            change,
            of: difference(&neighbours, step),
        }));
    }
    Some(Sensitivities {
        values: read(mechanism, &columns)?,
        columns,
        each,
    })
}

/// The largest extent of the points along an axis.
fn size(mechanism: &dyn Kinematics) -> f64 {
    let points = mechanism.points();
    let extent = |axis: usize| {
        let along = points.iter().map(|point| point[axis]);
        along.clone().fold(f64::NEG_INFINITY, f64::max) - along.fold(f64::INFINITY, f64::min)
    };
    (0..3).map(extent).fold(0.0, f64::max)
}

fn changes_by(change: Change, by: f64) -> Changes {
    match change {
        Change::Coordinate(point, axis) => Changes {
            points: vec![(point, axis.vector() * by)],
            ..Changes::default()
        },
        Change::Length(length) => Changes {
            lengths: vec![(length, by)],
            ..Changes::default()
        },
    }
}

/// Value and derivatives of each column where a mechanism starts.
fn read(mechanism: &dyn Kinematics, columns: &[Column]) -> Option<Vec<Vec<f64>>> {
    let grid = Grid::new(mechanism, Vec::new(), From::Start).ok()?;
    let mut of_place = |place: &dyn Place| {
        let state = place.state();
        let reader = Reader::of(&state);
        let drives = 0..mechanism.names.drives.len();
        let per: Vec<_> = drives.map(|drive| place.per(drive)).collect();
        let per: Vec<_> = per
            .iter()
            .map(|state| state.as_ref().map(Reader::of))
            .collect();
        let of_column = |column: &Column| {
            let rates = per.iter().map(|reader| {
                let reader = reader.as_ref().filter(|_| column.has_derivatives);
                reader.map_or(f64::NAN, |reader| column.read(reader).rate)
            });
            [column.read(&reader).value]
                .into_iter()
                .chain(rates)
                .collect()
        };
        columns.iter().map(of_column).collect()
    };
    let never = AtomicBool::new(false);
    let visited = mechanism.visit(&grid, Order::First, &never, &mut of_place);
    visited.places.into_iter().flatten().next()
}

/// The derivative of numbers from those three steps before to those three steps behind.
fn difference(neighbours: &[Vec<Vec<f64>>], step: f64) -> Vec<Vec<f64>> {
    const WEIGHTS: [f64; 6] = [-1.0, 9.0, -45.0, 45.0, -9.0, 1.0];
    let Some(first) = neighbours.first() else {
        return Vec::new();
    };
    let of = |column: usize, number: usize| {
        let weighted = neighbours.iter().zip(WEIGHTS);
        let sum: f64 = weighted
            .map(|(numbers, weight)| weight * numbers[column][number])
            .sum();
        sum / (60.0 * step)
    };
    let columns = first.iter().enumerate();
    columns
        .map(|(column, numbers)| {
            (0..numbers.len())
                .map(|number| of(column, number))
                .collect()
        })
        .collect()
}
