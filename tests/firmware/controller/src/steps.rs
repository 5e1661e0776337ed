//! The counted calls: one step of the control loop each, as one call of a function that is not inlined. Their names are
//! those of the symbols.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::nalgebra::SVector;
use suspension_core::solve::report::Report;
use suspension_core::statics::Loads;
use suspension_core::step::bounded::{Outputs, Refusal};
use suspension_core::{Bounded, Inputs, Motion, SolveError, Still, Tracker};

use crate::follow::Borne;
use crate::published::STEP;

/// Exports a step to the tolerance, with as many corrections as necessary.
macro_rules! exact {
    ($linkage:ident, $number:ty: $name:ident) => {
        /// Steps to the tolerance.
        #[unsafe(no_mangle)]
        #[inline(never)]
        pub fn $name(
            model: &$linkage::Model<$number>,
            inputs: &Inputs<Still, $linkage::Drives<$number>>,
            motion: &mut Motion<$number, 15>,
        ) -> Result<Report<$number>, SolveError<$number>> {
            Tracker::default().step(model, inputs, STEP as $number, motion)
        }
    };
}

/// Exports an attempt at a step of fixed cost, with one correction if it solves for the acceleration and otherwise two.
macro_rules! bounded {
    ($linkage:ident, $number:ty, $outputs:ident, $corrections:literal: $name:ident) => {
        /// Steps at a fixed cost.
        #[unsafe(no_mangle)]
        #[inline(never)]
        pub fn $name(
            model: &$linkage::Model<$number>,
            inputs: &Inputs<Still, $linkage::Drives<$number>>,
            motion: &mut Motion<$number, 15>,
        ) -> Result<Report<$number>, Refusal> {
            Bounded::<$number, $corrections>::new().attempt(
                Outputs::$outputs,
                model,
                inputs,
                STEP as $number,
                motion,
            )
        }
    };
}

/// Exports the multipliers and the force on the drive due to forces at the points: those of links in N. The Jacobian is
/// factored again.
macro_rules! loads {
    ($linkage:ident, $number:ty: $name:ident) => {
        /// Forces at the points of a state.
        #[unsafe(no_mangle)]
        #[inline(never)]
        pub fn $name(
            model: &$linkage::Model<$number>,
            drives: &$linkage::Drives<$number>,
            position: &SVector<$number, 15>,
            forces: &$linkage::Points<$number>,
        ) -> Result<Borne<$number>, SolveError<$number>> {
            let loads = Loads::new(model, *drives, position, forces)?;
            Ok(Borne {
                multipliers: *loads.multipliers(),
                on_drive: loads.on_drives().theta,
            })
        }
    };
}

exact!(attia2003, f32: attia2003_f32_exact);
exact!(attia2003, f64: attia2003_f64_exact);
exact!(five_link, f32: five_link_f32_exact);
exact!(five_link, f64: five_link_f64_exact);
bounded!(attia2003, f32, Acceleration, 1: attia2003_f32_bounded_acceleration);
bounded!(attia2003, f64, Acceleration, 1: attia2003_f64_bounded_acceleration);
bounded!(five_link, f32, Position, 2: five_link_f32_bounded_position);
bounded!(five_link, f64, Position, 2: five_link_f64_bounded_position);
bounded!(five_link, f32, Velocity, 2: five_link_f32_bounded_velocity);
bounded!(five_link, f64, Velocity, 2: five_link_f64_bounded_velocity);
bounded!(five_link, f32, Acceleration, 1: five_link_f32_bounded_acceleration);
bounded!(five_link, f64, Acceleration, 1: five_link_f64_bounded_acceleration);
// The omitted terms of a step without corrections are rounding in `f32`.
bounded!(attia2003, f32, Acceleration, 0: attia2003_f32_bounded_uncorrected);
bounded!(five_link, f32, Acceleration, 0: five_link_f32_bounded_uncorrected);
loads!(attia2003, f32: attia2003_f32_loads);
loads!(attia2003, f64: attia2003_f64_loads);
loads!(five_link, f32: five_link_f32_loads);
loads!(five_link, f64: five_link_f64_loads);
