//! Steps between instants of the published motion.

use suspension_core::{Build, Inputs, Real, Still, Tracker};

use super::Ends;
use crate::support;

/// Every single step between instants 50 ms apart over the published motion, near and far, forwards
/// and backwards; the ends of those of 50 ms and of 100 ms, and of all others.
fn published<T: Real, L: Build<15, Scalar = T>>(
    model: &L,
    rough: &L::Points,
    inputs: impl Fn(T) -> Inputs<Still, L::Drives>,
    bound: f64,
) -> [Ends; 3] {
    let tracker = Tracker::default();
    let mut motion = support::motions(model, rough, &inputs)[0];
    let instants: Vec<T> = (0..40).map(|i| T::constant(f64::from(i) * 0.05)).collect();
    let mut truth = vec![motion];
    for pair in instants.windows(2) {
        let fine =
            (1..=50).map(|i| pair[0] + (pair[1] - pair[0]) * T::constant(f64::from(i) / 50.0));
        let mut last = pair[0];
        for t in fine {
            let step = tracker.step(model, &inputs(t), t - last, &mut motion);
            step.expect("a regular motion");
            last = t;
        }
        truth.push(motion);
    }
    let mut ends: [Ends; 3] = Default::default();
    for from in 0..truth.len() {
        for to in (0..truth.len()).filter(|to| *to != from) {
            let kind = from.abs_diff(to).min(3) - 1;
            let dt = instants[to] - instants[from];
            let between = [truth.get(from), truth.get(to)];
            let sizes = [dt, T::constant(bound)];
            ends[kind].add(&tracker, model, &inputs(instants[to]), sizes, between);
        }
    }
    ends
}

/// The same of both listings.
fn of_both<T: Real>(bound: f64) -> [[Ends; 3]; 2] {
    [
        published::<T, _>(
            &support::attia_model(),
            &support::attia_rough(),
            support::attia_inputs,
            bound,
        ),
        published::<T, _>(
            &support::five_link_model(),
            &support::five_link_rough(),
            support::five_link_inputs,
            bound,
        ),
    ]
}

#[test]
fn jumps_of_the_published_motion_end_right_and_are_rarely_refused() {
    // At 1.95 s, near the turning point, an f32 knows the position to 1e-4 m.
    let cases = [of_both::<f64>(1e-12), of_both::<f32>(2e-4)];
    for ends in cases.into_iter().flatten() {
        println!("50 ms, 100 ms, longer: {ends:?}");
        let [fifty, hundred, _] = ends;
        assert!(fifty.refused <= 2, "78 steps of 50 ms: {fifty:?}");
        assert!(hundred.refused <= 8, "76 steps of 100 ms: {hundred:?}");
    }
}
