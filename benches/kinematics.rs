//! What a configuration costs, on the published motion.
//!
//! Ids are `group/function/linkage/number`:
//! - `kernel`: `residual`, `jacobian`, `lu` (the factorisation), `solve` (with the factors);
//! - `newton`: one iteration with the macro's elimination (`generated`), with our dense LU
//!   (`dense`) and with that of `nalgebra`;
//! - `step`: a step of 1 ms from the last motion to the next `position`, `velocity`,
//!   `acceleration`, each including the ones before it.
//!
//! Each call gets another of the instants of the motion, so that no two in a row work on the
//! same numbers.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Bencher, Criterion, criterion_group, criterion_main};
use nalgebra::SVector;
use suspension_core::factored::with_factors;
use suspension_core::lu::Lu;
use suspension_core::motion::Prescribed;
use suspension_core::{
    Build, Inputs, Linkage, Motion, Newton, Real, Still, Tangent, Tracker, assemble,
};

#[path = "../tests/support/mod.rs"]
mod support;

const INSTANTS: usize = 64;
const LAST_INSTANT: f64 = 1.9;
const STEP: f64 = 1e-3;

/// A linkage at many instants of its motion.
struct Case<L: Linkage<15>> {
    /// `linkage/number`.
    name: String,
    model: L,
    starts: Vec<Start<L>>,
}

/// The motion at an instant and the inputs one step later.
struct Start<L: Linkage<15>> {
    motion: Motion<L::Scalar, 15>,
    inputs: Inputs<Still, L::Drives>,
    prescribed: Prescribed<L::Fixed, L::Drives>,
}

impl<T: Real, L: Build<15, Scalar = T>> Case<L> {
    fn new(
        linkage: &str,
        model: L,
        rough: &L::Points,
        inputs: fn(T) -> Inputs<Still, L::Drives>,
    ) -> Self {
        let mut q = L::unknowns(rough);
        assemble(&Newton::from_afar(), &model, &inputs(T::zero()), &mut q).expect("assembles");
        let mut motion = Motion::at_rest(q);
        let mut last = T::zero();
        let starts = (0..INSTANTS).map(|k| {
            let t = LAST_INSTANT * k as f64 / (INSTANTS - 1) as f64;
            let (now, next) = (T::constant(t), T::constant(t + STEP));
            Tracker::default()
                .advance(&model, inputs, last, now, &mut motion)
                .expect("a regular motion");
            last = now;
            let inputs = inputs(next);
            Start {
                motion,
                inputs,
                prescribed: Prescribed::new(&model, &inputs),
            }
        });
        let starts = starts.collect();
        let name = format!("{linkage}/{}", std::any::type_name::<T>());
        Self {
            name,
            model,
            starts,
        }
    }

    /// Times `work` on one instant after the other.
    fn time<R>(&self, bencher: &mut Bencher<'_>, work: impl Fn(&L, &Start<L>) -> R) {
        let mut starts = self.starts.iter().cycle();
        bencher.iter(|| {
            work(
                black_box(&self.model),
                black_box(starts.next().expect("endless")),
            )
        });
    }

    fn kernels(&self, criterion: &mut Criterion) {
        let mut group = criterion.benchmark_group("kernel");
        group.bench_function(format!("residual/{}", self.name), |bencher| {
            self.time(bencher, |model, start| residual(model, start));
        });
        group.bench_function(format!("jacobian/{}", self.name), |bencher| {
            self.time(bencher, |model, start| {
                model.jacobian(&start.motion.position, &start.prescribed.fixed.value)
            });
        });
        let jacobian = |start: &Start<L>| {
            let fixed = &start.prescribed.fixed.value;
            self.model.jacobian(&start.motion.position, fixed)
        };
        let jacobians: Vec<_> = self.starts.iter().map(jacobian).collect();
        group.bench_function(format!("lu/{}", self.name), |bencher| {
            let mut jacobians = jacobians.iter().cycle();
            bencher.iter(|| Lu::factor(black_box(jacobians.next().expect("endless"))));
        });
        let factors: Vec<_> = jacobians.iter().flat_map(Lu::factor).collect();
        let right_side = residual(&self.model, &self.starts[0]);
        group.bench_function(format!("solve/{}", self.name), |bencher| {
            let mut factors = factors.iter().cycle();
            bencher.iter(|| {
                let lu = black_box(factors.next().expect("endless"));
                lu.solve(black_box(&right_side))
            });
        });
    }

    fn iterations(&self, criterion: &mut Criterion) {
        let mut group = criterion.benchmark_group("newton");
        let jacobian = |model: &L, start: &Start<L>| {
            model.jacobian(&start.motion.position, &start.prescribed.fixed.value)
        };
        group.bench_function(format!("generated/{}", self.name), |bencher| {
            self.time(bencher, |model, start| {
                let (q, fixed) = (&start.motion.position, &start.prescribed.fixed.value);
                with_factors(model, q, fixed, T::zero(), |factors| {
                    q - factors.solve(&residual(model, start))
                })
            });
        });
        group.bench_function(format!("dense/{}", self.name), |bencher| {
            self.time(bencher, |model, start| {
                let lu = Lu::factor(&jacobian(model, start));
                lu.map(|lu| start.motion.position - lu.solve(&residual(model, start)))
            });
        });
        group.bench_function(format!("nalgebra/{}", self.name), |bencher| {
            self.time(bencher, |model, start| {
                let lu = jacobian(model, start).lu();
                let step = lu.solve(&residual(model, start));
                step.map(|step| start.motion.position - step)
            });
        });
    }

    fn steps(&self, criterion: &mut Criterion) {
        let mut group = criterion.benchmark_group("step");
        group.bench_function(format!("position/{}", self.name), |bencher| {
            self.time(bencher, |model, start| position(model, start));
        });
        group.bench_function(format!("velocity/{}", self.name), |bencher| {
            self.time(bencher, |model, start| {
                let q = position(model, start);
                let velocity = Tangent::new(model, &start.inputs, &q).map(|t| t.velocity());
                (q, velocity)
            });
        });
        group.bench_function(format!("acceleration/{}", self.name), |bencher| {
            self.time(bencher, |model, start| {
                let mut motion = start.motion;
                let step = Tracker::default().step(model, &start.inputs, dt(), &mut motion);
                step.map(|_| motion)
            });
        });
    }

    fn bench(&self, criterion: &mut Criterion) {
        self.kernels(criterion);
        self.iterations(criterion);
        self.steps(criterion);
    }
}

fn dt<T: Real>() -> T {
    black_box(T::constant(STEP))
}

fn residual<L: Linkage<15>>(model: &L, start: &Start<L>) -> SVector<L::Scalar, 15> {
    let Prescribed { fixed, drives } = &start.prescribed;
    model.residual(&start.motion.position, &fixed.value, &drives.value)
}

fn position<T: Real, L: Linkage<15, Scalar = T>>(model: &L, start: &Start<L>) -> SVector<T, 15> {
    let mut q = start.motion.predict(dt());
    let solved = Newton::near_by().solve(model, &start.inputs, &mut q);
    solved.expect("a regular motion");
    q
}

fn published_motion<T: Real>(criterion: &mut Criterion) {
    Case::new(
        "attia2003",
        support::attia_model(),
        &support::attia_rough(),
        support::attia_inputs::<T>,
    )
    .bench(criterion);
    Case::new(
        "five_link",
        support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs::<T>,
    )
    .bench(criterion);
}

criterion_group! {
    name = kinematics;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2));
    targets = published_motion::<f64>, published_motion::<f32>
}
criterion_main!(kinematics);
