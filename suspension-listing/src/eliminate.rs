//! A static order of elimination: which entry of the Jacobian is the pivot of each step, and
//! which entries fill in.
//!
//! The order is chosen by a greedy Markowitz search (H. M. Markowitz 1957; Duff, Erisman, Reid,
//! Direct Methods for Sparse Matrices, section 7.2): of the entries that are large enough beside
//! their column, and of one sign along the motion, the one that costs the fewest operations. The search is repeated with ties
//! broken in many ways, and the cheapest order found is kept.

mod acceptance;
mod order;
mod partial;
mod preference;

use std::cmp::Reverse;
use std::collections::BTreeMap;

use acceptance::Positions;
pub use acceptance::THRESHOLD;
pub use order::{DIVISION, EliminationOrder, Entry, Step};
use partial::Partial;

/// The best order found for an `n x n` matrix of full structural rank. If none has large pivots in all positions, it
/// is chosen by the design position; if that is singular, by structure alone.
pub fn order(n: usize, entries: &[Entry]) -> EliminationOrder {
    let first = |positions: usize| {
        let entries = entries.iter().map(|entry| Entry {
            values: entry.values.iter().copied().take(positions).collect(),
            ..entry.clone()
        });
        let entries: Vec<Entry> = entries.collect();
        let start = Partial::new(n, &entries, Positions::OfMotion);
        cheapest(start, attempts(n))
    };
    [usize::MAX, 1, 0]
        .into_iter()
        .find_map(first)
        .unwrap_or_default()
}

/// The order with large pivots in the largest number of designs. The entries have their values in these designs.
pub(crate) fn order_for_most(n: usize, entries: &[Entry]) -> EliminationOrder {
    // Ties are rarer here, so more attempts find nothing better.
    const ATTEMPTS: u64 = 8;
    let start = Partial::new(n, entries, Positions::OfDesigns);
    cheapest(start, ATTEMPTS).unwrap_or_default()
}

/// The cheapest of the orders that serve the most positions, from many attempts; `None` if no attempt finds a pivot
/// for each step.
fn cheapest(start: Partial, attempts: u64) -> Option<EliminationOrder> {
    let start = start.eliminate_carried()?;
    let orders = (0..attempts).filter_map(|attempt| start.clone().eliminate(attempt));
    orders.min_by(|a, b| {
        let served = b.served.cmp(&a.served);
        served.then(a.cost().total_cmp(&b.cost()))
    })
}

/// The number of times that the search is repeated. One attempt takes about the square of the size, and a compiler
/// should not be held up: 200 attempts at 15 unknowns, or 8 at 120, take hundredths of a second without optimisation,
/// which is how macros run.
fn attempts(n: usize) -> u64 {
    (45_000 / (n * n).max(1)).clamp(8, 200) as u64
}

impl EliminationOrder {
    /// Whether the order of rows and columns makes the sign of the product of the pivots opposite to that of the
    /// determinant, found from the cycles of the permutation from rows to columns.
    pub fn is_odd(&self) -> bool {
        let steps = self.steps.iter();
        let mut column_of: BTreeMap<usize, usize> =
            steps.map(|step| (step.row, step.column)).collect();
        let mut odd = false;
        while let Some((start, mut next)) = column_of.pop_first() {
            while next != start {
                odd = !odd;
                next = column_of.remove(&next).unwrap_or(start);
            }
        }
        odd
    }

    /// The number of stored entries of the factors, each a multiplication of a solution; for carried points only the
    /// multipliers.
    pub fn non_zeros(&self) -> usize {
        let of_step = |step: &Step| {
            let right = if step.carried { 0 } else { step.right.len() };
            step.below.len() + right + usize::from(!step.unit)
        };
        self.steps.iter().map(of_step).sum()
    }

    /// The cost of a step, which is one factorisation and three solutions: its operations, plus those of the longest
    /// chain, which cannot overlap. Growth, to which the positions around the design contribute, decides between
    /// orders of nearly the same cost.
    fn cost(&self) -> f64 {
        let operations = self.operations + 3 * self.non_zeros();
        let chain = self.chain + 3 * self.substitution_chain();
        (operations + chain) as f64 + self.growth
    }

    /// The longest chain of one solution.
    pub fn substitution_chain(&self) -> usize {
        let n = self.steps.len();
        let (mut row_ready, mut unknown_ready) = (vec![0; n], vec![0; n]);
        for step in &self.steps {
            for &row in &step.below {
                row_ready[row] = row_ready[row].max(row_ready[step.row]) + 1;
            }
        }
        for step in self.steps.iter().rev() {
            let divided = row_ready[step.row] + usize::from(!step.unit);
            let ready = |ready: usize, &column: &usize| ready.max(unknown_ready[column]) + 1;
            unknown_ready[step.column] = step.right.iter().fold(divided, ready);
        }
        unknown_ready.into_iter().max().unwrap_or_default()
    }

    fn grow(&mut self, by: impl Iterator<Item = f64>) {
        self.growth = by.fold(self.growth, |growth, by| growth.max(by.abs()));
    }

    /// Orders the terms of the back-substitution. Unknowns are found from the last step to the first: the term that
    /// waits longest comes last.
    fn sort_substitution(&mut self) {
        let mut step_of = vec![0; self.steps.len()];
        for (index, step) in self.steps.iter().enumerate() {
            step_of[step.column] = index;
        }
        for step in &mut self.steps {
            step.right.sort_by_key(|&column| Reverse(step_of[column]));
        }
    }
}
