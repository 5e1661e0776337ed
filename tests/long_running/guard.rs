//! Long steps: the right branch or an error, never another assembly in silence.

mod between;
mod published;
mod rack;
mod random;
mod turning_points;

use suspension_core::{Inputs, Linkage, Motion, Real, Signal, Still, Tracker, Values};

/// How steps ended.
#[derive(Debug, Default)]
struct Ends {
    right: usize,
    refused: usize,
}

impl Ends {
    /// Tries one step and compares it with the true motion, `None` where there is none.
    fn add<T: Real, L: Linkage<15, Scalar = T>>(
        &mut self,
        tracker: &Tracker<T>,
        model: &L,
        inputs: &Inputs<Still, L::Drives>,
        [dt, bound]: [T; 2],
        [from, to]: [Option<&Motion<T, 15>>; 2],
    ) {
        let start = from.expect("a motion to start from");
        let mut motion = *start;
        match tracker.step(model, inputs, dt, &mut motion) {
            Ok(_) => {
                let to = to.expect("no configuration, and yet a success");
                let off = (motion.position - to.position).amax();
                assert!(off <= bound, "another assembly, {off} m away, dt = {dt}");
                self.right += 1;
            }
            Err(_) => {
                assert_eq!(motion, *start, "a refused step changes nothing");
                self.refused += 1;
            }
        }
    }
}

/// A drive that is accelerated evenly.
#[derive(Clone, Copy)]
struct Drive {
    start: f64,
    rate: f64,
    second_rate: f64,
}

impl Drive {
    fn inputs<D: Values<f64>>(&self, t: f64) -> Inputs<Still, D> {
        let &Self {
            start,
            rate,
            second_rate,
        } = self;
        Inputs::still(Signal {
            value: D::from_values(std::iter::repeat_with(|| {
                start + rate * t + second_rate * t * t / 2.0
            })),
            rate: D::from_values(std::iter::repeat_with(|| rate + second_rate * t)),
            second_rate: D::from_values(std::iter::repeat(second_rate)),
        })
    }
}
