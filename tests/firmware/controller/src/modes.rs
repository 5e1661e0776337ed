//! All modes of the loop.

use crate::baked::{self, WHEEL_F32, WHEEL_F64};
use crate::follow::{Counter, Report, baked, solved};
use crate::steps;

/// What becomes of a mode's name and its report; `None` where a step fails.
pub trait Tell: FnMut(&'static str, Option<Report>) {}

impl<F: FnMut(&'static str, Option<Report>)> Tell for F {}

/// The modes in `f32`.
pub fn single(counter: &impl Counter, tell: &mut impl Tell) {
    macro_rules! run {
        (solved $($name:ident)*) => {
            $(let mode = stringify!($name);
            tell(mode, solved(counter, mode, steps::$name, |done| done.residual));)*
        };
        (baked $($name:ident)*) => {
            $(let mode = stringify!($name);
            tell(mode, baked(counter, mode, &WHEEL_F32, baked::$name));)*
        };
    }
    run!(solved attia2003_f32_exact attia2003_f32_bounded_position attia2003_f32_bounded_velocity
        attia2003_f32_bounded_acceleration);
    run!(solved five_link_f32_exact five_link_f32_bounded_position five_link_f32_bounded_velocity
        five_link_f32_bounded_acceleration);
    run!(baked wheel_f32_baked_position wheel_f32_baked_velocity wheel_f32_baked_acceleration);
}
