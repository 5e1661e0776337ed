//! The counted call for the baked wheel pose: one look-up in the curve.

use suspension_core::baked::Curve;

use crate::wheel_by_theta::WHEEL_BY_THETA;

/// The wheel's pose over the driving angle.
pub type Wheel<T> = Curve<'static, T, 6, 6>;

const SEGMENTS: usize = WHEEL_BY_THETA.segments.len();

/// The curve in `f64`.
pub static WHEEL_F64: Wheel<f64> = WHEEL_BY_THETA;

/// The curve in `f32`.
pub static WHEEL_F32: Wheel<f32> = Curve {
    range: [
        WHEEL_BY_THETA.range[0] as f32,
        WHEEL_BY_THETA.range[1] as f32,
    ],
    segments_per_unit: WHEEL_BY_THETA.segments_per_unit as f32,
    segments: &rounded(),
};

const fn rounded() -> [[[f32; 6]; 6]; SEGMENTS] {
    let mut rounded = [[[0.0; 6]; 6]; SEGMENTS];
    let mut place = 0;
    while place < SEGMENTS * 36 {
        let (segment, power, output) = (place / 36, place / 6 % 6, place % 6);
        rounded[segment][power][output] = WHEEL_BY_THETA.segments[segment][power][output] as f32;
        place += 1;
    }
    rounded
}

/// Exports the look-ups in one number type: from a drive and its rates to the pose and its rates.
macro_rules! export {
    ($number:ty: $position:ident, $velocity:ident, $acceleration:ident) => {
        /// Only the position.
        #[unsafe(no_mangle)]
        #[inline(never)]
        pub fn $position(
            wheel: &Wheel<$number>,
            [drive, _, _]: &[$number; 3],
            [position, _, _]: &mut [[$number; 6]; 3],
        ) -> bool {
            let found = wheel.at(*drive).map(|place| place.position());
            found.map(|found| *position = found).is_ok()
        }

        /// Position and velocity.
        #[unsafe(no_mangle)]
        #[inline(never)]
        pub fn $velocity(
            wheel: &Wheel<$number>,
            [drive, rate, _]: &[$number; 3],
            [position, velocity, _]: &mut [[$number; 6]; 3],
        ) -> bool {
            let found = wheel.at(*drive).map(|place| place.velocity(*rate));
            found.map(|found| [*position, *velocity] = found).is_ok()
        }

        /// Position, velocity and acceleration.
        #[unsafe(no_mangle)]
        #[inline(never)]
        pub fn $acceleration(
            wheel: &Wheel<$number>,
            [drive, rate, second_rate]: &[$number; 3],
            pose: &mut [[$number; 6]; 3],
        ) -> bool {
            let found = wheel
                .at(*drive)
                .map(|place| place.acceleration(*rate, *second_rate));
            found.map(|found| *pose = found).is_ok()
        }
    };
}

export!(f32: wheel_f32_baked_position, wheel_f32_baked_velocity, wheel_f32_baked_acceleration);
export!(f64: wheel_f64_baked_position, wheel_f64_baked_velocity, wheel_f64_baked_acceleration);
