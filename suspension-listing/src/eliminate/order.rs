//! The entries of a matrix, and the order in which it is eliminated.

use std::collections::BTreeSet;

/// One entry of the Jacobian.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    pub row: usize,
    pub column: usize,
    /// Its values in the design position and in others of the motion; empty if the design is not known.
    pub values: Vec<f64>,
    /// Whether it is 1 in every position: as a pivot it cannot become small.
    pub unit: bool,
    /// Whether it is a coordinate of a point in the equation that ties the point to a frame. Such pivots come first,
    /// because their effect is known in closed form and need not be multiplied out (in the macro see
    /// `emit::carried`).
    pub carried: bool,
}

/// The steps of an elimination.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EliminationOrder {
    pub steps: Vec<Step>,
    /// Entries that the factors have but the matrix does not.
    pub fill: BTreeSet<(usize, usize)>,
    /// The number of multiplications and divisions of one factorisation, without those for carried points, which are
    /// the same in every order.
    pub operations: usize,
    /// The length of the longest chain of operations that each need the one before.
    pub chain: usize,
    /// The largest multiplier or inverse of a pivot in any of the positions; zero if none is known.
    pub growth: f64,
    /// The number of positions in which all pivots are large enough.
    pub served: usize,
}

/// The row and column of a pivot, and the operations of the step.
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

/// The number of multiplications that take as long as a division.
pub const DIVISION: usize = 4;
