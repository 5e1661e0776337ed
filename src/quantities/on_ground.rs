//! Readings of a wheel on the ground, and of its carrier in travel and in steering.

use nalgebra::Vector3;
use suspension_core::wheel::{Heading, SteeringAxis};

use crate::mechanism::Names;
use crate::quantities::kind::Kind;
use crate::quantities::quantity::{Axis, Reading};
use crate::quantities::readings::{alone, components, place, reading};
use crate::quantities::wheel::{Along, Moving, Number, Rolling, Wheel, at};

/// The wheel of a linkage.
fn rolling(names: &Names) -> Option<Rolling> {
    Some(Rolling {
        points: names.wheel?,
        radius: names.vehicle.wheel_radius.unwrap_or(f64::NAN),
    })
}

/// The same where the file has its radius.
fn rolling_on_ground(names: &Names) -> Option<Rolling> {
    rolling(names).filter(|rolling| !rolling.radius.is_nan())
}

/// The contact point.
pub(super) fn of_contact(names: &Names) -> Vec<Reading> {
    rolling_on_ground(names).map_or_else(Vec::new, |rolling| {
        place(None, move |reader| reader.wheel(rolling).contact)
    })
}

/// What a steering axis is to a point of the wheel.
type Offset = fn(&SteeringAxis<Number>, &Vector3<Number>, &Heading<Number>) -> Number;

/// Where the kingpin passes the contact point.
pub(super) fn of_kingpin_at_ground(names: &Names, offset: Offset) -> Vec<Reading> {
    of_kingpin_at(names, rolling_on_ground(names), offset, |wheel| {
        wheel.contact
    })
}

/// Where the kingpin passes the wheel centre.
pub(super) fn of_kingpin_at_centre(names: &Names, offset: Offset) -> Vec<Reading> {
    of_kingpin_at(names, rolling(names), offset, |wheel| wheel.centre)
}

fn of_kingpin_at(
    names: &Names,
    rolling: Option<Rolling>,
    offset: Offset,
    point: fn(&Wheel) -> Vector3<Number>,
) -> Vec<Reading> {
    let Some((rolling, [lower, upper])) = rolling.zip(names.kingpin) else {
        return Vec::new();
    };
    vec![reading(Kind::Length, move |reader| {
        let wheel = reader.wheel(rolling);
        let kingpin = SteeringAxis::through([at(reader, lower), at(reader, upper)]);
        offset(&kingpin, &point(wheel), &Heading::of(&wheel.axis))
    })]
}

/// A number of the carrier as it moves; `on_ground` where the wheel radius is needed.
pub(super) fn of_moving(
    names: &Names,
    along: Along,
    kind: Kind,
    on_ground: bool,
    value: impl Fn(&Moving) -> Number + 'static,
) -> Vec<Reading> {
    let read = moved(names, along, on_ground).map(|rolling| {
        reading(kind, move |reader| {
            let moving = reader.moving(along, rolling);
            moving.map_or(alone(f64::NAN), &value)
        })
    });
    read.into_iter().collect()
}

/// Coordinates of a place that the carrier's motion tells.
pub(super) fn of_moving_place(
    names: &Names,
    along: Along,
    axes: &[Axis],
    place: fn(&Moving) -> Vector3<Number>,
) -> Vec<Reading> {
    let Some(rolling) = moved(names, along, false) else {
        return Vec::new();
    };
    components(None, Kind::Length, axes, move |reader| {
        let moving = reader.moving(along, rolling);
        let place = moving.map_or_else(|| Vector3::repeat(alone(f64::NAN)), place);
        reader.axes.turned(place)
    })
}

/// The wheel, where the file names the drive by which it moves.
fn moved(names: &Names, along: Along, on_ground: bool) -> Option<Rolling> {
    let vehicle = names.vehicle;
    match along {
        Along::Travel => vehicle.travel?,
        Along::Steer => vehicle.steer?,
    };
    if on_ground {
        rolling_on_ground(names)
    } else {
        rolling(names)
    }
}
