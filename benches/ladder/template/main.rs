//! Drives a ladder back and forth and prints the time of a step in nanoseconds.

mod listing;

use std::hint::black_box;
use std::time::{Duration, Instant};

use listing::ladder::{Drives, Model, Points};
use listing::{DESIGN, PITCH, SIZE};
use suspension_core::nalgebra::Vector3;
use suspension_core::{Build, Inputs, Linkage, Motion, Values, Signal, Still, Tracker};

const STEP: f64 = 1e-3;
const BATCHES: usize = 31;
const BATCH: Duration = Duration::from_millis(20);
/// Large ladders have large matrices on the stack.
const STACK: usize = 1 << 28;

struct Ride {
    model: Model<f64>,
    start: Drives<f64>,
    time: f64,
    motion: Motion<f64, SIZE>,
}

impl Ride {
    fn new() -> Self {
        let design = Points::from_values(DESIGN.iter().map(|point| Vector3::from(*point)));
        let model = Model::new(&design).expect("a ladder");
        Self {
            model,
            start: model.drives_at(&design),
            time: 0.0,
            motion: Motion::at_rest(model.unknowns(&design)),
        }
    }

    /// The first body swings by a tenth of the hangers' length, twice a second.
    fn inputs(&self) -> Inputs<Still, Drives<f64>> {
        const OMEGA: f64 = 4.0 * std::f64::consts::PI;
        let (sine, cosine) = (OMEGA * self.time).sin_cos();
        let travel = |travel| Drives { travel, ..Drives::default() };
        Inputs::still(Signal {
            value: Drives { travel: self.start.travel + 0.05 * sine, ..self.start },
            rate: travel(0.05 * OMEGA * cosine),
            second_rate: travel(-0.05 * OMEGA * OMEGA * sine),
        })
    }

    fn step(&mut self) {
        self.time += STEP;
        let inputs = black_box(self.inputs());
        Tracker::default()
            .step(&self.model, &inputs, STEP, &mut self.motion)
            .unwrap_or_else(|error| panic!("at {} s: {error}", self.time));
    }

    /// Returns the largest distance of a body from a copy of the first one.
    fn unlike(&self) -> f64 {
        let bodies = self.motion.position.as_slice().chunks_exact(9).enumerate();
        let differences = bodies.flat_map(|(index, body)| {
            let first = self.motion.position.as_slice();
            body.iter().zip(first).enumerate().map(move |(row, (own, first))| {
                let pitch = if row % 3 == 0 { PITCH * index as f64 } else { 0.0 };
                (own - first - pitch).abs()
            })
        });
        differences.fold(0.0, f64::max)
    }
}

fn measure() {
    let mut ride = Ride::new();
    let (mut steps, start) = (0_u32, Instant::now());
    while steps < 500 || start.elapsed() < BATCH {
        ride.step();
        steps += 1;
    }
    let unlike = ride.unlike();
    assert!(unlike < 1e-9, "bodies differ by {unlike:e} m");
    let batch = (BATCH.as_nanos() / (start.elapsed() / steps).as_nanos().max(1)).max(1) as u32;
    let mut times = [(); BATCHES].map(|()| {
        let start = Instant::now();
        for _ in 0..batch {
            ride.step();
        }
        start.elapsed().as_nanos() as f64 / f64::from(batch)
    });
    times.sort_by(f64::total_cmp);
    println!("{}", times[BATCHES / 2]);
}

fn main() {
    let worker = std::thread::Builder::new().stack_size(STACK).spawn(measure);
    worker.expect("a thread").join().expect("a ladder that moves");
}
