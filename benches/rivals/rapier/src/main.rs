//! Rapier on the published motion: `rapier-rival STARTS FOLDER ITERATIONS`, with the same tasks as in `../native/engine.h`
//! except for the forces of the rods: Rapier reports impulses of joints along rows that it has orthogonalised.

mod files;
mod listing;
mod mechanism;

use std::path::Path;
use std::time::Instant;

use files::{Start, starts, write};
use listing::Listing;
use mechanism::{Engine, STEP};

const STEPS: usize = 1900;
const CHUNK: usize = 100;
const ROUNDS: usize = 30;
const PAST_LOCK: usize = 2100;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [recorded, folder, iterations] = &arguments[..] else {
        eprintln!("usage: rapier-rival STARTS FOLDER ITERATIONS");
        std::process::exit(2);
    };
    let iterations = iterations.parse().expect("a number of iterations");
    let (listing, starts) = (Listing::published(), starts(Path::new(recorded)));
    let folder = Path::new(folder);
    let new = |start: &Start| Engine::new(&listing, start, iterations);
    let mut engine = new(&starts[0]);
    let motions: Vec<f64> = (1..=STEPS)
        .flat_map(|k| {
            engine.step(k as f64 * STEP);
            engine.motion()
        })
        .collect();
    write(&folder.join("step.bin"), motions);
    let (median, spread) = time(&listing, &starts[0], iterations);
    println!("step,{median:.2},{spread:.2}");
    let mut engine = new(&starts[0]);
    (1..=PAST_LOCK).for_each(|k| engine.step(k as f64 * STEP));
    let (end, off) = (PAST_LOCK as f64 * STEP, engine.stretch() * 1e3);
    println!("lock,silent; at t = {end:.1} s a rod is {off:.0} mm off");
}

/// Median and interquartile range of the batches, ns a step.
fn time(listing: &Listing, start: &Start, iterations: usize) -> (f64, f64) {
    let mut batches = Vec::new();
    for _ in 0..ROUNDS {
        let mut engine = Engine::new(listing, start, iterations);
        for chunk in 0..STEPS / CHUNK {
            let begin = Instant::now();
            for k in 1..=CHUNK {
                engine.step((chunk * CHUNK + k) as f64 * STEP);
                std::hint::black_box(engine.motion());
            }
            batches.push(begin.elapsed().as_nanos() as f64 / CHUNK as f64);
        }
    }
    batches.sort_by(f64::total_cmp);
    let part = |quarters: usize| batches[batches.len() * quarters / 4];
    (part(2), part(3) - part(1))
}
