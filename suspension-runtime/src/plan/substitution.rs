//! Solutions with the factors, as indices. A row stands in the place of the unknown that its step finds, so that a
//! solution is made in place.

use suspension_listing::eliminate::{EliminationOrder, Step};
use suspension_listing::system::{Substituted, System};

use super::ZERO;
use super::places::position;
use crate::size::LARGEST;
use crate::table::{SPARE, index};

/// Rows of a triangular factor and their terms, one row after the other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rows {
    pub(crate) rows: Vec<Row>,
    /// The place that each term multiplies.
    pub(crate) terms: Vec<u16>,
}

/// A row of a triangular factor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    /// The row of the right-hand side.
    pub(crate) row: u16,
    /// The unknown that the step of the row finds.
    pub(crate) place: u16,
    pub(crate) terms: u16,
}

/// A multiple of one place that is subtracted from another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    pub(crate) to: u16,
    pub(crate) from: u16,
    pub(crate) number: u16,
}

/// A solution with the transpose: terms, then pivots, then terms.
#[derive(Clone, Debug, Default)]
pub(crate) struct Solution {
    pub(crate) before: Vec<Term>,
    /// Places that are multiplied by a number.
    pub(crate) scaled: Vec<[u16; 2]>,
    pub(crate) behind: Vec<Term>,
}

/// A body with points that elimination takes out first.
#[derive(Clone, Debug)]
pub(crate) struct Carrier {
    pub(crate) body: u16,
    /// The place in the factors of the edges of its frame.
    pub(crate) edges: u16,
    /// The first unknowns of the frame's points; beyond all unknowns for a chassis point.
    pub(crate) frame: [u16; 3],
    pub(crate) points: Vec<CarriedPoint>,
}

/// A carried point that elimination takes out first.
#[derive(Clone, Debug)]
pub(crate) struct CarriedPoint {
    /// The first of its unknowns.
    pub(crate) column: u16,
    /// Its index among all carried points.
    pub(crate) constant: u16,
    /// The rows that depend on it.
    pub(crate) reductions: Vec<Reduction>,
}

/// A row that depends on a carried point, and instead depends on its frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reduction {
    /// The derivatives with respect to the point.
    pub(crate) gradient: [u16; 3],
    /// The derivatives with respect to the frame's points.
    pub(crate) sums: [u16; 9],
}

impl Rows {
    /// The terms that the rows before it subtract from each row.
    pub(super) fn forward(order: &EliminationOrder) -> Self {
        let mut rows = Self::default();
        for step in &order.steps {
            let left = left(order, step).filter(|_| !step.carried);
            rows.push(step, left.map(|from| from.column).collect());
        }
        rows
    }

    /// The terms that the unknowns found before subtract from each row.
    pub(super) fn backward(order: &EliminationOrder) -> Self {
        let mut rows = Self::default();
        for step in stored_steps(order).rev() {
            rows.push(step, step.right.clone());
        }
        rows
    }

    fn push(&mut self, step: &Step, terms: Vec<usize>) {
        self.rows.push(Row {
            row: index(step.row),
            place: index(step.column),
            terms: index(terms.len()),
        });
        self.terms.extend(terms.into_iter().map(index));
    }
}

impl Solution {
    /// The solution with the transpose.
    pub(super) fn transposed(
        order: &EliminationOrder,
        entry: impl Fn(usize, usize) -> u16,
    ) -> Self {
        let mut solution = Self::default();
        for step in stored_steps(order) {
            for &right in &step.right {
                let number = entry(step.row, right);
                solution.before.push(term(right, step.column, number));
            }
            let pivot = entry(step.row, step.column);
            solution.scaled.push([index(step.column), pivot]);
        }
        for step in order.steps.iter().rev() {
            for &below in &step.below {
                let (below, number) = (column_of(order, below), entry(below, step.column));
                solution.behind.push(term(step.column, below, number));
            }
        }
        solution
    }
}

fn term(to: usize, from: usize, number: u16) -> Term {
    Term {
        to: index(to),
        from: index(from),
        number,
    }
}

fn stored_steps(order: &EliminationOrder) -> impl DoubleEndedIterator<Item = &Step> {
    order.steps.iter().filter(|step| !step.carried)
}

/// The steps before one that reach its row.
pub(super) fn left<'a>(
    order: &'a EliminationOrder,
    step: &'a Step,
) -> impl Iterator<Item = &'a Step> {
    let steps = order.steps.iter();
    steps.filter(|from| from.below.contains(&step.row))
}

/// The unknown that the step of a row finds.
fn column_of(order: &EliminationOrder, row: usize) -> usize {
    let mut steps = order.steps.iter();
    steps
        .find(|step| step.row == row)
        .map_or(usize::MAX, |step| step.column)
}

/// For each unknown, the row of the step that finds it; for unknowns beyond those of the listing, their own row.
pub(super) fn row_of(order: &EliminationOrder) -> Vec<u16> {
    let steps = order.steps.iter();
    let mut rows: Vec<[usize; 2]> = steps.map(|step| [step.column, step.row]).collect();
    rows.sort_unstable();
    let beyond = rows.len()..LARGEST;
    let rows = rows.into_iter().map(|[_, row]| row);
    rows.chain(beyond).map(index).collect()
}

/// The points that elimination takes out first, by body.
pub(super) fn carriers(
    system: &System,
    order: &EliminationOrder,
    entry: impl Fn(usize, usize) -> u16,
    first_edge: usize,
) -> Vec<Carrier> {
    let mut carriers: Vec<Carrier> = Vec::new();
    for substituted in system.substituted() {
        let body = position(
            system.bodies.iter().map(|body| &body.name),
            substituted.body,
        );
        let point = carried_point(system, order, &substituted, &entry);
        match carriers.last_mut().filter(|last| last.body == body) {
            Some(last) => last.points.push(point),
            None => carriers.push(Carrier {
                body,
                edges: index(first_edge + 6 * carriers.len()),
                frame: substituted.frame.map(|column| column.map_or(SPARE, index)),
                points: vec![point],
            }),
        }
    }
    carriers
}

fn carried_point(
    system: &System,
    order: &EliminationOrder,
    point: &Substituted<'_>,
    entry: impl Fn(usize, usize) -> u16,
) -> CarriedPoint {
    let carried = system.bodies.iter().flat_map(|body| {
        let points = body.carried.iter();
        points.map(move |point| (&body.name, &point.name))
    });
    let mut places = carried.enumerate();
    let place = places.find(|(_, carried)| *carried == (point.body, point.point));
    let reductions = point.rows(order).into_iter().map(|row| {
        let gradient = [0, 1, 2].map(|axis| {
            let mut steps = point.steps(order);
            let step = steps.find(|step| step.column == point.column + axis);
            match step.filter(|step| step.below.contains(&row)) {
                Some(step) => entry(row, step.column),
                None => ZERO,
            }
        });
        let mut columns = point
            .frame
            .iter()
            .flat_map(|first| [0, 1, 2].map(|axis| first.map(|first| first + axis)));
        let sums = [(); 9].map(|()| match columns.next().flatten() {
            Some(column) => entry(row, column),
            None => SPARE,
        });
        Reduction { gradient, sums }
    });
    CarriedPoint {
        column: index(point.column),
        constant: place.map_or(SPARE, |(place, _)| index(place)),
        reductions: reductions.collect(),
    }
}
