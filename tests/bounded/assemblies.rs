//! Far steps arrive in the same assembly, or are refused.

use suspension_core::{Bounded, Motion, Newton, SolveError, Tracker};

use super::case::{attia, five_link};

/// Single steps between any two of forty instants, with the largest number of corrections.
#[test]
fn far_jumps_stay_in_the_assembly_or_are_refused() {
    let case = five_link();
    let instants: Vec<f64> = (0..40).map(|index| f64::from(index) * 0.05).collect();
    let mut motions = vec![case.start];
    for pair in instants.windows(2) {
        let mut motion = motions[motions.len() - 1];
        Tracker::default()
            .advance(&case.model, case.inputs, pair[0], pair[1], &mut motion)
            .expect("a regular motion");
        motions.push(motion);
    }
    let bounded = Bounded::<f64, 8>::new();
    let (mut arrived, mut refused) = (0, 0);
    for (from, start) in instants.iter().zip(&motions) {
        for (to, expected) in instants.iter().zip(&motions) {
            let mut motion = *start;
            let inputs = (case.inputs)(*to);
            if bounded
                .step(&case.model, &inputs, to - from, &mut motion)
                .is_ok()
            {
                arrived += 1;
                let difference = (motion.position - expected.position).amax();
                assert!(difference < 1e-12, "{from} s to {to} s: {difference:e} m");
            } else {
                refused += 1;
                assert_eq!(motion, *start);
            }
        }
    }
    println!("{arrived} arrived, {refused} refused");
    assert!(arrived > 100 && refused > 100);
}

/// Just before the turning point of the drive at 1.97837 s the linkage has two positions for one angle, one on each side. A
/// step whose prediction leads to the other side is refused there.
#[test]
fn no_step_crosses_the_turning_point() {
    let case = attia();
    let mut motion = case.start;
    let t = 1.978;
    Tracker::default()
        .advance(&case.model, case.inputs, 0.0, t, &mut motion)
        .expect("a regular motion");
    let inputs = (case.inputs)(t);
    let bounded = Bounded::<f64, 12, 1>::new();
    let (mut returned, mut crossed) = (0, 0);
    for step in 1..200 {
        let dt = f64::from(step) * 1e-5;
        let mut next = motion;
        match bounded.step(&case.model, &inputs, dt, &mut next) {
            Ok(_) => {
                returned += 1;
                assert!((next.position - motion.position).amax() < 1e-10);
            }
            Err(error) => {
                assert_eq!(next, motion);
                if matches!(error, SolveError::CrossedSingularity { .. }) {
                    crossed += 1;
                    assert_other_side(&motion, dt);
                }
            }
        }
    }
    println!("{returned} returned, {crossed} were on the other side");
    assert!(returned > 0 && crossed > 0);
    let beyond = bounded.step(&case.model, &(case.inputs)(1.99), 0.015, &mut motion);
    beyond.expect_err("no configuration beyond the turning point");
}

/// Asserts that the step would have reached another root.
fn assert_other_side(motion: &Motion<f64, 15>, dt: f64) {
    let case = attia();
    let mut q = motion.position + motion.velocity * dt;
    Newton::from_afar()
        .solve(&case.model, &(case.inputs)(1.978), &mut q)
        .expect("a root on the other side");
    assert!((q - motion.position).amax() > 1e-3);
}
