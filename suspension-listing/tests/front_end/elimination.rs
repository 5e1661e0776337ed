//! Orders of elimination, replayed on numbers.

use std::time::Instant;

use suspension_listing::eliminate::{EliminationOrder, Entry, THRESHOLD, order};
use suspension_listing::sample;

use super::{catalogue_system, positions};

type Matrix = Vec<Vec<f64>>;

/// Numbers between -1 and 1 without a pattern, the same in every run.
struct Crooked(u64);

impl Crooked {
    fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Entries where `is_entry` says so, without values.
fn pattern(n: usize, is_entry: impl Fn(usize, usize) -> bool) -> Vec<Entry> {
    let places = (0..n).flat_map(|row| (0..n).map(move |column| (row, column)));
    let entries = places.filter(|(row, column)| is_entry(*row, *column));
    let entry = |(row, column)| Entry {
        row,
        column,
        values: Vec::new(),
        unit: false,
        carried: false,
    };
    entries.map(entry).collect()
}

/// A chain of bodies with three unknowns each: every equation is on a body and the one before,
/// every third also on the next.
fn ladder(bodies: usize) -> Vec<Entry> {
    let entries = pattern(3 * bodies, |row, column| {
        let (body, on) = (row / 3, column / 3);
        body == on || body == on + 1 || (body + 1 == on && row % 3 == 2)
    });
    with_values(&entries)
}

fn with_values(entries: &[Entry]) -> Vec<Entry> {
    let mut crooked = Crooked(1);
    let value = |entry: &Entry| Entry {
        values: vec![if entry.unit { 1.0 } else { crooked.number() }],
        ..entry.clone()
    };
    entries.iter().map(value).collect()
}

fn matrix(n: usize, entries: &[Entry]) -> Matrix {
    let mut matrix = vec![vec![0.0; n]; n];
    for entry in entries {
        matrix[entry.row][entry.column] = entry.values[0];
    }
    matrix
}

/// Factors in place as the steps say, multipliers below the pivots; `at_pivot` sees what is left
/// before each step, and the rows that are.
fn replay(
    mut a: Matrix,
    order: &EliminationOrder,
    mut at_pivot: impl FnMut(&Matrix, &[usize], usize),
) -> Matrix {
    let mut open: Vec<usize> = (0..a.len()).collect();
    for (index, step) in order.steps.iter().enumerate() {
        at_pivot(&a, &open, index);
        open.retain(|&row| row != step.row);
        for &row in &step.below {
            a[row][step.column] /= a[step.row][step.column];
            for &column in &step.right {
                a[row][column] -= a[row][step.column] * a[step.row][column];
            }
        }
    }
    assert!(open.is_empty(), "a step for each row");
    a
}

/// `L U` of factors, from the entries that the steps name and no others.
fn product(factors: &Matrix, order: &EliminationOrder) -> Matrix {
    let n = factors.len();
    let mut product = vec![vec![0.0; n]; n];
    for step in &order.steps {
        let lower = step
            .below
            .iter()
            .map(|&row| (row, factors[row][step.column]));
        for (row, multiplier) in lower.chain([(step.row, 1.0)]) {
            for &column in step.right.iter().chain([&step.column]) {
                product[row][column] += multiplier * factors[step.row][column];
            }
        }
    }
    product
}

fn largest_difference(a: &Matrix, b: &Matrix) -> f64 {
    let differences = a.iter().flatten().zip(b.iter().flatten());
    differences.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The systems to try, with values: the catalogue, and ladders.
fn systems() -> Vec<(usize, Vec<Entry>)> {
    let catalogue = ["attia2003", "five_link"].map(|name| {
        let system = catalogue_system(name);
        (
            system.size(),
            sample::entries(&system, &positions(&system)[..1]),
        )
    });
    let ladders = [1, 2, 7, 20].map(|bodies| (3 * bodies, ladder(bodies)));
    catalogue.into_iter().chain(ladders).collect()
}

#[test]
fn an_arrow_matrix_is_eliminated_without_fill() {
    const N: usize = 9;
    let arrow = pattern(N, |row, column| row == 0 || column == 0 || row == column);
    let order = order(N, &arrow);
    assert!(order.fill.is_empty());
    // An inverse, a multiplier, a product and a divided entry for each but the last pivot.
    assert_eq!(order.operations, 4 * (N - 1) + 1);
}

#[test]
fn a_dense_matrix_takes_the_textbook_number_of_operations() {
    const N: usize = 7;
    let order = order(N, &pattern(N, |_, _| true));
    // `L U`, and the rows of `U` divided by their pivots.
    assert_eq!(order.operations, N * (N * N - 1) / 3 + N + N * (N - 1) / 2);
    assert!(order.fill.is_empty());
}

#[test]
fn unit_pivots_take_no_operations() {
    let mut entries = pattern(4, |row, column| row <= column);
    entries
        .iter_mut()
        .for_each(|entry| entry.unit = entry.row == entry.column);
    let order = order(4, &entries);
    assert_eq!((order.operations, order.chain), (0, 0));
}

#[test]
fn each_pivot_is_above_the_threshold_of_its_column() {
    for (n, entries) in systems() {
        let order = order(n, &entries);
        let mut growth = 0.0_f64;
        replay(matrix(n, &entries), &order, |a, open, index| {
            let step = &order.steps[index];
            let pivot = a[step.row][step.column].abs();
            let column = open.iter().map(|&row| a[row][step.column].abs());
            let largest = column.fold(0.0, f64::max);
            assert!(pivot >= THRESHOLD * largest * (1.0 - 1e-9), "step {index}");
            let below = step
                .below
                .iter()
                .map(|&row| a[row][step.column].abs() / pivot);
            growth = below.fold(growth.max(pivot.recip()), f64::max);
        });
        assert!((growth / order.growth - 1.0).abs() < 1e-9);
    }
}

#[test]
fn the_product_of_the_factors_is_the_matrix() {
    for (n, entries) in systems() {
        let order = order(n, &entries);
        let a = matrix(n, &entries);
        let factors = replay(a.clone(), &order, |_, _, _| {});
        assert!(largest_difference(&product(&factors, &order), &a) < 1e-13);
        // In any other position too.
        let elsewhere = matrix(n, &with_values(&entries));
        let factors = replay(elsewhere.clone(), &order, |_, _, _| {});
        let difference = largest_difference(&product(&factors, &order), &elsewhere);
        let grown = factors
            .iter()
            .flatten()
            .fold(1.0, |m: f64, x| m.max(x.abs()));
        assert!(difference < 1e-14 * grown * grown, "{difference:e}");
    }
}

#[test]
fn each_matrix_entry_is_in_one_elimination_step() {
    for (n, entries) in systems() {
        let order = order(n, &entries);
        let mut places: Vec<(usize, usize)> = Vec::new();
        for step in &order.steps {
            places.push((step.row, step.column));
            places.extend(step.right.iter().map(|&column| (step.row, column)));
            places.extend(step.below.iter().map(|&row| (row, step.column)));
        }
        let mut expected: Vec<(usize, usize)> = entries
            .iter()
            .map(|entry| (entry.row, entry.column))
            .collect();
        expected.extend(&order.fill);
        places.sort_unstable();
        expected.sort_unstable();
        assert_eq!(places, expected);
    }
}

#[test]
fn the_elimination_order_is_deterministic() {
    for (n, entries) in systems() {
        assert_eq!(order(n, &entries), order(n, &entries));
    }
}

#[test]
fn at_a_singular_design_the_order_follows_the_structure() {
    let mut entries = pattern(3, |row, column| row != 0 || column != 2);
    let structure = order(3, &entries);
    entries
        .iter_mut()
        .for_each(|entry| entry.values = vec![0.5]);
    let degenerate = order(3, &entries);
    assert_eq!(degenerate, structure);
    assert_eq!(degenerate.steps.len(), 3);
}

/// A pivot with another sign elsewhere on the motion is zero on the way, however large it is in
/// the positions that are looked at.
#[test]
fn an_entry_that_changes_its_sign_is_no_pivot() {
    let entry = |row, column, values: [f64; 2]| Entry {
        row,
        column,
        values: values.to_vec(),
        unit: false,
        carried: false,
    };
    let entries = [
        entry(0, 0, [1.0, -1.0]),
        entry(0, 1, [0.5, 0.5]),
        entry(1, 0, [0.5, 0.5]),
        entry(1, 1, [0.1, 0.1]),
    ];
    let pivots = order(2, &entries).steps;
    assert!(pivots.iter().all(|step| step.row != step.column));
}

#[test]
fn elimination_costs_of_the_catalogue_stay_within_their_bounds() {
    let of = |name| {
        let system = catalogue_system(name);
        let order = order(
            system.size(),
            &sample::entries(&system, &positions(&system)),
        );
        println!(
            "{name}: {} operations, chain {}, growth {:.2}",
            order.operations, order.chain, order.growth
        );
        order
    };
    let [listed, rigid] = ["attia2003", "five_link"].map(of);
    assert!(listed.operations <= 141 && listed.chain <= 33 && listed.growth < 12.0);
    assert!(rigid.operations <= 83 && rigid.chain <= 32 && rigid.growth < 15.0);
}

/// Printed with `--nocapture`; the bound holds without optimisation on a slow computer.
#[test]
fn ordering_the_elimination_of_40_bodies_takes_less_than_5_s() {
    for bodies in [5, 10, 40] {
        let entries = ladder(bodies);
        let start = Instant::now();
        let order = order(3 * bodies, &entries);
        let took = start.elapsed();
        println!("{bodies} bodies: {took:?}, {} operations", order.operations);
        assert!(took.as_secs() < 5, "{bodies} bodies take {took:?}");
    }
}
