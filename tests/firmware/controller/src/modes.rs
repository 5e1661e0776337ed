//! All modes of the loop.

use crate::baked::{self, WHEEL_F32, WHEEL_F64};
use crate::follow::{Gauge, Report, baked, loaded, solved};
use crate::steps;

/// Runs each mode, which is named by its counted function, and reports it.
macro_rules! run {
    ($gauge:ident, $tell:ident: solved $($name:ident)*) => {
        $($tell(stringify!($name), solved($gauge, steps::$name));)*
    };
    ($gauge:ident, $tell:ident: loads $($name:ident)*) => {
        $($tell(stringify!($name), loaded($gauge, steps::$name));)*
    };
    ($gauge:ident, $tell:ident: $wheel:ident $($name:ident)*) => {
        $($tell(stringify!($name), baked($gauge, &$wheel, baked::$name));)*
    };
}

/// The modes in `f32`. The report is a mode's name and its results, or the step that fails.
pub fn single(gauge: &impl Gauge, tell: &mut impl FnMut(&'static str, Result<Report, u32>)) {
    run!(gauge, tell: solved
        attia2003_f32_exact five_link_f32_exact
        attia2003_f32_bounded_acceleration five_link_f32_bounded_acceleration
        attia2003_f32_bounded_uncorrected five_link_f32_bounded_uncorrected
        five_link_f32_bounded_position five_link_f32_bounded_velocity);
    run!(gauge, tell: loads attia2003_f32_loads five_link_f32_loads);
    run!(gauge, tell: WHEEL_F32
        wheel_f32_baked_position wheel_f32_baked_velocity wheel_f32_baked_acceleration);
}

/// The modes in `f64`.
pub fn double(gauge: &impl Gauge, tell: &mut impl FnMut(&'static str, Result<Report, u32>)) {
    run!(gauge, tell: solved
        attia2003_f64_exact five_link_f64_exact
        attia2003_f64_bounded_acceleration five_link_f64_bounded_acceleration
        five_link_f64_bounded_position five_link_f64_bounded_velocity);
    run!(gauge, tell: loads attia2003_f64_loads five_link_f64_loads);
    run!(gauge, tell: WHEEL_F64
        wheel_f64_baked_position wheel_f64_baked_velocity wheel_f64_baked_acceleration);
}
