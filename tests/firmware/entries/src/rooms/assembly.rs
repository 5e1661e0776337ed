//! The first configuration from a rough guess.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{Build, Inputs, Motion, Newton, Real, Signal, assemble};

fn start<T, L>(linkage: &L, points: &L::Points, motion: &mut Motion<T, 15>) -> bool
where
    T: Real,
    L: Build<15, Scalar = T>,
{
    let inputs = Inputs::still(Signal {
        value: linkage.drives_at(points),
        rate: L::Drives::default(),
        second_rate: L::Drives::default(),
    });
    let mut position = linkage.unknowns(points);
    let assembled = assemble(&Newton::from_afar(), linkage, &inputs, &mut position);
    *motion = Motion::at_rest(position);
    assembled.is_ok()
}

/// Exports it for one linkage and one number type.
macro_rules! export {
    ($name:ident, $linkage:ident, $number:ty) => {
        #[unsafe(no_mangle)]
        extern "C" fn $name(
            linkage: &$linkage::Model<$number>,
            points: &$linkage::Points<$number>,
            motion: &mut Motion<$number, 15>,
        ) -> bool {
            start(linkage, points, motion)
        }
    };
}

export!(firmware_attia2003_f32_start, attia2003, f32);
export!(firmware_attia2003_f64_start, attia2003, f64);
export!(firmware_five_link_f32_start, five_link, f32);
export!(firmware_five_link_f64_start, five_link, f64);
