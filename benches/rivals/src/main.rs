//! Batches over the published motion, as the other harnesses take them.
//!
//! `rivals FOLDER` prints for each method and quantity
//! `method,version,quantity,nanoseconds,spread,note` (median of the batches and interquartile
//! range, a call each) and writes to `FOLDER/method.quantity.bin` what was computed at each step:
//! position, velocity, acceleration, 45 numbers.

use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;

use rivals::{Inputs, Mechanism, Method, Motion, Start, Stopwatch, Vector, time_all};

const BATCHES: usize = 101;
const WARM_UP: usize = 3;
/// Parts are timed from each thirtieth start, 64 of them.
const STRIDE: usize = 30;

struct Batches<'a> {
    mechanism: &'a Mechanism,
    folder: PathBuf,
}

impl Stopwatch for Batches<'_> {
    fn part(&mut self, method: &Method, quantity: &str, mut work: impl FnMut(&Start) -> Vector) {
        let starts = &self.mechanism.starts;
        let found = starts.iter().map(|start| Motion::at_rest(work(start)));
        self.write(method, quantity, found.collect());
        let few: Vec<&Start> = starts.iter().step_by(STRIDE).collect();
        let calls = STRIDE * few.len();
        print(method, quantity, calls, || {
            for start in few.iter().cycle().take(calls) {
                black_box(work(black_box(start)));
            }
        });
    }

    fn step(&mut self, method: &Method, mut work: impl FnMut(&Motion, &Inputs) -> Motion) {
        let starts = &self.mechanism.starts;
        let first = starts[0].motion;
        let steps = starts.iter().scan(first, |motion, start| {
            *motion = work(motion, &start.inputs);
            Some(*motion)
        });
        self.write(method, "step", steps.collect());
        print(method, "step", starts.len(), || {
            let mut motion = first;
            for start in starts {
                motion = work(&motion, &start.inputs);
            }
            black_box(motion);
        });
    }
}

impl Batches<'_> {
    fn write(&self, method: &Method, quantity: &str, motions: Vec<Motion>) {
        let path = self.folder.join(format!("{}.{quantity}.bin", method.name));
        let parts = motions
            .iter()
            .flat_map(|m| [m.position, m.velocity, m.acceleration]);
        let bytes: Vec<u8> = parts
            .flat_map(|part| part.data.0[0])
            .flat_map(f64::to_le_bytes)
            .collect();
        std::fs::write(&path, bytes)
            .unwrap_or_else(|error| stop(&format!("{}: {error}", path.display())));
    }
}

fn print(method: &Method, quantity: &str, calls: usize, mut batch: impl FnMut()) {
    let mut times: Vec<f64> = (0..WARM_UP + BATCHES)
        .map(|_| {
            let begin = Instant::now();
            batch();
            begin.elapsed().as_nanos() as f64 / calls as f64
        })
        .skip(WARM_UP)
        .collect();
    times.sort_by(f64::total_cmp);
    let spread = times[3 * BATCHES / 4] - times[BATCHES / 4];
    let Method {
        name,
        version,
        note,
    } = method;
    let median = times[BATCHES / 2];
    println!("{name},{version},{quantity},{median:.2},{spread:.2},\"{note}\"");
}

fn stop(message: &str) -> ! {
    eprintln!("{message}");
    std::process::exit(1);
}

fn main() {
    let Some(folder) = std::env::args().nth(1) else {
        stop("usage: rivals FOLDER");
    };
    let mechanism = Mechanism::published();
    let mut batches = Batches {
        mechanism: &mechanism,
        folder: Path::new(&folder).to_owned(),
    };
    time_all(&mechanism, &mut batches);
}
