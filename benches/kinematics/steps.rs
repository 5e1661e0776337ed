//! One step after the other along the motion, in place.

use std::hint::black_box;

use criterion::{Bencher, Criterion};
use suspension_core::{Bounded, Build, Inputs, Listing, Motion, Still, Tracker};
use suspension_lanes::Lane;

use super::case::{Case, OUTPUTS, STEP};

/// The number of steps up to 1.8 s; then the motion restarts.
const STEPS: u32 = 3600;

pub(crate) fn bench<G: Listing<15>, T: Lane + std::fmt::LowerExp>(
    criterion: &mut Criterion,
    case: &Case<G, T>,
) where
    G::Model<T>: Build<15>,
{
    let mut group = criterion.benchmark_group("step");
    for (name, outputs) in OUTPUTS {
        group.bench_function(format!("{name}/{}", case.name), |bencher| {
            follow(bencher, case, |inputs, motion| {
                let model = black_box(&case.model);
                Bounded::<T>::default()
                    .step_to(outputs, model, inputs, T::constant(STEP), motion)
                    .map_err(|error| error.to_string())
            });
        });
    }
    group.bench_function(format!("to_tolerance/{}", case.name), |bencher| {
        follow(bencher, case, |inputs, motion| {
            let model = black_box(&case.model);
            Tracker::default()
                .step(model, inputs, T::constant(STEP), motion)
                .map_err(|error| error.to_string())
        });
    });
}

/// Times the steps along the motion, all of which must succeed.
fn follow<G: Listing<15>, T: Lane, S>(
    bencher: &mut Bencher<'_>,
    case: &Case<G, T>,
    step: impl Fn(&Inputs<Still, G::Drives<T>>, &mut Motion<T, 15>) -> Result<S, String>,
) where
    G::Model<T>: Build<15>,
{
    let start = case.motion(0.0);
    let all: Vec<_> = (1..=STEPS)
        .map(|step| case.inputs(f64::from(step) * STEP))
        .collect();
    let mut motion = start;
    let mut ahead = all.iter();
    bencher.iter(|| {
        let inputs = ahead.next().unwrap_or_else(|| {
            motion = start;
            ahead = all[1..].iter();
            &all[0]
        });
        step(black_box(inputs), &mut motion).expect("a regular motion")
    });
}
