//! Readings of an axle: of two wheels, one on each side of the vehicle.

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_core::signal::Number as _;
use suspension_core::wheel::Turn;

use crate::mechanism::{Axle, Names};
use crate::quantities::in_roll::PerRoll;
use crate::quantities::kind::Kind;
use crate::quantities::quantity::{Axis, Reading};
use crate::quantities::reader::Reader;
use crate::quantities::readings::{components, of_each_wheel, reading};
use crate::quantities::wheel::{Number, Rolling, UNKNOWN, Wheel};

/// Within this mean steer angle, a degree, toe decides how the wheels of an axle differ, not the steering.
const STRAIGHT: f64 = std::f64::consts::PI / 180.0;

/// The wheels of a linkage that has two.
fn axle(names: &Names) -> Option<[Rolling; 2]> {
    let wheels: Vec<Rolling> = Rolling::each(names).map(|(_, rolling)| rolling).collect();
    wheels.try_into().ok()
}

/// The same where the wheel radius is known.
fn axle_on_ground(names: &Names) -> Option<[Rolling; 2]> {
    axle(names).filter(|wheels| wheels.iter().all(Rolling::is_on_ground))
}

/// The same where each wheel has a drive of travel of its own, so that the axle can roll.
fn axle_that_rolls(names: &Names) -> Option<[Rolling; 2]> {
    let is_moved = |[a, b]: &[Rolling; 2]| a.travel != b.travel && a.travel.and(b.travel).is_some();
    axle_on_ground(names).filter(is_moved)
}

/// The left wheel and the right one; `None` where both are on one side.
fn sided(reader: &Reader<'_>, [a, b]: [Rolling; 2]) -> Option<[Rolling; 2]> {
    let is_right = |rolling| reader.wheel(rolling).axis.y.is_below_zero();
    match (is_right(a), is_right(b)) {
        (false, true) => Some([a, b]),
        (true, false) => Some([b, a]),
        _ => None,
    }
}

/// A number of both wheels, the left one first; `on_ground` where the wheel radius is needed.
pub(super) fn of_both(
    names: &Names,
    kind: Kind,
    on_ground: bool,
    value: impl Fn([&Wheel; 2]) -> Number + 'static,
) -> Vec<Reading> {
    let wheels = if on_ground {
        axle_on_ground(names)
    } else {
        axle(names)
    };
    let of = |wheels| {
        reading(kind, move |reader: &Reader<'_>| {
            let wheels = sided(reader, wheels);
            wheels.map_or(UNKNOWN, |wheels| {
                value(wheels.map(|rolling| reader.wheel(rolling)))
            })
        })
    };
    wheels.map(of).into_iter().collect()
}

/// An angle of the spin axis of each wheel of a steered axle.
pub(super) fn of_steered_wheels(
    names: &Names,
    angle: fn(&Vector3<Number>) -> Number,
) -> Vec<Reading> {
    if axle(names).is_none() || names.vehicle.steer.is_empty() {
        return Vec::new();
    }
    of_each_wheel(names, |rolling| {
        vec![reading(Kind::Angle, move |reader| {
            angle(&reader.wheel(rolling).axis)
        })]
    })
}

/// A number of an axle that steers a vehicle whose wheelbase is known: of the turn, the wheelbase and the track. Straight
/// ahead there is none.
pub(super) fn of_turn(
    names: &Names,
    kind: Kind,
    value: fn(&Turn<Number>, Number, Number) -> Number,
) -> Vec<Reading> {
    let vehicle = &names.vehicle;
    let is_rear = vehicle.car.is_some_and(|car| car.axle == Axle::Rear);
    let Some(wheelbase) = vehicle.wheelbase else {
        return Vec::new();
    };
    if is_rear || vehicle.steer.is_empty() {
        return Vec::new();
    }
    of_both(names, kind, true, move |wheels| {
        let turn = Turn::of(wheels.map(|wheel| &wheel.axis));
        if turn.inner.value + turn.outer.value < 2.0 * STRAIGHT {
            return UNKNOWN;
        }
        value(&turn, Signal::still(wheelbase), track(wheels))
    })
}

/// From the right contact point to the left one, along y.
pub(super) fn track([left, right]: [&Wheel; 2]) -> Number {
    left.contact.y - right.contact.y
}

/// Where the axle's roll centre is, in the front view.
pub(super) fn of_roll_centre(names: &Names) -> Vec<Reading> {
    let of = |wheels| {
        components(None, Kind::Length, &[Axis::Y, Axis::Z], move |reader| {
            let wheels = sided(reader, wheels);
            let in_roll = wheels.and_then(|wheels| reader.in_roll(wheels));
            let centre = in_roll.map_or(Vector3::repeat(UNKNOWN), |in_roll| in_roll.centre);
            reader.axes.turned(centre)
        })
    };
    axle_that_rolls(names)
        .map(of)
        .into_iter()
        .flatten()
        .collect()
}

/// What each wheel has per radian of the axle's roll.
pub(super) fn of_roll(names: &Names, value: fn(PerRoll) -> Number) -> Vec<Reading> {
    let Some(wheels) = axle_that_rolls(names) else {
        return Vec::new();
    };
    of_each_wheel(names, |rolling| {
        vec![reading(Kind::AnglePerAngle, move |reader| {
            let wheels = sided(reader, wheels);
            let in_roll = wheels.and_then(|wheels| reader.in_roll(wheels));
            let per_roll = in_roll.and_then(|in_roll| in_roll.of_wheel(rolling.number));
            per_roll.map_or(UNKNOWN, value)
        })]
    })
}
