//! The cost of following a curve, on the published mechanism with its drive free.
//!
//! Ids are `path/function/linkage/number`:
//! - `step`: one step of predictor and corrector, once round the closed curve again and again;
//! - `start`: from a configuration to a path that is ready to go;
//! - `led`: a step of 1 ms led by the height of the wheel centre, down at 0.1 m/s.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::SVector;
use suspension_core::linkage::HasWheel;
use suspension_core::path::{Continuation, Curve, Leader, Led, Path};
use suspension_core::{Build, Inputs, Newton, Real, Signal, Still, Tracker, assemble};

#[path = "../tests/support/mod.rs"]
mod support;

struct Case<T: Real, L: Build<15, Scalar = T>> {
    name: String,
    model: L,
    inputs: Inputs<Still, L::Drives>,
    q: SVector<T, 15>,
}

impl<T, L> Case<T, L>
where
    T: Real,
    L: Build<15, Scalar = T, Points: HasWheel<T>>,
{
    /// The motion at t = 1 s of the published one, at rest.
    fn new(
        name: &str,
        model: L,
        rough: &L::Points,
        inputs: fn(T) -> Inputs<Still, L::Drives>,
    ) -> Self {
        let mut q = model.unknowns(rough);
        assemble(&Newton::from_afar(), &model, &inputs(T::zero()), &mut q).expect("assembles");
        let mut motion = suspension_core::Motion::at_rest(q);
        Tracker::default()
            .advance(&model, inputs, T::zero(), T::one(), &mut motion)
            .expect("a regular motion");
        Self {
            name: format!("{name}/{}", std::any::type_name::<T>()),
            model,
            inputs: inputs(T::one()),
            q: motion.position,
        }
    }

    fn curve(&self) -> Curve<'_, L, 15> {
        Curve::new(&self.model, &self.inputs, 0).expect("a drive")
    }

    fn path(&self) -> Path<'_, L, 15> {
        let path = Continuation::default().path(self.curve(), black_box(&self.q), true);
        path.expect("a regular start")
    }

    fn bench(&self, criterion: &mut Criterion) {
        let mut group = criterion.benchmark_group("path");
        let mut path = self.path();
        group.bench_function(format!("step/{}", self.name), |bencher| {
            bencher.iter(|| {
                if let Some(stretch) = path.next() {
                    black_box(stretch.expect("a regular curve"));
                } else {
                    path = self.path();
                }
            });
        });
        group.bench_function(format!("start/{}", self.name), |bencher| {
            bencher.iter(|| black_box(*self.path().here()));
        });
        group.bench_function(format!("led/{}", self.name), |bencher| {
            let (dt, rate) = (T::constant(1e-3), T::constant(-0.1));
            let height = |points: &Signal<L::Points>| Signal {
                value: points.value.wheel()[1].z,
                rate: points.rate.wheel()[1].z,
                second_rate: points.second_rate.wheel()[1].z,
            };
            // A tenth of a metre down and, from its start, again.
            let still = Led::at_rest(&self.curve(), &self.q).expect("regular");
            let start = height(&still.points(&self.model, &self.inputs)).value;
            let (mut led, mut step) = (still, 0_u32);
            bencher.iter(|| {
                if step == 1000 {
                    (led, step) = (still, 0);
                }
                let target = Signal {
                    value: start + rate * dt * T::constant(f64::from(step)),
                    rate,
                    second_rate: T::zero(),
                };
                step += 1;
                let (model, target) = (black_box(&self.model), black_box(&target));
                let leader = Leader::default();
                leader
                    .step(model, &self.inputs, height, target, dt, &mut led)
                    .expect("a regular motion")
            });
        });
    }
}

fn published_mechanism<T: Real>(criterion: &mut Criterion) {
    Case::<T, _>::new(
        "attia2003",
        support::attia_model(),
        &support::attia_rough(),
        support::attia_inputs,
    )
    .bench(criterion);
    Case::<T, _>::new(
        "five_link",
        support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
    )
    .bench(criterion);
}

criterion_group! {
    name = all;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2));
    targets = published_mechanism::<f64>, published_mechanism::<f32>
}
criterion_main!(all);
