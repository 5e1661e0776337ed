//! A number that counts what is done to it.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};
use suspension_core::Scalar;

/// The counts of operations: multiplications, additions and subtractions, divisions.
pub(super) type Counts = [usize; 3];

/// A number known by how it was computed. The same operation on the same numbers gives the same number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Counting(Value);

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Value {
    /// By its bits.
    Constant(u64),
    /// By its number, what is given and what is computed.
    Unknown(usize),
    /// With the other sign: no operation of its own.
    Negative(usize),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Operator {
    Multiply,
    Add,
    Divide,
}

#[derive(Default)]
struct Session {
    all: Counts,
    different: Counts,
    known: HashMap<(Operator, Counting, Counting), usize>,
    numbers: usize,
}

thread_local! {
    static SESSION: RefCell<Session> = RefCell::default();
}

impl Session {
    fn next(&mut self) -> usize {
        self.numbers += 1;
        self.numbers
    }
}

impl Counting {
    /// A number that differs from all others.
    pub(super) fn unknown() -> Self {
        Self(Value::Unknown(SESSION.with_borrow_mut(Session::next)))
    }

    fn is(self, value: f64) -> bool {
        self.0 == Value::Constant(value.to_bits())
    }

    /// `neutral` as an operand is no operation for a compiler.
    fn computed(operator: Operator, [a, b]: [Self; 2], neutral: f64) -> Self {
        SESSION.with_borrow_mut(|session| session.all[operator as usize] += 1);
        if b.is(neutral) {
            return a;
        }
        if a.is(neutral) && operator != Operator::Divide {
            return b;
        }
        let [a, b] = match operator {
            // In one order: both are the same number.
            Operator::Multiply | Operator::Add if format!("{a:?}") > format!("{b:?}") => [b, a],
            _ => [a, b],
        };
        SESSION.with_borrow_mut(|session| {
            let kind = operator as usize;
            if let Some(number) = session.known.get(&(operator, a, b)) {
                return Self(Value::Unknown(*number));
            }
            session.different[kind] += 1;
            let number = session.next();
            session.known.insert((operator, a, b), number);
            Self(Value::Unknown(number))
        })
    }
}

/// Counts what an action does: every operation as it is written.
pub(super) fn count_all<R>(action: impl FnOnce() -> R) -> Counts {
    let before = SESSION.with_borrow(|session| session.all);
    action();
    SESSION.with_borrow(|session| subtract(session.all, before))
}

/// Counts what an action does: of equal operations one, as a compiler leaves it that sees them all.
pub(super) fn count_different<R>(action: impl FnOnce() -> R) -> Counts {
    SESSION.with_borrow_mut(|session| {
        session.known.clear();
        session.different = [0; 3];
    });
    action();
    SESSION.with_borrow(|session| session.different)
}

/// Each count less another.
pub(super) fn subtract(counts: Counts, others: Counts) -> Counts {
    std::array::from_fn(|kind| counts[kind] - others[kind])
}

impl Mul for Counting {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::computed(Operator::Multiply, [self, other], 1.0)
    }
}

impl Add for Counting {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::computed(Operator::Add, [self, other], -0.0)
    }
}

impl Sub for Counting {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Div for Counting {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self::computed(Operator::Divide, [self, other], 1.0)
    }
}

impl Neg for Counting {
    type Output = Self;
    fn neg(self) -> Self {
        Self(match self.0 {
            Value::Constant(bits) => Value::Constant((-f64::from_bits(bits)).to_bits()),
            Value::Unknown(number) => Value::Negative(number),
            Value::Negative(number) => Value::Unknown(number),
        })
    }
}

macro_rules! assignment {
    ($assign:ident, $assign_method:ident, $method:ident) => {
        impl $assign for Counting {
            fn $assign_method(&mut self, other: Self) {
                *self = self.$method(other);
            }
        }
    };
}

assignment!(AddAssign, add_assign, add);
assignment!(SubAssign, sub_assign, sub);
assignment!(MulAssign, mul_assign, mul);
assignment!(DivAssign, div_assign, div);

impl Default for Counting {
    fn default() -> Self {
        Self::zero()
    }
}

impl Zero for Counting {
    fn zero() -> Self {
        Self::constant(0.0)
    }
    fn is_zero(&self) -> bool {
        self.is(0.0)
    }
}

impl One for Counting {
    fn one() -> Self {
        Self::constant(1.0)
    }
}

impl Scalar for Counting {
    fn constant(value: f64) -> Self {
        Self(Value::Constant(value.to_bits()))
    }
    fn nearest_integer(self) -> Self {
        let large = Self::constant(1.5 / f64::EPSILON);
        (self + large) - large
    }
}
