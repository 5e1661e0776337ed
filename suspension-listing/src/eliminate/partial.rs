//! One attempt: the matrix as it is eliminated step by step.

use std::rc::Rc;

use super::acceptance::{Acceptance, Positions};
use super::order::{DIVISION, EliminationOrder, Entry, Step};
use super::preference::Preference;

/// The known data of an entry during elimination.
#[derive(Clone, Debug)]
struct Cell {
    /// Its value in each position; empty if the values are not known, or if those that it is made from are not.
    /// Attempts share the values that they have in common.
    values: Rc<[f64]>,
    unit: bool,
    carried: bool,
    /// The time when it is ready, in operations from the start.
    ready: usize,
    /// The positions that it loses as the pivot, see [`Acceptance::count_lost`]. It is stored because an attempt considers
    /// each entry in each step, and few of them change.
    lost: Option<usize>,
}

impl Cell {
    /// An entry of which it is not yet known whether it is large enough for a pivot.
    fn new(values: Rc<[f64]>, ready: usize) -> Self {
        Self {
            values,
            unit: false,
            carried: false,
            ready,
            lost: None,
        }
    }
}

/// A partly eliminated matrix.
#[derive(Clone)]
pub(super) struct Partial {
    /// By row and column; `None` marks a zero.
    cells: Vec<Vec<Option<Cell>>>,
    /// The columns in which each row has an entry, of those not eliminated yet.
    columns_of: Vec<Vec<usize>>,
    /// The rows that have an entry in each column, of those not eliminated yet.
    rows_of: Vec<Vec<usize>>,
    /// The smallest permitted pivot of each column, in each position.
    least: Vec<Vec<f64>>,
    acceptance: Acceptance,
    order: EliminationOrder,
}

impl Partial {
    pub(super) fn new(n: usize, entries: &[Entry], of: Positions) -> Self {
        let positions = entries.iter().map(|entry| entry.values.len()).max();
        let mut partial = Self {
            cells: vec![vec![None; n]; n],
            columns_of: vec![Vec::new(); n],
            rows_of: vec![Vec::new(); n],
            least: vec![Vec::new(); n],
            acceptance: Acceptance::new(of, positions.unwrap_or_default()),
            order: EliminationOrder::default(),
        };
        for entry in entries {
            let cell = Cell {
                unit: entry.unit,
                carried: entry.carried,
                ..Cell::new(entry.values.as_slice().into(), 0)
            };
            partial.put(entry.row, entry.column, cell);
        }
        for column in 0..n {
            partial.update_least(column);
        }
        partial
    }

    /// Sets an entry; returns whether it was zero.
    fn put(&mut self, row: usize, column: usize, cell: Cell) -> bool {
        let was_zero = self.cells[row][column].replace(cell).is_none();
        if was_zero {
            self.columns_of[row].push(column);
            self.rows_of[column].push(row);
        }
        was_zero
    }

    /// The matrix after elimination of the pivots that come first in every attempt.
    pub(super) fn eliminate_carried(mut self) -> Option<Self> {
        for (row, column) in self.carried() {
            self.eliminate_with(row, column)?;
        }
        Some(self)
    }

    /// Eliminates to the end; `None` if no entry is large enough for a pivot.
    pub(super) fn eliminate(mut self, attempt: u64) -> Option<EliminationOrder> {
        let mut preference = Preference::new(attempt);
        while self.order.steps.len() < self.cells.len() {
            let (row, column) = self.pivot(&mut preference)?;
            self.eliminate_with(row, column)?;
        }
        self.order.sort_substitution();
        self.order.served = self.acceptance.count();
        Some(self.order)
    }

    /// Eliminates with a pivot.
    fn eliminate_with(&mut self, row: usize, column: usize) -> Option<()> {
        let pivot = self.cells[row][column].clone()?;
        let narrowed = self.acceptance.accept(&pivot.values, &self.least[column]);
        self.step(row, column, pivot);
        if narrowed {
            (0..self.cells.len()).for_each(|column| self.update_least(column));
        }
        Some(())
    }

    /// The pivots that come first.
    fn carried(&self) -> Vec<(usize, usize)> {
        let rows = self.columns_of.iter().enumerate();
        let places =
            rows.flat_map(|(row, columns)| columns.iter().map(move |&column| (row, column)));
        let is_carried = |&(row, column): &(usize, usize)| {
            self.cells[row][column]
                .as_ref()
                .is_some_and(|cell| cell.carried)
        };
        places.filter(is_carried).collect()
    }

