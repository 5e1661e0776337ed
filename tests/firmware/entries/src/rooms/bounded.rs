//! Steps of fixed cost. All settings are arguments, so that no branch is optimised away.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Inputs, Linkage, Motion, Real, Signal};

fn step<T, L, const CORRECTIONS: usize>(
    bounded: &Bounded<T, CORRECTIONS>,
    outputs: u8,
    linkage: &L,
    drives: &Signal<L::Drives>,
    dt: T,
    motion: &mut Motion<T, 15>,
) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T>,
{
    let outputs = match outputs {
        0 => Outputs::Position,
        1 => Outputs::Velocity,
        _ => Outputs::Acceleration,
    };
    let inputs = Inputs::still(*drives);
    bounded
        .step_to(outputs, linkage, &inputs, dt, motion)
        .is_ok()
}

/// Exports the step of one linkage in one number type, without corrections, with one and with two.
macro_rules! export {
    ($linkage:ident, $number:ty: $none:ident, $one:ident, $two:ident) => {
        export!($linkage, $number, 0, $none);
        export!($linkage, $number, 1, $one);
        export!($linkage, $number, 2, $two);
    };
    ($linkage:ident, $number:ty, $corrections:literal, $name:ident) => {
        #[unsafe(no_mangle)]
        extern "C" fn $name(
            bounded: &Bounded<$number, $corrections>,
            outputs: u8,
            linkage: &$linkage::Model<$number>,
            drives: &Signal<$linkage::Drives<$number>>,
            dt: $number,
            motion: &mut Motion<$number, 15>,
        ) -> bool {
            step(bounded, outputs, linkage, drives, dt, motion)
        }
    };
}

export!(attia2003, f32: firmware_attia2003_f32_bounded_0, firmware_attia2003_f32_bounded_1, firmware_attia2003_f32_bounded_2);
export!(attia2003, f64: firmware_attia2003_f64_bounded_0, firmware_attia2003_f64_bounded_1, firmware_attia2003_f64_bounded_2);
export!(five_link, f32: firmware_five_link_f32_bounded_0, firmware_five_link_f32_bounded_1, firmware_five_link_f32_bounded_2);
export!(five_link, f64: firmware_five_link_f64_bounded_0, firmware_five_link_f64_bounded_1, firmware_five_link_f64_bounded_2);
