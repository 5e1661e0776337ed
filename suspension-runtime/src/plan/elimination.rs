//! The order of elimination as indices into the stored numbers of the factors.
//!
//! Stored are, for each step in order, the pivot (later its inverse) and what is right of it; then, for
//! each step in order, the multipliers left of its pivot. Steps of carried points are not among them:
//! frame and constants stand for their rows.

use std::collections::BTreeMap;

use suspension_listing::eliminate::{self, Order};
use suspension_listing::system::System;

use super::{index, position};

/// The last place of any table: what is not needed goes there.
pub(crate) const SPARE: u16 = u16::MAX;

/// The last place but one: among the stored numbers it is zero.
pub(crate) const ZERO: u16 = u16::MAX - 1;

/// What factorisation and solutions walk.
#[derive(Clone, Debug)]
pub(crate) struct Elimination {
    pub(crate) stored: BTreeMap<(usize, usize), u16>,
    pub(crate) steps: Vec<Step>,
    /// For each step, the numbers right of the pivot.
    pub(crate) uppers: Vec<u16>,
    /// For each step, for each row below it: the multiplier.
    pub(crate) multipliers: Vec<u16>,
    /// For each of those, for each number right of the pivot: what it is subtracted from.
    pub(crate) targets: Vec<u16>,
    /// Numbers that start from nothing.
    pub(crate) filled: Vec<u16>,
    /// For each unknown the row of the step that finds it.
    pub(crate) row_of: Vec<u16>,
    /// From the first step to the last, what the rows before it take of a row.
    pub(crate) forward: Rows,
    /// From the last step to the first, what the unknowns found so far take of a row; each begins with the
    /// inverse of the pivot.
    pub(crate) backward: Rows,
    pub(crate) carriers: Vec<Carrier>,
    pub(crate) reductions: Vec<Reduction>,
    /// Whether the order changes the sign of the determinant.
    pub(crate) is_odd: bool,
}

/// Rows and their terms, one row after the other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rows {
    pub(crate) rows: Vec<Row>,
    /// The unknowns in whose places the factors of the terms are.
    pub(crate) terms: Vec<u16>,
}

/// A row of a triangular factor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    /// The unknown in whose place it is.
    pub(crate) place: u16,
    /// How many terms it has.
    pub(crate) terms: u16,
}

impl Rows {
    fn push(&mut self, place: usize, terms: impl ExactSizeIterator<Item = usize>) {
        self.rows.push(Row { place: index(place), terms: index(terms.len()) });
        self.terms.extend(terms.map(index));
    }
}

/// A pivot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub(crate) pivot: u16,
    pub(crate) right: u16,
    pub(crate) below: u16,
    /// Whether it is 1 in every position.
    pub(crate) unit: bool,
}

/// A body with points that are taken out first.
#[derive(Clone, Debug)]
pub(crate) struct Carrier {
    pub(crate) body: u16,
    /// Where the factors keep the edges of its frame.
    pub(crate) edges: u16,
    /// The first unknowns of the frame's points; beyond all of them for a chassis point.
    pub(crate) frame: [u16; 3],
    pub(crate) points: Vec<Substituted>,
}

/// A carried point that is taken out first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Substituted {
    /// Its place among all carried points.
    pub(crate) constant: u16,
    /// The first of its unknowns.
    pub(crate) column: u16,
    /// How many of the reductions are its own.
    pub(crate) reductions: u16,
}

/// A row that depends on a carried point, and on its frame instead.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reduction {
    /// The derivatives by the point.
    pub(crate) gradient: [u16; 3],
    /// Those by the frame's points.
    pub(crate) sums: [u16; 9],
}

