//! The parts of an iteration, and a whole iteration, at many instants of the motion.

use std::hint::black_box;

use criterion::{Bencher, Criterion};
use nalgebra::SVector;
use suspension_core::linkage::Factors as _;
use suspension_core::solve::lu::Lu;
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Build, Linkage, Listing};
use suspension_lanes::Lane;

use super::case::Case;

const INSTANTS: usize = 64;
const LAST_INSTANT: f64 = 1.9;

/// A configuration, and the inputs a little later.
struct Instant<L: Linkage<15>> {
    position: SVector<L::Scalar, 15>,
    prescribed: Prescribed<L::Fixed, L::Drives>,
}

impl<L: Linkage<15>> Instant<L> {
    fn residual(&self, model: &L) -> SVector<L::Scalar, 15> {
        let Prescribed { fixed, drives } = &self.prescribed;
        model.residual(&self.position, &fixed.value, &drives.value)
    }

    fn factors(&self, model: &L) -> L::Factors {
        model.factor(&self.position, &self.prescribed.fixed.value)
    }
}

fn instants<G: Listing<15>, T: Lane>(case: &Case<G, T>) -> Vec<Instant<G::Model<T>>>
where
    G::Model<T>: Build<15>,
{
    let all = (0..INSTANTS).map(|k| {
        let t = LAST_INSTANT * k as f64 / (INSTANTS - 1) as f64;
        Instant {
            position: case.motion(t).position,
            prescribed: Prescribed::new(&case.model, &case.inputs(t + 1e-3)),
        }
    });
    all.collect()
}

/// Times `work` on a sequence of items.
fn time<I, R>(bencher: &mut Bencher<'_>, items: &[I], work: impl Fn(&I) -> R) {
    let mut items = items.iter().cycle();
    bencher.iter(|| work(black_box(items.next().expect("endless"))));
}

pub(crate) fn bench<G: Listing<15>, T: Lane>(criterion: &mut Criterion, case: &Case<G, T>)
where
    G::Model<T>: Build<15>,
{
    let instants = instants(case);
    kernels(criterion, case, &instants);
    iterations(criterion, case, &instants);
}

fn kernels<G: Listing<15>, T: Lane>(
    criterion: &mut Criterion,
    case: &Case<G, T>,
    instants: &[Instant<G::Model<T>>],
) {
    let model = &case.model;
    let mut group = criterion.benchmark_group("kernel");
    group.bench_function(format!("residual/{}", case.name), |bencher| {
        time(bencher, instants, |at| at.residual(black_box(model)));
    });
    group.bench_function(format!("factor/{}", case.name), |bencher| {
        time(bencher, instants, |at| at.factors(black_box(model)));
    });
    let systems: Vec<_> = instants
        .iter()
        .map(|at| (at.factors(model), at.residual(model)))
        .collect();
    group.bench_function(format!("solve/{}", case.name), |bencher| {
        time(bencher, &systems, |(factors, right)| factors.solve(right));
    });
}

fn iterations<G: Listing<15>, T: Lane>(
    criterion: &mut Criterion,
    case: &Case<G, T>,
    instants: &[Instant<G::Model<T>>],
) {
    let mut group = criterion.benchmark_group("newton");
    group.bench_function(format!("generated/{}", case.name), |bencher| {
        time(bencher, instants, |at| {
            let model = black_box(&case.model);
            at.position - at.factors(model).solve(&at.residual(model))
        });
    });
    let jacobian = |model: &G::Model<T>, at: &Instant<G::Model<T>>| {
        model.jacobian(&at.position, &at.prescribed.fixed.value)
    };
    group.bench_function(format!("dense/{}", case.name), |bencher| {
        time(bencher, instants, |at| {
            let model = black_box(&case.model);
            let lu = Lu::factor(&jacobian(model, at));
            lu.map(|lu| at.position - lu.solve(&at.residual(model)))
        });
    });
    group.bench_function(format!("nalgebra/{}", case.name), |bencher| {
        time(bencher, instants, |at| {
            let model = black_box(&case.model);
            let step = jacobian(model, at).lu().solve(&at.residual(model));
            step.map(|step| at.position - step)
        });
    });
}
