//! What a look-up in a baked curve costs: ids are `baked/FUNCTION/LINKAGE/f64` with `position`,
//! `velocity` and `acceleration`, each including the ones before it. Wheel pose to 1e-6 m.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use suspension::bake::{Continuity, Path, Wanted, Wish, bake};
use suspension_core::baked::Curve;
use suspension_core::linkages::five_link;
use suspension_core::{Build, HasWheel, Inputs, Motion, Still};

#[path = "../tests/support/mod.rs"]
mod support;

const PLACES: usize = 1024;

fn linkage<L>(
    criterion: &mut Criterion,
    name: &str,
    model: L,
    rough: &L::Points,
    inputs: fn(f64) -> Inputs<Still, L::Drives>,
) where
    L: Build<15, Scalar = f64, Points: HasWheel<f64>>,
{
    let motion: Motion<f64, 15> = support::motions(&model, rough, inputs)[0];
    let range = [0.7, 2.125];
    let path = Path::new(
        &model,
        &motion,
        inputs(0.0).drives.value,
        0,
        range,
        Wish::Wheel,
    )
    .expect("a regular range");
    for continuity in [
        Continuity::Position,
        Continuity::Velocity,
        Continuity::Acceleration,
    ] {
        for tolerance in [1e-4, 1e-6, 1e-8] {
            let wanted = Wanted {
                range,
                tolerance,
                metre: 1.0,
                continuity,
            };
            match bake(&wanted, &path.outputs(), &|at| path.at(at)) {
                Ok(baked) => println!(
                    "{name} {continuity:?} {tolerance:e}: {} segments {:?}",
                    baked.segments.len(),
                    baked.reached
                ),
                Err(e) => println!("{e:?}"),
            }
        }
    }
    let wanted = Wanted {
        range,
        tolerance: 1e-6,
        metre: 1.0,
        continuity: Continuity::Velocity,
    };
    let baked = bake(&wanted, &path.outputs(), &|at| path.at(at)).expect("baked");
    let mut table = vec![[[0.0; 6]; 4]; baked.segments.len()];
    for (row, segment) in table.iter_mut().zip(&baked.segments) {
        for (o, output) in segment.iter().enumerate() {
            for (k, c) in output.iter().enumerate() {
                for a in 0..3 {
                    row[k][3 * o + a] = c[a];
                }
            }
        }
    }
    let curve = Curve {
        range,
        segments_per_unit: table.len() as f64 / (range[1] - range[0]),
        segments: &table,
    };
    let mut seed = 0x1234_5678_u64;
    let places: Vec<f64> = (0..PLACES)
        .map(|_| {
            seed = seed
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            range[0] + (range[1] - range[0]) * ((seed >> 11) as f64 / (1u64 << 53) as f64)
        })
        .collect();
    let mut group = criterion.benchmark_group("baked");
    let mut next = places.iter().cycle();
    group.bench_function(format!("position/{name}/f64"), |b| {
        b.iter(|| curve.at(*next.next().unwrap()).map(|p| p.position()))
    });
    group.bench_function(format!("velocity/{name}/f64"), |b| {
        b.iter(|| {
            curve
                .at(*next.next().unwrap())
                .map(|p| p.velocity(black_box(1.0)))
        })
    });
    group.bench_function(format!("acceleration/{name}/f64"), |b| {
        b.iter(|| {
            curve
                .at(*next.next().unwrap())
                .map(|p| p.acceleration(black_box(1.0), black_box(1.0)))
        })
    });
}

fn published(criterion: &mut Criterion) {
    linkage(
        criterion,
        "five_link",
        support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    let _ = five_link::Points::<f64>::default();
}

criterion_group! {
    name = baked;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2));
    targets = published
}
criterion_main!(baked);
