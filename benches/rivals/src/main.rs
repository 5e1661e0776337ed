//! Batches over the published motion, as the other harnesses take them: short, a part of a
//! scheduler's slice, so that other load on the machine falls into few of them.
//!
//! `rivals FOLDER` prints for each method and quantity
//! `method,version,quantity,nanoseconds,spread,note` (median of the batches and interquartile
//! range, a call each) and writes to `FOLDER/method.quantity.bin` what was computed at each step:
//! position, velocity, acceleration, 45 numbers. With the wheel centres of `FOLDER/centres.bin` it
//! writes the forces of rods to `FOLDER/rods.bin`, and what ours say past the lock to
//! `FOLDER/method.lock.txt`.

use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;

use rivals::{
    Inputs, Mechanism, Method, Motion, Start, Stopwatch, Vector, past_lock, rods, time_all,
};

/// Parts are timed in batches of 64, one call from each thirtieth start.
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
        let parts = motions
            .iter()
            .flat_map(|m| [m.position, m.velocity, m.acceleration]);
        let numbers = bytes(parts.flat_map(|part| part.data.0[0]));
        self.keep(&format!("{}.{quantity}.bin", method.name), &numbers);
    }

    fn keep(&self, name: &str, content: &[u8]) {
        let path = self.folder.join(name);
        std::fs::write(&path, content)
            .unwrap_or_else(|error| stop(&format!("{}: {error}", path.display())));
    }

    /// The wheel centres relative to point 6, at the steps with a load.
    fn wheel_centres(&self) -> Vec<[f64; 3]> {
        let path = self.folder.join("centres.bin");
        let bytes = std::fs::read(&path)
            .unwrap_or_else(|error| stop(&format!("{}: {error}", path.display())));
        let number = |at: &[u8]| f64::from_le_bytes(at.try_into().expect("eight bytes"));
        bytes
            .chunks_exact(24)
            .map(|row| [0, 8, 16].map(|at| number(&row[at..at + 8])))
            .collect()
    }
}

fn bytes(numbers: impl Iterator<Item = f64>) -> Vec<u8> {
    numbers.flat_map(f64::to_le_bytes).collect()
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
    let centres = batches.wheel_centres();
    batches.keep("rods.bin", &bytes(rods(&mechanism, &centres)));
    for (method, said) in past_lock(&mechanism) {
        batches.keep(&format!("{method}.lock.txt"), said.as_bytes());
    }
}
