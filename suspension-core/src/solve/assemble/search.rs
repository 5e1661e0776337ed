//! The starting points of a search, and the choice of the nearest root.

use nalgebra::SVector;

use crate::arithmetic::magnitude::largest;
use crate::arithmetic::pivot::least_pivot;
use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::solve::assemble::assembly::Assembly;
use crate::solve::report::Report;

/// The number of starts around the guess.
pub(super) const AROUND: usize = 16;

/// The largest distance of a start from the guess in each coordinate, as a multiple of the root mean square of the
/// equations' errors there: about as far as the guess is from a root.
const SPREAD: f64 = 1.5;

/// The starts around the guess, which are the same at every call, whatever room there is behind its `unknowns`. `off`
/// is the residual at the guess.
pub(super) fn starts_around<T: Real, const N: usize>(
    guess: &SVector<T, N>,
    unknowns: usize,
    off: &SVector<T, N>,
) -> impl Iterator<Item = SVector<T, N>> {
    let spread = off.norm() * T::constant(SPREAD / libm::sqrt(unknowns as f64));
    let guess = *guess;
    let mut state = 1;
    let around = move || {
        let mut start = guess;
        for x in start.iter_mut().take(unknowns) {
            *x += spread * random(&mut state);
        }
        start
    };
    core::iter::repeat_with(around).take(AROUND)
}

/// A number between -1 and 1, from the upper half of a linear congruential generator (Knuth,
/// MMIX).
fn random<T: Real>(state: &mut u64) -> T {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    T::constant(f64::from((*state >> 32) as u32) / f64::from(1_u32 << 31) - 1.0)
}

/// A root, and its relation to the guess and to other roots.
pub(super) struct Found<T, const N: usize> {
    pub(super) root: SVector<T, N>,
    pub(super) assembly: Assembly<T>,
}

impl<T: Real, const N: usize> Found<T, N> {
    /// The root to which one start led.
    pub(super) fn new(root: SVector<T, N>, guess: &SVector<T, N>, report: Report<T>) -> Self {
        let assembly = Assembly {
            report,
            distance: (root - guess).norm(),
            next: None,
            starts: 1,
        };
        Self { root, assembly }
    }

    /// The nearer of two roots, with a note of the other.
    fn keep_nearer(mut self, mut other: Self, size: T) -> Self {
        if is_same(&self.root, &other.root, size) {
            self.assembly.starts += 1;
            return self;
        }
        if other.assembly.distance < self.assembly.distance {
            core::mem::swap(&mut self, &mut other);
        }
        let beside = other.assembly.distance;
        let next = self.assembly.next.map_or(beside, |next| next.min(beside));
        self.assembly.next = Some(next);
        self
    }
}

/// The nearer of the root found so far and that of one more attempt.
pub(super) fn nearer<T: Real, const N: usize>(
    so_far: Result<Found<T, N>, SolveError<T>>,
    attempt: Result<Found<T, N>, SolveError<T>>,
    size: T,
) -> Result<Found<T, N>, SolveError<T>> {
    match (so_far, attempt) {
        (Ok(so_far), Ok(found)) => Ok(so_far.keep_nearer(found, size)),
        (Err(_), Ok(found)) => Ok(found),
        (so_far, Err(_)) => so_far,
    }
}

/// Whether two results are the same root: near a singularity a root is known only to half the digits.
fn is_same<T: Real, const N: usize>(a: &SVector<T, N>, b: &SVector<T, N>, size: T) -> bool {
    let ([apart], [coordinates]) = ((a - b).data.0, a.data.0);
    largest(apart) <= least_pivot::<T>() * size.max(largest(coordinates))
}
