//! Random numbers, and many cases of them on all processors.

use std::ops::{AddAssign, Range};

use fastrand::Rng;

/// A number between the ends of a range.
pub(crate) fn uniform(rng: &mut Rng, range: Range<f64>) -> f64 {
    range.start + (range.end - range.start) * rng.f64()
}

/// Ten to a power between the ends of a range.
pub(crate) fn power_of_ten(rng: &mut Rng, range: Range<f64>) -> f64 {
    10.0_f64.powf(uniform(rng, range))
}

pub(crate) fn sign(rng: &mut Rng) -> f64 {
    if rng.bool() { 1.0 } else { -1.0 }
}

/// The outcomes of many cases.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Counts {
    pub(crate) cases: usize,
    /// Proved, and there is such a root.
    pub(crate) proved: usize,
    /// Not proved, though there is a root.
    pub(crate) unproved: usize,
    /// Not proved, and there is no root.
    pub(crate) refused: usize,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.cases += other.cases;
        self.proved += other.proved;
        self.unproved += other.unproved;
        self.refused += other.refused;
    }
}

/// The sum over as many cases, each with a generator of its own number as the seed.
pub(crate) fn sum_of_cases<C: Default + AddAssign + Send>(
    cases: u64,
    case: impl Fn(u64, &mut Rng) -> C + Sync,
) -> C {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let of_thread = |first: usize| {
        let mut sum = C::default();
        for seed in (first as u64..cases).step_by(threads) {
            sum += case(seed, &mut Rng::with_seed(seed));
        }
        sum
    };
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads)
            .map(|first| {
                scope.spawn({
                    let of_thread = &of_thread;
                    move || of_thread(first)
                })
            })
            .collect();
        let mut sum = C::default();
        for worker in workers {
            sum += worker.join().expect("no case fails");
        }
        sum
    })
}
