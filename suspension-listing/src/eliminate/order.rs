//! The entries of a matrix, and the order in which it is eliminated.

use std::collections::BTreeSet;

/// One entry of the Jacobian.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    pub row: usize,
    pub column: usize,
    /// Its values in the design position and in others of the motion; none where the design is not
    /// known.
    pub values: Vec<f64>,
    /// Whether it is 1 in every position: a pivot that cannot go bad.
    pub unit: bool,
    /// Whether it is a coordinate of a point in the equation that ties the point to a frame: such
    /// pivots come first, because their effect is known in closed form and need not be multiplied
    /// out (in the macro see `emit::carried`).
    pub carried: bool,
}

/// The steps of an elimination.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Order {
    pub steps: Vec<Step>,
    /// Entries that the matrix does not have but its factors do.
    pub fill: BTreeSet<(usize, usize)>,
    /// Multiplications and divisions of one factorisation, beside those of carried points, which are
    /// the same in every order.
    pub operations: usize,
    /// The longest chain of operations of which each needs the one before.
    pub chain: usize,
    /// The largest multiplier or inverse of a pivot in any of the positions; zero where nothing is
    /// known.
    pub growth: f64,
    /// In how many of the positions all pivots are large enough.
    pub served: usize,
}

/// Row and column of a pivot, and what the step does.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    pub row: usize,
    pub column: usize,
    /// Whether the pivot is 1 in every position.
    pub unit: bool,
    /// See [`Entry::carried`].
    pub carried: bool,
    /// Columns of the pivot row to the right of the pivot.
    pub right: Vec<usize>,
    /// Rows below the pivot that have an entry in its column.
    pub below: Vec<usize>,
}

/// A division takes as long as this many multiplications.
pub const DIVISION: usize = 4;
