//! Look-ups in baked motions.

use suspension_core::baked::{Curve, Split, Surface};

fn curve<T: Split>(
    curve: &Curve<'_, T, 6, 6>,
    [drive, rate, second_rate]: [T; 3],
    read: &mut [[T; 6]; 3],
) -> bool {
    let clipped = |outside: suspension_core::baked::Outside<T>| curve.at(outside.nearest);
    let place = curve.at(drive).or_else(clipped);
    place.is_ok_and(|place| {
        *read = place.acceleration(rate, second_rate);
        true
    })
}

fn surface<T: Split>(
    surface: &Surface<'_, T, 6, 6>,
    [drives, rates, second_rates]: [[T; 2]; 3],
    read: &mut [[T; 6]; 3],
) -> bool {
    surface.at(drives).is_ok_and(|place| {
        *read = place.acceleration(rates, second_rates);
        true
    })
}

macro_rules! export {
    ($number:ident: $curve:ident, $surface:ident) => {
        #[unsafe(no_mangle)]
        extern "C" fn $curve(
            baked: &Curve<'_, $number, 6, 6>,
            drive: &[$number; 3],
            read: &mut [[$number; 6]; 3],
        ) -> bool {
            curve(baked, *drive, read)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $surface(
            baked: &Surface<'_, $number, 6, 6>,
            drives: &[[$number; 2]; 3],
            read: &mut [[$number; 6]; 3],
        ) -> bool {
            surface(baked, *drives, read)
        }
    };
}

export!(f32: firmware_baked_f32_curve, firmware_baked_f32_surface);
export!(f64: firmware_baked_f64_curve, firmware_baked_f64_surface);
