//! From any bytes to a mechanism and its motion: what `tests/long_running/hostile` demands of random ones.
#![cfg_attr(feature = "fuzzer", no_main)]

use libfuzzer_sys::fuzz_target;
use suspension_core::linkages::{attia2003, five_link};

#[path = "../../long_running/hostile/draw.rs"]
mod draw;
#[path = "../../long_running/hostile/mechanisms.rs"]
mod mechanisms;
#[path = "../../long_running/hostile/reached.rs"]
#[allow(dead_code, reason = "the tests count and hurry")]
mod reached;
#[path = "../../long_running/hostile/trial.rs"]
#[allow(dead_code, reason = "the tests count and hurry")]
mod trial;
#[path = "../../long_running/hostile/verdict.rs"]
mod verdict;
#[path = "../../long_running/hostile/ways.rs"]
mod ways;

use draw::Draw;
use mechanisms::{four_bar, rocker};
use reached::Reached;
use trial::everything;

const RUNS: [fn(&mut Draw<'_>) -> Reached; 8] = [
    everything::<f64, four_bar::Model<f64>, 6>,
    everything::<f32, four_bar::Model<f32>, 6>,
    everything::<f64, rocker::Model<f64>, 6>,
    everything::<f32, rocker::Model<f32>, 6>,
    everything::<f64, five_link::Model<f64>, 15>,
    everything::<f32, five_link::Model<f32>, 15>,
    everything::<f64, attia2003::Model<f64>, 15>,
    everything::<f32, attia2003::Model<f32>, 15>,
];

fuzz_target!(|bytes: &[u8]| {
    let Some((which, rest)) = bytes.split_first() else {
        return;
    };
    let mut words = rest.chunks(4).map(|chunk| {
        let mut word = [0; 4];
        word[..chunk.len()].copy_from_slice(chunk);
        u32::from_le_bytes(word)
    });
    let run = RUNS[usize::from(*which) % RUNS.len()];
    run(&mut Draw::new(&mut || words.next().unwrap_or_default()));
});

#[cfg(not(feature = "fuzzer"))]
fn main() {
    panic!("this target is linked without the fuzzer; tests/fuzz/README.md says how to run it");
}
