//! A static order of elimination: which entry of the Jacobian is the pivot of each step, and
//! which entries fill in.
//!
//! The order is chosen by a greedy Markowitz search (H. M. Markowitz 1957; Duff, Erisman, Reid,
//! Direct Methods for Sparse Matrices, section 7.2): of the entries that are large enough beside
//! their column, the one that costs the fewest operations. Ties are broken in many ways and the
//! cheapest order found is kept.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// One entry of the Jacobian.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Entry {
    pub(crate) row: usize,
    pub(crate) column: usize,
    /// Its value in the design position, where that is known.
    pub(crate) value: Option<f64>,
    /// Whether it is 1 in every position: a pivot that cannot go bad.
    pub(crate) unit: bool,
}

/// The steps of an elimination.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Order {
    pub(crate) steps: Vec<Step>,
    /// Entries that the matrix does not have but its factors do.
    pub(crate) fill: BTreeSet<(usize, usize)>,
    /// Multiplications and divisions of one factorisation.
    pub(crate) operations: usize,
    /// The longest chain of operations of which each needs the one before.
    pub(crate) chain: usize,
}

/// Row and column of a pivot, and what the step does.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Step {
    pub(crate) row: usize,
    pub(crate) column: usize,
    /// Whether the pivot is 1 in every position.
    pub(crate) unit: bool,
    /// Columns of the pivot row to the right of the pivot.
    pub(crate) right: Vec<usize>,
    /// Rows below the pivot that have an entry in its column.
    pub(crate) below: Vec<usize>,
}

impl Order {
    /// Whether the order of rows and columns changes the sign of the product of the pivots
    /// against that of the determinant: by the cycles of the permutation from rows to columns.
    pub(crate) fn is_odd(&self) -> bool {
        let mut column_of: BTreeMap<usize, usize> = self
            .steps
            .iter()
            .map(|step| (step.row, step.column))
            .collect();
        let mut odd = false;
        while let Some((start, mut next)) = column_of.pop_first() {
            while next != start {
                odd = !odd;
                next = column_of.remove(&next).unwrap_or(start);
            }
        }
        odd
    }
}

/// A pivot must be at least this part of the largest entry of its column in the design position.
const THRESHOLD: f64 = 0.2;

/// How many ways of breaking ties are tried.
const ATTEMPTS: u64 = 400;

/// The best order found for an `n x n` matrix of full structural rank. Where the design position
/// is singular, it is chosen by structure alone.
pub(crate) fn order(n: usize, entries: &[Entry]) -> Order {
    best(n, entries).unwrap_or_else(|| {
        let structure = entries.iter().map(|entry| Entry {
            value: None,
            ..*entry
        });
        best(n, &structure.collect::<Vec<_>>()).unwrap_or_default()
    })
}

fn best(n: usize, entries: &[Entry]) -> Option<Order> {
    let start = Matrix::new(n, entries);
    let orders = (0..ATTEMPTS).filter_map(|seed| start.clone().eliminate(seed));
    orders.min_by_key(|order| (order.operations + order.chain / 2, order.operations))
}

/// What is known of an entry during elimination.
#[derive(Clone, Copy, Debug)]
struct Cell {
    value: Option<f64>,
    unit: bool,
    /// When it is ready, in operations from the start.
    ready: usize,
}

/// A partly eliminated matrix; `None` marks a zero.
#[derive(Clone)]
struct Matrix {
    cells: Vec<Vec<Option<Cell>>>,
    open_rows: Vec<usize>,
    open_columns: Vec<usize>,
}

impl Matrix {
    fn new(n: usize, entries: &[Entry]) -> Self {
        let mut cells = vec![vec![None; n]; n];
        for entry in entries {
            let Entry {
                row,
                column,
                value,
                unit,
            } = *entry;
            cells[row][column] = Some(Cell {
                value,
                unit,
                ready: 0,
            });
        }
        Self {
            cells,
            open_rows: (0..n).collect(),
            open_columns: (0..n).collect(),
        }
    }

