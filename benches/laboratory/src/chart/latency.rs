//! The time of single steps, including the worst, with and without other load.

use std::hint::black_box;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Instant;

use hdrhistogram::Histogram;

use super::course::Course;
use super::method::{Method, Outputs};

/// The times of many steps.
#[derive(Clone, Debug)]
pub struct Latencies {
    /// The method.
    pub method: String,
    /// The number of threads in addition to the one that steps.
    pub load: usize,
    /// Nanoseconds, to three digits.
    pub times: Histogram<u64>,
}

/// Parts of all steps that are shown.
pub const PARTS: [(&str, f64); 5] = [
    ("median", 0.5),
    ("99 %", 0.99),
    ("99.9 %", 0.999),
    ("99.99 %", 0.9999),
    ("worst", 1.0),
];

fn histogram() -> Histogram<u64> {
    const MINUTE: u64 = 60_000_000_000;
    Histogram::new_with_max(MINUTE, 3).expect("three digits up to a minute can be stored")
}

/// The median reading of the clock with nothing between start and end, ns.
pub fn clock() -> u64 {
    let mut times = histogram();
    for _ in 0..100_000 {
        record(&mut times, Instant::now());
    }
    times.value_at_quantile(0.5)
}

fn record(times: &mut Histogram<u64>, began: Instant) {
    let nanoseconds = u64::try_from(began.elapsed().as_nanos()).unwrap_or(u64::MAX);
    times.saturating_record(nanoseconds);
}

/// Moves through the course repeatedly, up to `count` steps, and times each step to position, velocity and acceleration.
/// `None` if a step fails.
pub fn latencies<M: Method<D, N>, D, const N: usize>(
    method: &M,
    rest: &M::State,
    course: &Course<D>,
    stride: usize,
    count: u64,
    interrupted: &AtomicBool,
) -> Option<Histogram<u64>> {
    let every: Vec<_> = course.drives.iter().step_by(stride).collect();
    let between = every.windows(2);
    let inputs: Vec<M::Input> = between.map(|ends| method.input(ends[0], ends[1])).collect();
    let dt = course.times.get(stride)? - course.times.first()?;
    let first = every.first()?;
    let start = method.step(
        Outputs::Acceleration,
        &method.input(first, first),
        0.0,
        rest,
    )?;
    let mut times = histogram();
    while times.len() < count && !interrupted.load(Ordering::Relaxed) {
        let mut state = start;
        let left = usize::try_from(count - times.len()).unwrap_or(usize::MAX);
        for input in inputs.iter().take(left) {
            let began = Instant::now();
            let next = method.step(Outputs::Acceleration, black_box(input), dt, &state);
            let next = black_box(next);
            record(&mut times, began);
            state = next?;
        }
    }
    Some(times)
}

/// Runs `work` while as many threads as the machine has cores compute and copy memory; `work` receives their number.
pub fn under_load<R>(work: impl FnOnce(usize) -> R) -> R {
    let cores = thread::available_parallelism().map_or(1, Into::into);
    let done = AtomicBool::new(false);
    thread::scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| keep_busy(&done));
        }
        let result = work(cores);
        done.store(true, Ordering::Relaxed);
        result
    })
}

fn keep_busy(done: &AtomicBool) {
    /// More than the caches near a core hold: 8 MB.
    const NUMBERS: usize = 1 << 20;
    let mut from = vec![1.0_f64; NUMBERS];
    let mut to = from.clone();
    while !done.load(Ordering::Relaxed) {
        to.copy_from_slice(&from);
        for number in &mut to {
            *number = number.mul_add(1.000_001, 1e-9);
        }
        std::mem::swap(&mut from, black_box(&mut to));
    }
}
