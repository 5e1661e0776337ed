//! Sums of coordinates with factors far from 1, as of a drive in another unit than the points. Their equations must be scaled
//! as lengths are, because rounding, pivots and corrections are judged as lengths.

use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Inputs, Signal, Still};

/// Two arms that rise alike, the right one 20 mm above the left, by a drive that is `per` times their mean height, which is
/// followed up and down by 0.1 m.
macro_rules! arms {
    ($name:ident, $half:tt, $per:tt) => {
        mod $name {
            use super::*;

            suspension_core::linkage! {
                mod arms {
                    fixed: left_front at [0.3, 0.3, 0.3], left_rear at [-0.3, 0.3, 0.3],
                           right_front at [0.3, -0.3, 0.3], right_rear at [-0.3, -0.3, 0.3];
                    free:  left at [0.0, 0.7, 0.35], right at [0.0, -0.7, 0.37];
                    hinge left_arm:  left_front, left_rear -> left;
                    hinge right_arm: right_front, right_rear -> right;
                    couple level: $per left.z = $per right.z;
                    drive heave: $half left.z + $half right.z;
                }
            }

            steps!(steps_follow_in_f64, f64, $per);
            steps!(steps_follow_in_f32, f32, $per);
        }
    };
}

macro_rules! steps {
    ($test:ident, $number:ty, $per:tt) => {
        #[test]
        fn $test() {
            const DT: $number = 1e-3;
            let mut corner: arms::Corner<$number> = arms::Corner::design().expect("pivots");
            let along = |step: u16| {
                let (sine, cosine) = (3.0 * DT * <$number>::from(step)).sin_cos();
                [0.36 + 0.1 * sine, 0.3 * cosine, -0.9 * sine]
            };
            let signal = |step: u16| {
                let [value, rate, second_rate] = along(step).map(|of| arms::Drives {
                    heave: $per as $number * of,
                });
                Signal {
                    value,
                    rate,
                    second_rate,
                }
            };
            // The arms move at once, which takes more corrections than an attempt has.
            corner.step(DT, signal(0)).expect("a start");
            let (mut motion, bounded) = (*corner.motion(), Bounded::<$number>::default());
            for step in 1..=2000 {
                // These steps are accepted by the residual, attempts by the size of the correction.
                let stepped = corner.step(DT, signal(step));
                stepped.unwrap_or_else(|failure| panic!("step {step}: {failure}"));
                let inputs: Inputs<Still, _> = Inputs::still(signal(step));
                let outputs = Outputs::Acceleration;
                let attempted = bounded.attempt(outputs, corner.model(), &inputs, DT, &mut motion);
                attempted.unwrap_or_else(|refusal| panic!("step {step}: {refusal:?}"));
                let [height, rate, second_rate] = along(step);
                for (signal, expected, above, roundings) in [
                    (&motion.position, height, 0.01, 8.0),
                    (&motion.velocity, rate, 0.0, 64.0),
                    (&motion.acceleration, second_rate, 0.0, 512.0),
                ] {
                    for (z, expected) in
                        [(signal[2], expected - above), (signal[5], expected + above)]
                    {
                        let off = (z - expected).abs() / <$number>::EPSILON;
                        assert!(
                            off <= roundings,
                            "step {step}: {z}, not {expected}: {off} roundings"
                        );
                    }
                }
            }
        }
    };
}

arms!(thousandths, 0.0005, 0.001);
arms!(degrees, 28.65, 57.3);
arms!(thousands, 500, 1000);
