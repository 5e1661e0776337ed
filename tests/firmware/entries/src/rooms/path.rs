//! Curves and led motions. All settings are arguments, so that no branch is optimised away.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::nalgebra::{SVector, Vector3};
use suspension_core::path::{Continuation, Curve, End, Leader, Led, Stretch};
use suspension_core::{Inputs, Linkage, Real, Signal, Values};

/// Follows a curve to its end; the last place is left in `stretch`.
fn follow<T, L>(
    settings: &Continuation<T>,
    linkage: &L,
    drives: &Signal<L::Drives>,
    [drive, increasing]: [usize; 2],
    q: &SVector<T, 15>,
    stretch: &mut Stretch<T, 15>,
) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T>,
{
    let Some(curve) = Curve::new(linkage, &Inputs::still(*drives), drive) else {
        return false;
    };
    let Ok(path) = settings.path(curve, q, increasing > 0) else {
        return false;
    };
    for next in path {
        match next {
            Ok(next) => *stretch = next,
            Err(_) => return false,
        }
    }
    matches!(stretch.end, Some(End::Closed { .. }))
}

/// The height of a point, from above.
fn height<T: Real, P: Values<Vector3<T>>>(points: &Signal<P>, point: usize) -> Signal<T> {
    let z = |points: &P| {
        points
            .values()
            .nth(point)
            .map_or(T::zero(), |point| point.z)
    };
    Signal {
        value: z(&points.value),
        rate: z(&points.rate),
        second_rate: z(&points.second_rate),
    }
}

fn lead<T, L>(
    leader: &Leader<T>,
    linkage: &L,
    drives: &Signal<L::Drives>,
    point: usize,
    target: &Signal<T>,
    dt: T,
    led: &mut Led<T, 15>,
) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T>,
{
    let inputs = Inputs::still(*drives);
    let quantity = |points: &Signal<L::Points>| height(points, point);
    leader
        .step(linkage, &inputs, quantity, target, dt, led)
        .is_ok()
}

/// Exports the calls for one linkage and one number type.
macro_rules! export {
    ($linkage:ident, $number:ty: $follow:ident, $lead:ident) => {
        #[unsafe(no_mangle)]
        extern "C" fn $follow(
            settings: &Continuation<$number>,
            linkage: &$linkage::Model<$number>,
            drives: &Signal<$linkage::Drives<$number>>,
            which: &[usize; 2],
            q: &SVector<$number, 15>,
            stretch: &mut Stretch<$number, 15>,
        ) -> bool {
            follow(settings, linkage, drives, *which, q, stretch)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $lead(
            leader: &Leader<$number>,
            linkage: &$linkage::Model<$number>,
            drives: &Signal<$linkage::Drives<$number>>,
            point: usize,
            target: &Signal<$number>,
            dt: $number,
            led: &mut Led<$number, 15>,
        ) -> bool {
            lead(leader, linkage, drives, point, target, dt, led)
        }
    };
}

export!(attia2003, f32: firmware_attia2003_f32_follow, firmware_attia2003_f32_lead);
export!(attia2003, f64: firmware_attia2003_f64_follow, firmware_attia2003_f64_lead);
export!(five_link, f32: firmware_five_link_f32_follow, firmware_five_link_f32_lead);
export!(five_link, f64: firmware_five_link_f64_follow, firmware_five_link_f64_lead);