impl Elimination {
    pub(crate) fn new(system: &System, order: &Order) -> Self {
        let steps: Vec<&eliminate::Step> =
            order.steps.iter().filter(|step| !step.carried).collect();
        let (mut stored, mut forward, mut backward) = (BTreeMap::new(), Rows::default(), Rows::default());
        let mut store = |row, column| {
            let next = index(stored.len());
            stored.insert((row, column), next);
        };
        for step in &steps {
            let left: Vec<_> = (order.steps.iter())
                .filter(|from| from.below.contains(&step.row))
                .collect();
            for from in &left {
                store(step.row, from.column);
            }
            if !left.is_empty() {
                forward.push(step.column, left.iter().map(|from| from.column));
            }
        }
        for step in steps.iter().rev() {
            store(step.row, step.column);
            for &column in &step.right {
                store(step.row, column);
            }
            backward.push(step.column, step.right.iter().copied());
        }
        let mut by_column: Vec<_> = order.steps.iter().map(|step| (step.column, index(step.row))).collect();
        by_column.sort_unstable();
        let mut elimination = Self {
            stored,
            forward,
            backward,
            row_of: by_column.into_iter().map(|(_, row)| row).collect(),
            steps: Vec::new(),
            uppers: Vec::new(),
            multipliers: Vec::new(),
            targets: Vec::new(),
            filled: Vec::new(),
            carriers: Vec::new(),
            reductions: Vec::new(),
            is_odd: order.is_odd(),
        };
        let fill = order.fill.iter().map(|&(row, column)| elimination.entry(row, column));
        elimination.filled = fill.filter(|entry| *entry != SPARE).collect();
        for step in &steps {
            elimination.step(step);
        }
        elimination.substitute(system, order);
        elimination
    }

    /// Where the factors hold an entry of the matrix.
    pub(crate) fn entry(&self, row: usize, column: usize) -> u16 {
        *self.stored.get(&(row, column)).unwrap_or(&SPARE)
    }

    fn step(&mut self, step: &eliminate::Step) {
        self.steps.push(Step {
            pivot: self.entry(step.row, step.column),
            right: index(step.right.len()),
            below: index(step.below.len()),
            unit: step.unit,
        });
        let uppers = step.right.iter().map(|&column| self.entry(step.row, column));
        self.uppers.extend(uppers.collect::<Vec<_>>());
        for &row in &step.below {
            self.multipliers.push(self.entry(row, step.column));
            let targets = step.right.iter().map(|&column| self.entry(row, column));
            self.targets.extend(targets.collect::<Vec<_>>());
        }
    }

    fn substitute(&mut self, system: &System, order: &Order) {
        for (point, constant) in system.substituted().iter().zip(constants(system)) {
            let columns = |first: Option<usize>| {
                [0, 1, 2].map(|axis| first.map(|first| first + axis))
            };
            let frame: Vec<Option<usize>> =
                point.frame.iter().flat_map(|&first| columns(first)).collect();
            let nine = |value: &dyn Fn(Option<usize>) -> u16| {
                let mut columns = frame.iter();
                [(); 9].map(|()| value(columns.next().copied().flatten()))
            };
            let rows = point.rows(order);
            for &row in &rows {
                let at = |column: usize| {
                    let mut steps = point.steps(order);
                    let below = steps.find(|step| step.column == column);
                    let depends = below.is_some_and(|step| step.below.contains(&row));
                    if depends { self.entry(row, column) } else { ZERO }
                };
                let gradient = [0, 1, 2].map(|axis| at(point.column + axis));
                let sums = nine(&|column| column.map_or(SPARE, |column| self.entry(row, column)));
                self.reductions.push(Reduction { gradient, sums });
            }
            let body = position(system.bodies.iter().map(|body| &body.name), point.body);
            if self.carriers.last().is_none_or(|last| last.body != body) {
                self.carriers.push(Carrier {
                    body,
                    edges: index(self.stored.len() + 6 * self.carriers.len()),
                    frame: point.frame.map(|column| column.map_or(SPARE, index)),
                    points: Vec::new(),
                });
            }
            let substituted = Substituted {
                column: index(point.column),
                constant,
                reductions: index(rows.len()),
            };
            self.carriers.iter_mut().rev().take(1).for_each(|last| last.points.push(substituted));
        }
    }
}

/// Where the constants of each substituted point are among those of all carried points.
fn constants(system: &System) -> impl Iterator<Item = u16> {
    let substituted = system.substituted();
    let carried = system.bodies.iter().flat_map(|body| body.carried.iter().map(move |point| (&body.name, &point.name)));
    let carried: Vec<_> = carried.collect();
    let places: Vec<u16> = (substituted.iter())
        .map(|point| {
            let place = carried.iter().position(|known| *known == (point.body, point.point));
            place.map_or(u16::MAX, index)
        })
        .collect();
    places.into_iter()
}
