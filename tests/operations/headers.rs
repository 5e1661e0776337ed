//! The operation counts in the headers of generated modules.

use suspension_core::linkage::Factors as _;
use suspension_core::{Linkage, Values};

use super::number::{Counting, Counts, count_all};
use super::{attia_model, chassis, five_link_model, unknowns};

/// The counts of residual, Jacobian, curvature, factorisation and solution. The code has no branches, so that any numbers
/// will do.
fn counts<L, const N: usize>(model: &L) -> [Counts; 5]
where
    L: Linkage<N, Scalar = Counting>,
{
    let q = unknowns();
    let fixed = chassis();
    let drives = L::Drives::from_values(std::iter::repeat_with(Counting::unknown));
    let factors = model.factor(&q, &fixed);
    [
        count_all(|| model.residual(&q, &fixed, &drives)),
        count_all(|| model.jacobian(&q, &fixed)),
        count_all(|| model.curvature(&q, &fixed, &q, &fixed)),
        count_all(|| model.factor(&q, &fixed)),
        count_all(|| factors.solve(&q)),
    ]
}

/// The counts that the header of an expansion claims.
fn claimed(expansion: &str) -> [Counts; 5] {
    ["residual", "Jacobian", "curvature", "factor", "solve"].map(|method| {
        let row = format!("/// | {method} |");
        let mut rows = expansion.lines().filter_map(|line| line.strip_prefix(&row));
        let row = rows.next().expect("a row of the table");
        let numbers: Vec<usize> = row
            .split('|')
            .filter_map(|cell| cell.trim().parse().ok())
            .collect();
        numbers
            .try_into()
            .unwrap_or_else(|_| panic!("three numbers in {row}"))
    })
}

#[test]
fn the_header_of_attia2003_states_the_counted_operations() {
    let header = include_str!("../../suspension-macros/src/snapshots/attia2003.rs");
    assert_eq!(counts(&attia_model()), claimed(header));
}

#[test]
fn the_header_of_five_link_states_the_counted_operations() {
    let header = include_str!("../../suspension-macros/src/snapshots/five_link.rs");
    assert_eq!(counts(&five_link_model()), claimed(header));
}
