//! Readings of each wheel on the ground, and of its carrier in travel and in steering.

use nalgebra::Vector3;
use suspension_core::wheel::{Heading, SteeringAxis};

use crate::mechanism::Names;
use crate::quantities::kind::Kind;
use crate::quantities::quantity::{Axis, Reading};
use crate::quantities::readings::{components, of_each_wheel, place, reading};
use crate::quantities::wheel::{Along, Moving, Number, Rolling, UNKNOWN, Wheel, at};

/// The contact point.
pub(super) fn of_contact(names: &Names) -> Vec<Reading> {
    of_each_wheel(names, |rolling| {
        if !rolling.is_on_ground() {
            return Vec::new();
        }
        place(None, move |reader| reader.wheel(rolling).contact)
    })
}

/// What a steering axis is to a point of the wheel.
type Offset = fn(&SteeringAxis<Number>, &Vector3<Number>, &Heading<Number>) -> Number;

/// Where the kingpin passes the contact point.
pub(super) fn of_kingpin_at_ground(names: &Names, offset: Offset) -> Vec<Reading> {
    of_kingpin_at(names, true, offset, |wheel| wheel.contact)
}

/// Where the kingpin passes the wheel centre.
pub(super) fn of_kingpin_at_centre(names: &Names, offset: Offset) -> Vec<Reading> {
    of_kingpin_at(names, false, offset, |wheel| wheel.centre)
}

/// `on_ground` where the wheel radius is needed.
fn of_kingpin_at(
    names: &Names,
    on_ground: bool,
    offset: Offset,
    point: fn(&Wheel) -> Vector3<Number>,
) -> Vec<Reading> {
    of_each_wheel(names, |rolling| {
        let ends = rolling.points.kingpin;
        let ends = ends.filter(|_| rolling.is_on_ground() || !on_ground);
        let of = |[lower, upper]: [usize; 2]| {
            reading(Kind::Length, move |reader| {
                let wheel = reader.wheel(rolling);
                let kingpin = SteeringAxis::through([at(reader, lower), at(reader, upper)]);
                offset(&kingpin, &point(wheel), &wheel.heading)
            })
        };
        ends.map(of).into_iter().collect()
    })
}

/// A number of each carrier as it moves; `on_ground` where the wheel radius is needed.
pub(super) fn of_moving(
    names: &Names,
    along: Along,
    kind: Kind,
    on_ground: bool,
    value: impl Fn(&Moving) -> Number + Clone + 'static,
) -> Vec<Reading> {
    of_each_wheel(names, |rolling| {
        moving(rolling, along, kind, on_ground, value.clone())
    })
}

/// A number of each carrier of one wheel alone in travel, on the ground: a force on that wheel is borne by its links.
pub(super) fn of_independent(
    names: &Names,
    kind: Kind,
    value: impl Fn(&Moving) -> Number + Clone + 'static,
) -> Vec<Reading> {
    of_each_wheel(names, |rolling| {
        let rolling = Some(rolling).filter(|rolling| rolling.is_alone(names));
        let readings =
            rolling.map(|rolling| moving(rolling, Along::Travel, kind, true, value.clone()));
        readings.unwrap_or_default()
    })
}

/// The same of the carrier of one wheel.
pub(super) fn moving(
    rolling: Rolling,
    along: Along,
    kind: Kind,
    on_ground: bool,
    value: impl Fn(&Moving) -> Number + 'static,
) -> Vec<Reading> {
    if !is_moved(&rolling, along, on_ground) {
        return Vec::new();
    }
    vec![reading(kind, move |reader| {
        let moving = reader.moving(along, rolling);
        moving.map_or(UNKNOWN, &value)
    })]
}

/// Coordinates of a place that the carrier's motion tells.
pub(super) fn of_moving_place(
    names: &Names,
    along: Along,
    axes: &[Axis],
    place: fn(&Moving) -> Vector3<Number>,
) -> Vec<Reading> {
    of_each_wheel(names, |rolling| {
        if !is_moved(&rolling, along, false) {
            return Vec::new();
        }
        components(None, Kind::Length, axes, move |reader| {
            let moving = reader.moving(along, rolling);
            let place = moving.map_or_else(|| Vector3::repeat(UNKNOWN), place);
            reader.axes.turned(place)
        })
    })
}

/// Whether the file names the drive by which a wheel moves.
fn is_moved(rolling: &Rolling, along: Along, on_ground: bool) -> bool {
    rolling.drive(along).is_some() && (rolling.is_on_ground() || !on_ground)
}
