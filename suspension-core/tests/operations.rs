//! The operation counts in the headers of generated modules, counted by a number that counts.

use std::cell::Cell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use nalgebra::{SVector, Vector3};
use num_traits::{One, Zero};
use suspension_core::linkage::Factors as _;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{Linkage, Scalar, Values};

/// What has been done to numbers: multiplications, additions and subtractions, divisions.
type Counts = [usize; 3];

thread_local! {
    static DONE: Cell<Counts> = const { Cell::new([0; 3]) };
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Counting(f64);

fn note(kind: usize) {
    let mut done = DONE.get();
    done[kind] += 1;
    DONE.set(done);
}

macro_rules! counted {
    ($operator:ident, $method:ident, $assign:ident, $assign_method:ident, $kind:literal) => {
        impl $operator for Counting {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                note($kind);
                Self(self.0.$method(other.0))
            }
        }
        impl $assign for Counting {
            fn $assign_method(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    };
}

counted!(Mul, mul, MulAssign, mul_assign, 0);
counted!(Add, add, AddAssign, add_assign, 1);
counted!(Sub, sub, SubAssign, sub_assign, 1);
counted!(Div, div, DivAssign, div_assign, 2);

impl Neg for Counting {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Zero for Counting {
    fn zero() -> Self {
        Self(0.0)
    }
    fn is_zero(&self) -> bool {
        self.0 == 0.0
    }
}

impl One for Counting {
    fn one() -> Self {
        Self(1.0)
    }
}

impl Scalar for Counting {
    fn constant(value: f64) -> Self {
        Self(value)
    }
    fn nearest_integer(self) -> Self {
        Self(self.0.round())
    }
}

fn count<R>(action: impl FnOnce() -> R) -> Counts {
    DONE.set([0; 3]);
    action();
    DONE.get()
}

/// The counts of residual, Jacobian, curvature, factorisation and solution. The code has no branches, so that any numbers
/// will do.
fn counts<L, const N: usize>(model: &L) -> [Counts; 5]
where
    L: Linkage<N, Scalar = Counting>,
{
    let q = SVector::<Counting, N>::repeat(Counting(0.5));
    let fixed = L::Fixed::from_values(std::iter::repeat_with(|| Vector3::repeat(Counting(0.25))));
    let drives = L::Drives::from_values(std::iter::repeat(Counting(0.1)));
    let factors = model.factor(&q, &fixed);
    [
        count(|| model.residual(&q, &fixed, &drives)),
        count(|| model.jacobian(&q, &fixed)),
        count(|| model.curvature(&q, &fixed, &q, &fixed)),
        count(|| model.factor(&q, &fixed)),
        count(|| factors.solve(&q)),
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

/// A model whose constants are all zero: to count takes no geometry, and to build one takes a
/// number that can be compared.
macro_rules! blank {
    ($model:ty) => {{
        // SAFETY: the model consists of `Counting`s, of which zero bytes are the number zero.
        #[allow(unsafe_code)]
        unsafe {
            std::mem::zeroed::<$model>()
        }
    }};
}

#[test]
fn attia2003() {
    let model = blank!(attia2003::Model<Counting>);
    let header = include_str!("../../suspension-macros/src/snapshots/attia2003.rs");
    assert_eq!(counts(&model), claimed(header));
}

#[test]
fn five_link() {
    let model = blank!(five_link::Model<Counting>);
    let header = include_str!("../../suspension-macros/src/snapshots/five_link.rs");
    assert_eq!(counts(&model), claimed(header));
}
