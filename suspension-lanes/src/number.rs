//! Vectors of numbers as one number, for generated code in lanes.
// Numbers are created from nothing, and with them the proof of their instructions: see `Vector::Proof`.
#![allow(unsafe_code)]

use std::marker::PhantomData;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use fearless_simd::{Simd, SimdFloat, f32x4, f32x8, f64x4, f64x8};
use num_traits::{One, Zero};
use suspension_core::Scalar;

/// Proof that the processor has certain instructions.
pub trait Token: Simd {
    /// The size of a vector register.
    const REGISTER_BITS: u32;

    /// The proof, assumed without a check.
    ///
    /// # Safety
    ///
    /// The processor must have the instructions.
    unsafe fn assumed() -> Self;
}

macro_rules! token {
    ($token:ident, $bits:literal) => {
        #[cfg(target_arch = "x86_64")]
        impl Token for fearless_simd::$token {
            const REGISTER_BITS: u32 = $bits;

            #[cfg_attr(not(debug_assertions), inline(always))]
            unsafe fn assumed() -> Self {
                // SAFETY: the caller guarantees it.
                unsafe { Self::assume_supported() }
            }
        }
    };
}

token!(Avx2, 256);
token!(Avx512, 512);

/// Lanes of `f32` or `f64`, or a single one.
pub(crate) trait Vector: Copy + Send + Sync + std::fmt::Debug + 'static {
    /// A lane.
    type Lane: Copy;

    /// The proof that the processor has the instructions for it. An [`Engine`](crate::engine::Engine) is made from
    /// such a proof, and no vector is made without an engine.
    type Proof: Token;

    /// A sum with a number this large has no digits left for a fraction.
    const LARGE: f64;

    fn splat(value: f64) -> Self;
    fn lane(&self, index: usize) -> Self::Lane;
    fn set_lane(&mut self, index: usize, value: Self::Lane);
    fn add(self, other: Self) -> Self;
    fn subtract(self, other: Self) -> Self;
    fn multiply(self, other: Self) -> Self;
    fn divide(self, other: Self) -> Self;
    fn negative(self) -> Self;
    /// `self + a b`, rounded once if there are instructions for it.
    fn plus_product(self, a: Self, b: Self) -> Self;
}

macro_rules! vector {
    ($vector:ident, $lane:ty) => {
        impl<S: Token> Vector for $vector<S> {
            type Lane = $lane;
            type Proof = S;
            const LARGE: f64 = 1.5 / <$lane>::EPSILON as f64;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn splat(value: f64) -> Self {
                // SAFETY: see `Vector::Proof`.
                let proof = unsafe { S::assumed() };
                fearless_simd::SimdBase::splat(proof, value as $lane)
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn lane(&self, index: usize) -> $lane {
                self[index]
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn set_lane(&mut self, index: usize, value: $lane) {
                self[index] = value;
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn add(self, other: Self) -> Self {
                self + other
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn subtract(self, other: Self) -> Self {
                self - other
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn multiply(self, other: Self) -> Self {
                self * other
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn divide(self, other: Self) -> Self {
                self / other
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn negative(self) -> Self {
                -self
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn plus_product(self, a: Self, b: Self) -> Self {
                SimdFloat::mul_add(a, b, self)
            }
        }
    };
}

vector!(f32x4, f32);
vector!(f32x8, f32);
vector!(f64x4, f64);
vector!(f64x8, f64);

/// One number that rounds `a + b c` once: fast only in code for processors that have the instruction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fused<S, T>(T, PhantomData<S>);

macro_rules! fused {
    ($lane:ty) => {
        impl<S: Token> Vector for Fused<S, $lane> {
            type Lane = $lane;
            type Proof = S;
            const LARGE: f64 = 1.5 / <$lane>::EPSILON as f64;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn splat(value: f64) -> Self {
                Self(value as $lane, PhantomData)
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn lane(&self, _: usize) -> $lane {
                self.0
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn set_lane(&mut self, _: usize, value: $lane) {
                self.0 = value;
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0, PhantomData)
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn subtract(self, other: Self) -> Self {
                Self(self.0 - other.0, PhantomData)
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn multiply(self, other: Self) -> Self {
                Self(self.0 * other.0, PhantomData)
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn divide(self, other: Self) -> Self {
                Self(self.0 / other.0, PhantomData)
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn negative(self) -> Self {
                Self(-self.0, PhantomData)
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn plus_product(self, a: Self, b: Self) -> Self {
                Self(a.0.mul_add(b.0, self.0), PhantomData)
            }
        }
    };
}

fused!(f32);
fused!(f64);

/// A vector with the operators of a number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number<V>(pub(crate) V);

macro_rules! operator {
    ($operator:ident, $method:ident, $of_vector:ident, $assign:ident, $assign_method:ident) => {
        impl<V: Vector> $operator for Number<V> {
            type Output = Self;
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$of_vector(other.0))
            }
        }
        impl<V: Vector> $assign for Number<V> {
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $assign_method(&mut self, other: Self) {
                self.0 = self.0.$of_vector(other.0);
            }
        }
    };
}

operator!(Add, add, add, AddAssign, add_assign);
operator!(Sub, sub, subtract, SubAssign, sub_assign);
operator!(Mul, mul, multiply, MulAssign, mul_assign);
operator!(Div, div, divide, DivAssign, div_assign);

impl<V: Vector> Neg for Number<V> {
    type Output = Self;
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(self) -> Self {
        Self(self.0.negative())
    }
}

impl<V: Vector> PartialEq for Number<V> {
    /// Always false: lanes are compared one by one.
    fn eq(&self, _: &Self) -> bool {
        false
    }
}

impl<V: Vector> Default for Number<V> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn default() -> Self {
        Self(V::splat(0.0))
    }
}

impl<V: Vector> Zero for Number<V> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn zero() -> Self {
        Self(V::splat(0.0))
    }
    fn is_zero(&self) -> bool {
        false
    }
}

impl<V: Vector> One for Number<V> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn one() -> Self {
        Self(V::splat(1.0))
    }
}

impl<V: Vector> Scalar for Number<V> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(value: f64) -> Self {
        Self(V::splat(value))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn nearest_integer(self) -> Self {
        let large = Self(V::splat(V::LARGE));
        (self + large) - large
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plus_product(self, a: Self, b: Self) -> Self {
        Self(self.0.plus_product(a.0, b.0))
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn minus_product(self, a: Self, b: Self) -> Self {
        Self(self.0.plus_product(a.0.negative(), b.0))
    }
}
