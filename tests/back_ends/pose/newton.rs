//! Positions by Newton, rates and second rates by the implicit-function theorem, all derivatives taken from jets.

use suspension_double_double::DoubleDouble;

use super::jet::Jet;

/// The number of coordinates.
pub(crate) const SIZE: usize = 11;

/// Coordinates or residuals, over time.
pub(crate) type Coordinates = [Jet; SIZE];

type Column = [DoubleDouble; SIZE];

/// The largest last correction of the coordinates.
const CONVERGED: f64 = 1e-26;

/// Equations of coordinates over time.
pub(crate) trait Equations {
    /// The residual, inputs moving.
    fn moving(&self, x: &Coordinates) -> Coordinates;

    /// The residual, inputs held.
    fn held(&self, x: &Coordinates) -> Coordinates;
}

/// One order of all entries: 0 values, 1 rates, 2 second rates.
fn order(x: &Coordinates, order: usize) -> Column {
    x.map(|entry| entry.0[order])
}

fn with_order(x: &Coordinates, order: usize, column: &Column) -> Coordinates {
    let mut x = *x;
    for (entry, value) in x.iter_mut().zip(column) {
        entry.0[order] = *value;
    }
    x
}

/// The Jacobian by rows: the rates of the residual while one coordinate moves at rate 1.
fn jacobian(equations: &impl Equations, at: &Coordinates) -> [Column; SIZE] {
    let mut rows = [[0.0.into(); SIZE]; SIZE];
    for column in 0..SIZE {
        let mut x = *at;
        x[column].0[1] = 1.0.into();
        for (row, rate) in rows.iter_mut().zip(order(&equations.held(&x), 1)) {
            row[column] = rate;
        }
    }
    rows
}

/// The solution of linear equations, by elimination with row exchanges.
fn eliminate(mut rows: [Column; SIZE], mut right: Column) -> Column {
    for step in 0..SIZE {
        let size = |row: &usize| rows[*row][step].nearest().abs();
        let pivot = (step..SIZE)
            .max_by(|a, b| size(a).total_cmp(&size(b)))
            .expect("a row");
        assert!(size(&pivot) > 1e-6, "a singular position");
        rows.swap(step, pivot);
        right.swap(step, pivot);
        let above = rows[step];
        for row in step + 1..SIZE {
            let factor = rows[row][step] / above[step];
            for (entry, above) in rows[row].iter_mut().zip(above) {
                *entry -= factor * above;
            }
            let known = right[step];
            right[row] -= factor * known;
        }
    }
    substitute(&rows, right)
}

/// The solution of the equations that elimination leaves, from the last.
fn substitute(rows: &[Column; SIZE], mut right: Column) -> Column {
    for row in (0..SIZE).rev() {
        for column in row + 1..SIZE {
            let known = right[column];
            right[row] -= rows[row][column] * known;
        }
        right[row] /= rows[row][row];
    }
    right
}

fn negative(column: Column) -> Column {
    column.map(|entry| -entry)
}

/// The values near others, at rest.
fn position(equations: &impl Equations, near: &Coordinates) -> Coordinates {
    let mut x = order(near, 0).map(Jet::constant);
    for _ in 0..20 {
        let residual = order(&equations.held(&x), 0);
        let change = eliminate(jacobian(equations, &x), negative(residual));
        for (entry, change) in x.iter_mut().zip(change) {
            entry.0[0] += change;
        }
        if change.iter().all(|c| c.nearest().abs() < CONVERGED) {
            return x;
        }
    }
    panic!("no solution near by");
}

/// The solution near other coordinates.
pub(crate) fn solve(equations: &impl Equations, near: &Coordinates) -> Coordinates {
    let mut x = position(equations, near);
    let rows = jacobian(equations, &x);
    for derivative in [1, 2] {
        let known = order(&equations.moving(&x), derivative);
        x = with_order(&x, derivative, &eliminate(rows, negative(known)));
    }
    x
}
