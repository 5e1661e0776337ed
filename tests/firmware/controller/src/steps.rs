//! What is counted: one step of the control loop, as one call of a function that nothing is
//! inlined into. Their names are those of the symbols.

use suspension_core::bounded::Refusal;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{
    Bounded, Converged, Inputs, Motion, Outputs, Settled, SolveError, Still, Tracker,
};

use crate::published::STEP;

/// Exports the steps of one linkage in one number type.
macro_rules! export {
    ($linkage:ident, $number:ty: $exact:ident, $position:ident, $velocity:ident, $acceleration:ident $(, $unswept:ident)?) => {
        /// To the tolerance, by as many corrections as it takes.
        #[unsafe(no_mangle)]
        #[inline(never)]
        pub fn $exact(
            model: &$linkage::Model<$number>,
            inputs: &Inputs<Still, $linkage::Drives<$number>>,
            motion: &mut Motion<$number, 15>,
        ) -> Result<Converged<$number>, SolveError<$number>> {
            Tracker::default().step(model, inputs, STEP as $number, motion)
        }

        export!($linkage, $number, Position, 2, $position);
        export!($linkage, $number, Velocity, 2, $velocity);
        export!($linkage, $number, Acceleration, 1, $acceleration);
        // Nothing but rounding is left out of it in `f32`.
        $(export!($linkage, $number, Acceleration, 0, $unswept);)?
    };
    ($linkage:ident, $number:ty, $outputs:ident, $sweeps:literal, $name:ident) => {
        #[unsafe(no_mangle)]
        #[inline(never)]
        /// At a fixed cost.
        pub fn $name(
            model: &$linkage::Model<$number>,
            inputs: &Inputs<Still, $linkage::Drives<$number>>,
            motion: &mut Motion<$number, 15>,
        ) -> Result<Settled<$number>, Refusal> {
            Bounded::<$number, $sweeps>::default().attempt(
                Outputs::$outputs,
                model,
                inputs,
                STEP as $number,
                motion,
            )
        }
    };
}

export!(attia2003, f32: attia2003_f32_exact, attia2003_f32_bounded_position,
    attia2003_f32_bounded_velocity, attia2003_f32_bounded_acceleration,
    attia2003_f32_bounded_unswept);
export!(attia2003, f64: attia2003_f64_exact, attia2003_f64_bounded_position,
    attia2003_f64_bounded_velocity, attia2003_f64_bounded_acceleration);
export!(five_link, f32: five_link_f32_exact, five_link_f32_bounded_position,
    five_link_f32_bounded_velocity, five_link_f32_bounded_acceleration,
    five_link_f32_bounded_unswept);
export!(five_link, f64: five_link_f64_exact, five_link_f64_bounded_position,
    five_link_f64_bounded_velocity, five_link_f64_bounded_acceleration);
