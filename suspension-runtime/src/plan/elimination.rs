//! The order of elimination as indices into the numbers that the factors store.
//!
//! They are stored in the order in which a solution reads them: for each row from the first step to the
//! last, the multipliers left of its pivot; then, from the last step to the first, the pivot (later its
//! inverse) and what is right of it; then the edges of frames that carry points. Rows of carried points,
//! which are eliminated first, are not stored: frame and constants stand for them.

use std::collections::BTreeMap;

use suspension_listing::eliminate::{self, EliminationOrder};
use suspension_listing::system::System;

use super::substitution;
use super::substitution::{Carrier, Rows, Solution};
use crate::table::{SPARE, index};

/// The indices over which factorisation and solutions walk.
#[derive(Clone, Debug)]
pub(crate) struct Elimination {
    stored: BTreeMap<(usize, usize), u16>,
    /// Numbers that start at zero: fill-in.
    pub(crate) filled: Vec<u16>,
    pub(crate) carriers: Vec<Carrier>,
    pub(crate) steps: Vec<Step>,
    /// Equation and unknown of each pivot, those of carried points first.
    pub(crate) pivots: Vec<[usize; 2]>,
    /// For each step, the numbers right of the pivot.
    pub(crate) uppers: Vec<u16>,
    /// For each step, for each row below it, the multiplier.
    pub(crate) multipliers: Vec<u16>,
    /// For each of those, for each number right of the pivot, the number from which the product is subtracted.
    pub(crate) targets: Vec<u16>,
    /// Whether the order changes the sign of the determinant.
    pub(crate) is_odd: bool,
    /// For each unknown the row of the step that finds it.
    pub(crate) row_of: Vec<u16>,
    pub(crate) forward: Rows,
    /// Each row begins with the inverse of its pivot.
    pub(crate) backward: Rows,
    pub(crate) transposed: Solution,
}

/// A pivot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub(crate) pivot: u16,
    /// The number of entries right of it.
    pub(crate) right: u16,
    /// The number of rows below it.
    pub(crate) below: u16,
    /// Whether it is 1 in every position.
    pub(crate) unit: bool,
}

impl Elimination {
    pub(crate) fn new(system: &System, order: &EliminationOrder) -> Self {
        let steps = || order.steps.iter().filter(|step| !step.carried);
        let (forward, backward) = (Rows::forward(order), Rows::backward(order));
        let mut elimination = Self {
            stored: stored(order),
            filled: Vec::new(),
            carriers: Vec::new(),
            steps: Vec::new(),
            pivots: order
                .steps
                .iter()
                .map(|step| [step.row, step.column])
                .collect(),
            uppers: Vec::new(),
            multipliers: Vec::new(),
            targets: Vec::new(),
            is_odd: order.is_odd(),
            row_of: substitution::row_of(order),
            forward,
            backward,
            transposed: Solution::default(),
        };
        let entry = |row, column| elimination.entry(row, Some(column));
        let fill = order.fill.iter().map(|&(row, column)| entry(row, column));
        let filled = fill.filter(|number| *number != SPARE).collect();
        let carriers = substitution::carriers(system, order, entry, elimination.stored.len());
        let transposed = Solution::transposed(order, entry);
        elimination.filled = filled;
        elimination.carriers = carriers;
        elimination.transposed = transposed;
        steps().for_each(|step| elimination.step(step));
        elimination
    }

    /// The index in the factors of an entry of the matrix.
    pub(crate) fn entry(&self, row: usize, column: Option<usize>) -> u16 {
        let number = column.and_then(|column| self.stored.get(&(row, column)));
        *number.unwrap_or(&SPARE)
    }

    /// The count of numbers that the factors have.
    pub(crate) fn numbers(&self) -> usize {
        self.stored.len() + 6 * self.carriers.len()
    }

    fn step(&mut self, step: &eliminate::Step) {
        let numbers = |row: usize| -> Vec<u16> {
            let right = step.right.iter();
            right.map(|&column| self.entry(row, Some(column))).collect()
        };
        let uppers = numbers(step.row);
        let targets: Vec<u16> = step.below.iter().flat_map(|&row| numbers(row)).collect();
        let below = step.below.iter();
        let multipliers: Vec<u16> = below
            .map(|&row| self.entry(row, Some(step.column)))
            .collect();
        self.steps.push(Step {
            pivot: self.entry(step.row, Some(step.column)),
            right: index(uppers.len()),
            below: index(multipliers.len()),
            unit: step.unit,
        });
        self.uppers.extend(uppers);
        self.multipliers.extend(multipliers);
        self.targets.extend(targets);
    }
}

/// The entries that the factors store, numbered.
fn stored(order: &EliminationOrder) -> BTreeMap<(usize, usize), u16> {
    let steps = || order.steps.iter().filter(|step| !step.carried);
    let lower = steps().flat_map(|step| {
        let left = substitution::left(order, step);
        left.map(|from| (step.row, from.column))
    });
    let upper = steps().rev().flat_map(|step| {
        let columns = [step.column].into_iter().chain(step.right.iter().copied());
        columns.map(|column| (step.row, column))
    });
    let numbered = lower.chain(upper).enumerate();
    numbered
        .map(|(number, entry)| (entry, index(number)))
        .collect()
}
