//! What a drive that jumps leaves in the rates of a bounded step: the figures of docs/limits.md and docs/controller.md.

use suspension_core::bounded::Outputs;
use suspension_core::linkages::double_wishbone::{Corner, Drives, Model, Points};
use suspension_core::{Bounded, Build, Inputs, Linkage, Motion, Real, Signal, Values};

/// The largest velocity and acceleration after a jump of the wheel's height, with rates of zero; `None` where the step is refused.
fn left<T: Real>(dt: f64, jump: f64) -> Option<[T; 2]> {
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
    let step = Bounded::<T>::default();
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
fn in_single_precision_a_part_of_the_jump_stays_in_the_rates() {
    for (dt, jump, stated) in [
        (1e-3, 0.5e-3, [3e-3_f32, 6.0]),
        (1e-4, 0.5e-3, [0.03, 600.0]),
        (1e-3, 0.9e-3, [0.01, 20.0]),
    ] {
        let found = left::<f32>(dt, jump).expect("an accepted step");
        for (found, stated) in found.into_iter().zip(stated) {
            assert!(
                (0.9..1.1).contains(&(found / stated)),
                "{found} for {stated}"
            );
        }
    }
}

#[test]
fn in_double_precision_such_a_step_is_refused_or_nothing_is_left() {
    for jump in [1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3] {
        let left = left::<f64>(1e-3, jump);
        assert!(
            left.is_none_or(|[_, acceleration]| acceleration < 1e-8),
            "{jump}: {left:?}"
        );
    }
}
