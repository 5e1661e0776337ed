//! Steps by series. All settings are arguments, so that no branch is optimised away.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::step::series::{ChassisSeries, InputSeries, Jet, Series, SeriesTracker};
use suspension_core::{Linkage, Motion, Real, Still};

/// The order of the series.
const ORDER: usize = 6;

fn step<T, L, C>(
    tracker: &SeriesTracker<T, ORDER>,
    linkage: &L,
    inputs: &InputSeries<C, L::Drives, ORDER>,
    dt: T,
    motion: &mut Motion<T, 15>,
) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T>,
    C: ChassisSeries<T, L::Fixed, ORDER>,
{
    tracker.step(linkage, inputs, dt, motion).is_ok()
}

/// Returns the motion at `dt` and the radius of convergence; `false` if that is not known.
fn look_ahead<T, L>(
    linkage: &L,
    drives: &Jet<L::Drives, ORDER>,
    dt: T,
    motion: &mut Motion<T, 15>,
    radius: &mut T,
) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T>,
{
    match Series::at(linkage, &InputSeries::still(*drives), &motion.position) {
        Ok(series) => {
            *motion = series.motion(dt);
            series.radius().map(|found| *radius = found).is_some()
        }
        Err(_) => false,
    }
}

/// Exports the calls for one linkage and one number type.
macro_rules! export {
    ($linkage:ident, $number:ty: $step:ident, $moving_step:ident, $look_ahead:ident) => {
        #[unsafe(no_mangle)]
        extern "C" fn $step(
            tracker: &SeriesTracker<$number, ORDER>,
            linkage: &$linkage::Model<$number>,
            drives: &Jet<$linkage::Drives<$number>, ORDER>,
            dt: $number,
            motion: &mut Motion<$number, 15>,
        ) -> bool {
            let drives = *drives;
            let chassis = Still;
            step(
                tracker,
                linkage,
                &InputSeries { chassis, drives },
                dt,
                motion,
            )
        }

        #[unsafe(no_mangle)]
        extern "C" fn $moving_step(
            tracker: &SeriesTracker<$number, ORDER>,
            linkage: &$linkage::Model<$number>,
            chassis: &Jet<$linkage::Fixed<$number>, ORDER>,
            drives: &Jet<$linkage::Drives<$number>, ORDER>,
            dt: $number,
            motion: &mut Motion<$number, 15>,
        ) -> bool {
            let (chassis, drives) = (*chassis, *drives);
            step(
                tracker,
                linkage,
                &InputSeries { chassis, drives },
                dt,
                motion,
            )
        }

        #[unsafe(no_mangle)]
        extern "C" fn $look_ahead(
            linkage: &$linkage::Model<$number>,
            drives: &Jet<$linkage::Drives<$number>, ORDER>,
            dt: $number,
            motion: &mut Motion<$number, 15>,
            radius: &mut $number,
        ) -> bool {
            look_ahead(linkage, drives, dt, motion, radius)
        }
    };
}

export!(attia2003, f32: firmware_attia2003_f32_series_step,
    firmware_attia2003_f32_series_moving_step, firmware_attia2003_f32_look_ahead);
export!(attia2003, f64: firmware_attia2003_f64_series_step,
    firmware_attia2003_f64_series_moving_step, firmware_attia2003_f64_look_ahead);
export!(five_link, f32: firmware_five_link_f32_series_step,
    firmware_five_link_f32_series_moving_step, firmware_five_link_f32_look_ahead);
export!(five_link, f64: firmware_five_link_f64_series_step,
    firmware_five_link_f64_series_moving_step, firmware_five_link_f64_look_ahead);