    /// Eliminates to the end, breaking ties by `seed`.
    fn eliminate(mut self, seed: u64) -> Option<Order> {
        let mut order = Order::default();
        let mut random = Lcg(seed);
        while !self.open_rows.is_empty() {
            let (row, column) = self.pivot(&mut random)?;
            let step = self.step(row, column, &mut order);
            order.steps.push(step);
        }
        // Unknowns are found from the last step to the first: the term that waits longest comes
        // last.
        let found: Vec<usize> = order.steps.iter().map(|step| step.column).collect();
        for step in &mut order.steps {
            step.right
                .sort_by_key(|column| Reverse(found.iter().position(|c| c == column)));
        }
        Some(order)
    }

    /// The admissible entry with the least Markowitz count; one of them where there are several.
    fn pivot(&self, random: &mut Lcg) -> Option<(usize, usize)> {
        let mut best = None;
        for &column in &self.open_columns {
            let in_column = self
                .open_rows
                .iter()
                .filter(|&&row| self.cells[row][column].is_some());
            let rows: Vec<usize> = in_column.copied().collect();
            for &row in rows
                .iter()
                .filter(|&&row| self.admissible(row, column, &rows))
            {
                let in_row = self
                    .open_columns
                    .iter()
                    .filter(|&&c| self.cells[row][c].is_some());
                let count = (rows.len() - 1) * (in_row.count() - 1);
                let key = (count, random.next());
                if best.is_none_or(|(least, _)| key < least) {
                    best = Some((key, (row, column)));
                }
            }
        }
        best.map(|(_, pivot)| pivot)
    }

    /// Whether an entry is large enough beside its column: by its value, or where that is not
    /// known, because it is there.
    fn admissible(&self, row: usize, column: usize, rows: &[usize]) -> bool {
        let size = |row: usize| {
            self.cells[row][column]
                .and_then(|cell| cell.value)
                .map(f64::abs)
        };
        match size(row) {
            None => true,
            Some(pivot) => {
                let largest = rows.iter().filter_map(|&row| size(row)).fold(0.0, f64::max);
                pivot > 1e-6 && pivot >= THRESHOLD * largest
            }
        }
    }

    /// Eliminates the pivot's column from the other open rows.
    fn step(&mut self, row: usize, column: usize, order: &mut Order) -> Step {
        self.open_rows.retain(|&open| open != row);
        self.open_columns.retain(|&open| open != column);
        let present = |row: usize, column: usize| self.cells[row][column].is_some();
        let right: Vec<usize> = self
            .open_columns
            .iter()
            .copied()
            .filter(|&c| present(row, c))
            .collect();
        let below: Vec<usize> = self
            .open_rows
            .iter()
            .copied()
            .filter(|&r| present(r, column))
            .collect();
        let pivot = self.cells[row][column].unwrap_or(Cell {
            value: None,
            unit: true,
            ready: 0,
        });
        let inverse_ready = pivot.ready + if pivot.unit { 0 } else { DIVISION };
        order.operations += usize::from(!pivot.unit);
        order.chain = order.chain.max(inverse_ready);
        for &other in &below {
            let Some(entry) = self.cells[other][column] else {
                continue;
            };
            let multiplier_ready = inverse_ready.max(entry.ready) + usize::from(!pivot.unit);
            let multiplier = entry.value.zip(pivot.value).map(|(a, p)| a / p);
            order.operations += usize::from(!pivot.unit);
            for &c in &right {
                let Some(of_pivot) = self.cells[row][c] else {
                    continue;
                };
                let before = self.cells[other][c];
                let product = multiplier.zip(of_pivot.value).map(|(m, u)| m * u);
                let start = before.map_or(Some(0.0), |cell| cell.value);
                let ready = multiplier_ready.max(of_pivot.ready) + 1;
                let ready = before.map_or(ready, |cell| cell.ready.max(ready) + 1);
                let value = start.zip(product).map(|(a, b)| a - b);
                self.cells[other][c] = Some(Cell {
                    value,
                    unit: false,
                    ready,
                });
                if before.is_none() {
                    order.fill.insert((other, c));
                }
                order.operations += 1;
                order.chain = order.chain.max(ready);
            }
        }
        Step {
            row,
            column,
            unit: pivot.unit,
            right,
            below,
        }
    }
}

/// A division takes as long as this many multiplications.
pub(crate) const DIVISION: usize = 4;

/// A linear congruential generator (Knuth's MMIX constants): the same order at every expansion.
struct Lcg(u64);

impl Lcg {
    fn next(&mut self) -> u32 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as u32
    }
}
