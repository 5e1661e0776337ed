//! Batches over the published motion, as the other harnesses take them: short, a part of a
//! scheduler's slice, so that other load on the machine falls into few of them.
//!
//! `rivals FOLDER` prints for each method and quantity
//! `method,version,quantity,nanoseconds,spread,note` (median of the batches and interquartile
//! range, a call each) and writes to `FOLDER/method.quantity.bin` what was computed at each step:
//! position, velocity, acceleration, 45 numbers.

use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;

use rivals::{Inputs, Mechanism, Method, Motion, Start, Stopwatch, Vector, time_all};

/// Parts are timed in batches of one call from each thirtieth start, 64 of them.
const STRIDE: usize = 30;
const PART_BATCHES: usize = 2000;
/// Steps are timed in batches of this many.
const CHUNK: usize = 100;
const STEP_ROUNDS: usize = 100;

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
        let batches = (0..PART_BATCHES).map(|_| {
            clock(few.len(), || {
                for start in &few {
                    black_box(work(black_box(start)));
                }
            })
        });
        print(method, quantity, batches.collect());
    }

    fn step(&mut self, method: &Method, mut work: impl FnMut(&Motion, &Inputs) -> Motion) {
        let starts = &self.mechanism.starts;
        let first = starts[0].motion;
        let steps = starts.iter().scan(first, |motion, start| {
            *motion = work(motion, &start.inputs);
            Some(*motion)
        });
        self.write(method, "step", steps.collect());
        let mut batches = Vec::new();
        for _ in 0..STEP_ROUNDS {
            let mut motion = first;
            for chunk in starts.chunks(CHUNK) {
                batches.push(clock(chunk.len(), || {
                    for start in chunk {
                        motion = work(&motion, &start.inputs);
                    }
                }));
            }
            black_box(motion);
        }
        print(method, "step", batches);
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

/// Nanoseconds a call.
fn clock(calls: usize, batch: impl FnOnce()) -> f64 {
    let begin = Instant::now();
    batch();
    begin.elapsed().as_nanos() as f64 / calls as f64
}

fn print(method: &Method, quantity: &str, mut times: Vec<f64>) {
    times.sort_by(f64::total_cmp);
    let part = |quarters: usize| times[times.len() * quarters / 4];
    let (median, spread) = (part(2), part(3) - part(1));
    let Method {
        name,
        version,
        note,
    } = method;
    println!("\"{name}\",{version},{quantity},{median:.2},{spread:.2},\"{note}\"");
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