    /// The entry with the lowest rank among those that are large enough for their column in the most positions.
    fn pivot(&self, preference: &mut Preference) -> Option<(usize, usize)> {
        let mut best = None;
        for (column, rows) in self.rows_of.iter().enumerate() {
            for &row in rows {
                let Some(Cell {
                    lost: Some(lost),
                    ready,
                    ..
                }) = self.cells[row][column]
                else {
                    continue;
                };
                let markowitz = (rows.len() - 1) * (self.columns_of[row].len() - 1);
                let rank = (lost, preference.rank(markowitz, ready));
                if best.is_none_or(|(lowest, _)| rank < lowest) {
                    best = Some((rank, (row, column)));
                }
            }
        }
        best.map(|(_, pivot)| pivot)
    }

    /// Recomputes the smallest permitted pivot of the column, and which of its entries are large enough.
    fn update_least(&mut self, column: usize) {
        let rows = self.rows_of[column].iter();
        let values = rows.map(|&row| self.values(row, column));
        self.least[column] = self.acceptance.least(values);
        for &row in &self.rows_of[column] {
            if let Some(cell) = &mut self.cells[row][column] {
                cell.lost = self
                    .acceptance
                    .count_lost(&cell.values, &self.least[column]);
            }
        }
    }

    /// An entry's values.
    fn values(&self, row: usize, column: usize) -> &[f64] {
        self.cells[row][column]
            .as_ref()
            .map_or(&[], |cell| &cell.values)
    }

    /// Eliminates the pivot's column from the other rows that have an entry in it.
    fn step(&mut self, row: usize, column: usize, pivot: Cell) {
        let right = close(&mut self.columns_of, &mut self.rows_of, row, column);
        let below = close(&mut self.rows_of, &mut self.columns_of, column, row);
        let scaled = usize::from(!pivot.unit);
        let inverse_ready = pivot.ready + scaled * DIVISION;
        let divided = scaled * (below.len() + right.len());
        if !pivot.carried {
            self.order.operations += scaled + divided + below.len() * right.len();
        }
        self.order.chain = self.order.chain.max(inverse_ready);
        let known = self.acceptance.known(&pivot.values);
        self.order.grow(known.map(f64::recip));
        for &other in &below {
            let Some(entry) = &self.cells[other][column] else {
                continue;
            };
            let values = entry.values.iter().zip(&*pivot.values);
            let multiplier = Cell::new(
                values.map(|(value, pivot)| value / pivot).collect(),
                inverse_ready.max(entry.ready) + scaled,
            );
            self.order.chain = self.order.chain.max(multiplier.ready);
            self.order.grow(self.acceptance.known(&multiplier.values));
            self.subtract(&multiplier, row, other, &right);
        }
        for &column in &right {
            self.update_least(column);
        }
        self.order.steps.push(Step {
            row,
            column,
            unit: pivot.unit,
            carried: pivot.carried,
            right,
            below,
        });
    }

    /// Subtracts a multiple of the pivot's row, in the given columns, from another.
    fn subtract(&mut self, multiplier: &Cell, pivot: usize, other: usize, columns: &[usize]) {
        for &column in columns {
            let Some(of_pivot) = &self.cells[pivot][column] else {
                continue;
            };
            let factors = multiplier.values.iter().zip(&*of_pivot.values);
            let products = factors.map(|(m, u)| m * u);
            let product_ready = multiplier.ready.max(of_pivot.ready) + 1;
            let cell = match &self.cells[other][column] {
                Some(before) => {
                    let values = before.values.iter().zip(products);
                    Cell::new(
                        values.map(|(value, product)| value - product).collect(),
                        before.ready.max(product_ready) + 1,
                    )
                }
                None => Cell::new(products.map(|product| -product).collect(), product_ready),
            };
            self.order.chain = self.order.chain.max(cell.ready);
            if self.put(other, column, cell) {
                self.order.fill.insert((other, column));
            }
        }
    }
}

/// Takes a row out of both lists, or a column; returns the places of its entries other than the pivot.
fn close(
    own: &mut [Vec<usize>],
    across: &mut [Vec<usize>],
    line: usize,
    pivot: usize,
) -> Vec<usize> {
    let mut others = std::mem::take(&mut own[line]);
    others.retain(|&other| other != pivot);
    others.sort_unstable();
    for &other in &others {
        across[other].retain(|&open| open != line);
    }
    others
}
