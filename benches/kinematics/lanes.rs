//! Steps in lanes: each lane a tenth of a second ahead of the one before it.

use std::hint::black_box;

use criterion::Criterion;
use suspension_core::{Build, Listing};
use suspension_lanes::{Instructions, Lane, Lanes};

use super::case::{Case, OUTPUTS, STEP};

/// The number of steps after which the eighth lane is at 1.8 s; then the motion restarts.
const STEPS: u32 = 2200;

fn time(lane: usize, step: u32) -> f64 {
    0.1 * lane as f64 + f64::from(step) * STEP
}

macro_rules! follow {
    ($criterion:ident, $case:ident, $group:literal, $lanes:literal, $instructions:expr) => {
        let mut group = $criterion.benchmark_group($group);
        let all: Vec<[_; $lanes]> = (1..=STEPS)
            .map(|step| std::array::from_fn(|lane| $case.inputs(time(lane, step)).drives))
            .collect();
        let starts: [_; $lanes] = std::array::from_fn(|lane| $case.motion(time(lane, 0)));
        for (name, outputs) in OUTPUTS {
            group.bench_function(format!("{name}/{}", $case.name), |bencher| {
                let from_start = || {
                    let models = [$case.model; $lanes];
                    Lanes::<G, T, 15, $lanes>::with($instructions, models, &starts)
                };
                let mut lanes = from_start();
                let mut ahead = all.iter();
                bencher.iter(|| {
                    let drives = ahead.next().unwrap_or_else(|| {
                        lanes = from_start();
                        ahead = all[1..].iter();
                        &all[0]
                    });
                    let results = lanes.step(outputs, black_box(drives), T::constant(STEP));
                    assert!(results.iter().all(Result::is_ok), "a regular motion");
                    results
                });
            });
        }
        drop(group);
    };
}

pub(crate) fn bench<G: Listing<15> + 'static, T: Lane>(criterion: &mut Criterion, case: &Case<G, T>)
where
    G::Model<T>: Build<15>,
{
    follow!(criterion, case, "lanes1", 1, Instructions::best());
    follow!(criterion, case, "lanes4", 4, Instructions::best());
    follow!(criterion, case, "lanes8", 8, Instructions::best());
    follow!(criterion, case, "lanes8_avx2", 8, Instructions::Avx2);
}
