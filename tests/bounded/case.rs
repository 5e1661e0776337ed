//! The catalogue on the published motion, and how far from it a motion is.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Inputs, Linkage, Motion, Newton, Real, Still, Tangent};

use crate::support::{self, differences};

/// A linkage, its motion at `t = 0`, and its inputs by time.
pub(crate) struct Case<L: Linkage<15>> {
    pub(crate) model: L,
    pub(crate) start: Motion<L::Scalar, 15>,
    pub(crate) inputs: fn(L::Scalar) -> Inputs<Still, L::Drives>,
}

pub(crate) fn attia<T: Real>() -> Case<attia2003::Model<T>> {
    let model = support::attia_model();
    Case {
        start: support::motions(&model, &support::attia_rough(), support::attia_inputs)[0],
        model,
        inputs: support::attia_inputs,
    }
}

pub(crate) fn five_link<T: Real>() -> Case<five_link::Model<T>> {
    let model = support::five_link_model();
    let (rough, inputs) = (support::five_link_rough(), support::five_link_inputs);
    Case {
        start: support::motions(&model, &rough, inputs)[0],
        model,
        inputs,
    }
}

impl<L: Linkage<15, Scalar = f64>> Case<L> {
    /// Returns the motion at `t` by Newton's method, from a start with a small error, and the tangent there.
    pub(crate) fn solution(&self, t: f64, near_by: &Motion<f64, 15>) -> Motion<f64, 15> {
        let inputs = (self.inputs)(t);
        let mut position = near_by.position.map(|x| x + 1e-5);
        Newton::from_afar()
            .solve(&self.model, &inputs, &mut position)
            .expect("a root near by");
        let tangent = Tangent::new(&self.model, &inputs, &position).expect("regular");
        tangent.motion().expect("finite rates")
    }

    /// Steps along the instants from the motion at the first, and the largest differences from the
    /// solution at each.
    pub(crate) fn worst<const CORRECTIONS: usize, const ORDER: usize>(
        &self,
        bounded: &Bounded<f64, CORRECTIONS, ORDER>,
        outputs: Outputs,
        instants: &[f64],
    ) -> [f64; 3] {
        let mut motion = self.start;
        let mut worst = [0.0; 3];
        for pair in instants.windows(2) {
            let (dt, t) = (pair[1] - pair[0], pair[1]);
            let settled = bounded
                .step_to(outputs, &self.model, &(self.inputs)(t), dt, &mut motion)
                .unwrap_or_else(|error| panic!("at {t} s: {error}"));
            assert!(settled.residual() <= settled.tolerance(), "{settled:?}");
            widen(&mut worst, differences(&motion, &self.solution(t, &motion)));
        }
        worst
    }
}

/// From 0 to 1.9 s, the published motion without the last part before its turning point.
pub(crate) fn instants(dt: f64) -> Vec<f64> {
    let last = (1.9 / dt).round() as usize;
    (0..=last).map(|step| step as f64 * dt).collect()
}

pub(crate) fn widen<T: Real>(worst: &mut [T; 3], found: [T; 3]) {
    for (worst, found) in worst.iter_mut().zip(found) {
        assert!(found.is_finite());
        *worst = worst.max(found);
    }
}

pub(crate) fn assert_within<T: Real + std::fmt::LowerExp>(
    what: &str,
    found: [T; 3],
    bounds: [T; 3],
) {
    println!("{what}: {found:?}");
    for (found, bound) in found.iter().zip(bounds) {
        assert!(*found <= bound, "{what}: {found:e} > {bound:e}");
    }
}
