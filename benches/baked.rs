//! The cost of a look-up in a baked curve, over the published motion.
//!
//! Ids are `baked/FUNCTION/LINKAGE/f64` with `position`, `velocity` and `acceleration`, each
//! including the ones before it: the wheel's pose (six outputs) to 1e-6 m, with a first derivative
//! that does not jump. `velocity_1e-4` and `velocity_1e-8` are `velocity` to those tolerances,
//! `velocity_all` is that of all points (18 outputs). Each call looks up another place.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use suspension::bake::{Baked, Continuity, Path, RequestedPoints, TERMS, Wanted, bake};
use suspension::mechanism::Suspension;
use suspension_core::baked::Place;
use suspension_core::{Inputs, Still};

#[path = "../tests/support/mod.rs"]
mod support;

const PLACES: usize = 1024;
const RANGE: [f64; 2] = [0.7, 2.150_312_5];

type Wheel<'a> = Place<'a, f64, 6, TERMS>;
type AllPoints<'a> = Place<'a, f64, 18, TERMS>;

/// Times evaluations at a sequence of places.
fn time<R, const OUT: usize>(
    criterion: &mut Criterion,
    id: String,
    baked: &Baked,
    read: impl Fn(Place<'_, f64, OUT, TERMS>) -> R,
) {
    let segments = baked.table::<f64, OUT>().expect("so many outputs");
    let curve = baked.curve(&segments);
    // Multiples of the golden ratio, modulo 1: spread over the range, consecutive ones far apart.
    let part = |k: usize| (k as f64 * 0.618_033_988_749_895).fract();
    let places: Vec<f64> = (0..PLACES)
        .map(|k| RANGE[0] + (RANGE[1] - RANGE[0]) * part(k))
        .collect();
    let mut places = places.iter().cycle();
    criterion
        .benchmark_group("baked")
        .bench_function(id, |bencher| {
            bencher.iter(|| {
                let place = places.next().expect("endless");
                black_box(&curve).at(*place).map(&read)
            });
        });
}

fn linkage<L>(
    criterion: &mut Criterion,
    name: &str,
    model: &L,
    rough: &L::Points,
    inputs: fn(f64) -> Inputs<Still, L::Drives>,
) where
    L: Suspension<15>,
{
    let start = support::motions(model, rough, inputs)[0];
    let held = inputs(0.0).drives.value;
    let to = |tolerance, points| {
        let path = Path::new(model, &start, held, 0, RANGE, points).expect("a regular range");
        let wanted = Wanted {
            range: RANGE,
            tolerance,
            metre: 1.0,
            continuity: Continuity::Velocity,
        };
        bake(&wanted, &path).expect("within the tolerance")
    };
    let id = |function: &str| format!("{function}/{name}/f64");
    let baked = to(1e-6, RequestedPoints::Wheel(0));
    let [rate, second_rate] = [1.5, -0.7];
    time(criterion, id("position"), &baked, |place: Wheel<'_>| {
        place.position()
    });
    time(criterion, id("velocity"), &baked, |place: Wheel<'_>| {
        place.velocity(black_box(rate))
    });
    time(criterion, id("acceleration"), &baked, |place: Wheel<'_>| {
        place.acceleration(black_box(rate), black_box(second_rate))
    });
    for tolerance in [1e-4, 1e-8] {
        let (id, baked) = (
            id(&format!("velocity_{tolerance:e}")),
            to(tolerance, RequestedPoints::Wheel(0)),
        );
        time(criterion, id, &baked, |place: Wheel<'_>| {
            place.velocity(black_box(rate))
        });
    }
    let all = to(1e-6, RequestedPoints::AllPoints);
    time(
        criterion,
        id("velocity_all"),
        &all,
        |place: AllPoints<'_>| place.velocity(black_box(rate)),
    );
}

fn published_motion(criterion: &mut Criterion) {
    linkage(
        criterion,
        "attia2003",
        &support::attia_model(),
        &support::attia_rough(),
        support::attia_inputs,
    );
    linkage(
        criterion,
        "five_link",
        &support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
    );
}

criterion_group! {
    name = baked;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2));
    targets = published_motion
}
criterion_main!(baked);
