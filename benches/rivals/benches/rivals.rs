//! The Rust rivals and our generated solver, with ids `quantity/method`.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use rivals::{Inputs, Mechanism, Method, Motion, Start, Stopwatch, Vector, time_all};

/// Each call gets another of 64 instants.
const STRIDE: usize = 30;

struct Benches<'a> {
    criterion: &'a mut Criterion,
    mechanism: &'a Mechanism,
}

impl Stopwatch for Benches<'_> {
    fn part(&mut self, method: &Method, quantity: &str, mut work: impl FnMut(&Start) -> Vector) {
        let id = format!("{quantity}/{}", method.name);
        let mut starts = self.mechanism.starts.iter().step_by(STRIDE).cycle();
        self.criterion.bench_function(&id, |bencher| {
            bencher.iter(|| work(black_box(starts.next().expect("endless"))));
        });
    }

    fn step(&mut self, method: &Method, mut work: impl FnMut(&Motion, &Inputs) -> Motion) {
        let id = format!("step/{}", method.name);
        let mut starts = self.mechanism.starts.iter().step_by(STRIDE).cycle();
        self.criterion.bench_function(&id, |bencher| {
            bencher.iter(|| {
                let start = black_box(starts.next().expect("endless"));
                work(&start.motion, &start.inputs)
            });
        });
    }
}

fn rivals(criterion: &mut Criterion) {
    let mechanism = Mechanism::published();
    let mut benches = Benches {
        criterion,
        mechanism: &mechanism,
    };
    time_all(&mechanism, &mut benches);
}

criterion_group!(benches, rivals);
criterion_main!(benches);
