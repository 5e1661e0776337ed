//! Steps of suspensions with random points.

use nalgebra::Vector3;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{Build, Motion, Tracker, Values};

use super::{Drive, Ends};
use crate::support;

/// A generator of the same numbers every time (Marsaglia's xorshift).
pub(super) struct Random(pub(super) u64);

impl Random {
    /// In [0, 1).
    pub(super) fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn vector(&mut self, size: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| (self.uniform() * 2.0 - 1.0) * size)
    }
}

const FINE: f64 = 1e-3;

/// The motion from the design in fine steps, as far as it goes.
fn fine_motion<L: Build<15, Scalar = f64, Listing: Default>>(
    model: &L,
    design: &L::Points,
    drive: &Drive,
) -> Vec<Motion<f64, 15>> {
    let tracker = Tracker::default();
    let mut motion = Motion::at_rest(model.unknowns(design));
    let mut truth = Vec::new();
    let mut last = 0.0;
    for index in 0..1500 {
        let t = f64::from(index) * FINE;
        let inputs = |t| drive.inputs::<L::Drives>(t);
        if tracker
            .advance(model, inputs, last, t, &mut motion)
            .is_err()
        {
            break;
        }
        truth.push(motion);
        last = t;
    }
    truth
}

/// Steps of 2 ms to 1 s of suspensions with random points, from random places, either way.
fn random_jumps<L: Build<15, Scalar = f64, Listing: Default>>(
    rough: &L::Points,
    seed: u64,
) -> Ends {
    println!("seed {seed}");
    let mut random = Random(seed);
    let tracker = Tracker::default();
    let mut ends = Ends::default();
    for index in 0..240 {
        let size = [0.02, 0.1, 0.3][index % 3];
        let points = rough.values();
        let design = L::Points::from_values(points.map(|each| each + random.vector(size)));
        let Ok(model) = L::of(L::Listing::default(), &design) else {
            continue;
        };
        let drive = Drive {
            start: model.drives_at(&design).values().next().unwrap_or_default(),
            rate: random.uniform() * 4.0 - 2.0,
            second_rate: random.uniform() * 4.0 - 2.0,
        };
        let truth = fine_motion(&model, &design, &drive);
        for _ in 0..if truth.len() < 20 { 0 } else { 40 } {
            let from = (random.uniform() * truth.len() as f64) as usize;
            let length = 10_f64.powf(random.uniform() * 2.7) * 2.0;
            let forwards = random.uniform() < 0.5;
            let Some(to) = from.checked_add_signed(if forwards {
                length as isize
            } else {
                -(length as isize)
            }) else {
                continue;
            };
            if to >= 1500 {
                continue;
            }
            let dt = (to as f64 - from as f64) * FINE;
            let inputs = drive.inputs(to as f64 * FINE);
            let between = [truth.get(from), truth.get(to)];
            ends.add(&tracker, &model, &inputs, [dt, 1e-7], between);
        }
    }
    ends
}

#[test]
fn jumps_of_random_suspensions_stay_in_the_assembly_or_are_refused() {
    let ends = [
        random_jumps::<attia2003::Model<f64>>(&support::attia_rough(), 2003),
        random_jumps::<five_link::Model<f64>>(&support::five_link_rough(), 17),
    ];
    for ends in ends {
        println!("{ends:?}");
        assert!(ends.right > 3000, "{ends:?}");
    }
}
