//! The largest jump of a drive in a bounded step, and the part of it that stays in the rates: the figures of docs/limits.md and suspension-core/docs/controller.md.

use suspension_core::linkages::double_wishbone::{Corner, Drives, Model, Points};
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Build, Inputs, Linkage, Motion, Real, Signal, Values};

/// Returns the largest velocity and acceleration after a jump of the wheel's height, with rates of zero; `None` if the step
/// is refused.
fn left<T: Real, const CORRECTIONS: usize>(dt: f64, jump: f64) -> Option<[T; 2]> {
    let corner: Corner<f64> = Corner::design().expect("the design");
    let design = corner.points().value;
    let design = Points::from_values(design.values().map(|point| point.map(T::constant)));
    let model = Model::<T>::new(&design).expect("a model");
    let rest = model.drives_at(&design);
    let mut motion = Motion::at_rest(model.unknowns(&design));
    let jumped = Drives {
        bump: rest.bump + T::constant(jump),
        ..rest
    };
    let inputs = Inputs::still(Signal::still(jumped));
    let step = Bounded::<T, CORRECTIONS>::new();
    let report = step.attempt(
        Outputs::Acceleration,
        &model,
        &inputs,
        T::constant(dt),
        &mut motion,
    );
    report.ok()?;
    let largest = |rates: &[T]| {
        rates
            .iter()
            .fold(T::zero(), |most, rate| most.max(rate.abs()))
    };
    Some([&motion.velocity, &motion.acceleration].map(|rates| largest(rates.as_slice())))
}

#[test]
fn in_f32_a_stated_part_of_a_jump_remains_in_the_rates() {
    for (dt, jump, stated) in [
        (1e-3, 0.5e-3, [3e-3_f32, 6.0]),
        (1e-4, 0.5e-3, [0.03, 600.0]),
        (1e-3, 0.9e-3, [0.01, 20.0]),
    ] {
        let found = left::<f32, 1>(dt, jump).expect("an accepted step");
        for (found, stated) in found.into_iter().zip(stated) {
            assert!(
                (0.9..1.1).contains(&(found / stated)),
                "{found} for {stated}"
            );
        }
    }
}

#[test]
fn in_f64_a_jump_is_refused_or_leaves_nothing_in_the_rates() {
    for jump in [1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3] {
        let left = left::<f64, 1>(1e-3, jump);
        assert!(
            left.is_none_or(|[_, acceleration]| acceleration < 1e-8),
            "{jump}: {left:?}"
        );
    }
}

#[test]
fn more_corrections_accept_larger_jumps_of_a_drive() {
    let is_accepted = |corrections: usize, jump: f64| match corrections {
        1 => left::<f64, 1>(1e-3, jump).is_some(),
        2 => left::<f64, 2>(1e-3, jump).is_some(),
        _ => left::<f64, 3>(1e-3, jump).is_some(),
    };
    for (corrections, stated) in [(1, 4e-8), (2, 2e-5), (3, 3e-4)] {
        assert!(is_accepted(corrections, stated), "{corrections}");
        assert!(!is_accepted(corrections, 1.5 * stated), "{corrections}");
    }
    for (accepted, refused) in [
        (left::<f32, 0>(1e-3, 1.5e-6), left::<f32, 0>(1e-3, 2e-6)),
        (left::<f32, 1>(1e-3, 0.9e-3), left::<f32, 1>(1e-3, 1.1e-3)),
        (left::<f32, 2>(1e-3, 4e-3), left::<f32, 2>(1e-3, 4.4e-3)),
    ] {
        assert!(
            accepted.is_some() && refused.is_none(),
            "{accepted:?} {refused:?}"
        );
    }
}
