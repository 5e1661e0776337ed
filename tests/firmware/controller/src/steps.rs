//! What is counted: one step of the control loop, as one call of a function that nothing is
//! inlined into. Their names are those of the symbols.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::nalgebra::SVector;
use suspension_core::solve::report::Report;
use suspension_core::statics::Loads;
use suspension_core::step::bounded::{Outputs, Refusal};
use suspension_core::{Bounded, Inputs, Motion, SolveError, Still, Tracker};

use crate::follow::Borne;
use crate::published::STEP;

/// Exports a step to the tolerance, by as many corrections as it takes.
macro_rules! exact {
    ($linkage:ident, $number:ty: $name:ident) => {
        /// To the tolerance.
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

/// Exports an attempt at a step of fixed cost, with one correction where the acceleration is solved for and
/// else two.
macro_rules! bounded {
    ($linkage:ident, $number:ty, $outputs:ident, $corrections:literal: $name:ident) => {
        /// At a fixed cost.
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

/// Exports what forces at the points do to each equation and to the drive: those of links in N. The Jacobian is factored
/// anew.
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
// What a step without corrections leaves out is rounding in `f32`.
bounded!(attia2003, f32, Acceleration, 0: attia2003_f32_bounded_uncorrected);
bounded!(five_link, f32, Acceleration, 0: five_link_f32_bounded_uncorrected);
loads!(attia2003, f32: attia2003_f32_loads);
loads!(attia2003, f64: attia2003_f64_loads);
loads!(five_link, f32: five_link_f32_loads);
loads!(five_link, f64: five_link_f64_loads);
