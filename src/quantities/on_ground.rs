//! Readings of a wheel on the ground, and of its carrier in travel and in steering.

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_core::body::angular_velocity;
use suspension_core::wheel::{Carrier, Heading, SteeringAxis, contact};

use crate::mechanism::{Names, State, WheelPoints};
use crate::quantities::kind::Kind;
use crate::quantities::quantity::{Axis, Number, Reading};
use crate::quantities::readings::{alone, at, from_to, place, reading, vector};

/// A wheel in a state, in local coordinates.
struct Wheel {
    centre: Vector3<Number>,
    axis: Vector3<Number>,
}

impl Wheel {
    fn of(state: &State, points: WheelPoints) -> Self {
        let [_, centre] = points.axis;
        Self {
            centre: at(state, centre),
            axis: from_to(state, points.axis),
        }
    }

    fn contact(&self, radius: f64) -> Vector3<Number> {
        contact(&self.centre, &self.axis, Signal::still(radius))
    }
}

/// The contact point.
pub(super) fn of_contact(names: &Names) -> Vec<Reading> {
    let radius = names.wheel.zip(names.vehicle.wheel_radius);
    radius.map_or_else(Vec::new, |(wheel, radius)| {
        place(None, move |state| Wheel::of(state, wheel).contact(radius))
    })
}

/// What a steering axis is to a point of the wheel.
type Offset = fn(&SteeringAxis<Number>, &Vector3<Number>, &Heading<Number>) -> Number;

/// Where the kingpin passes the contact point.
pub(super) fn of_kingpin_at_ground(names: &Names, offset: Offset) -> Vec<Reading> {
    let Some(radius) = names.vehicle.wheel_radius else {
        return Vec::new();
    };
    of_kingpin_at(names, offset, move |wheel| wheel.contact(radius))
}

/// Where the kingpin passes the wheel centre.
pub(super) fn of_kingpin_at_centre(names: &Names, offset: Offset) -> Vec<Reading> {
    of_kingpin_at(names, offset, |wheel| wheel.centre)
}

fn of_kingpin_at(
    names: &Names,
    offset: Offset,
    point: impl Fn(&Wheel) -> Vector3<Number> + 'static,
) -> Vec<Reading> {
    let Some((wheel, [lower, upper])) = names.wheel.zip(names.kingpin) else {
        return Vec::new();
    };
    vec![reading(Kind::Length, move |state| {
        let wheel = Wheel::of(state, wheel);
        let kingpin = SteeringAxis::through([at(state, lower), at(state, upper)]);
        offset(&kingpin, &point(&wheel), &Heading::of(&wheel.axis))
    })]
}

/// A carrier and its wheel in one direction of motion, in the file's coordinates.
pub(super) struct Moving {
    pub(super) carrier: Carrier<f64>,
    pub(super) axis: Vector3<f64>,
    /// Not finite where the file has no wheel radius.
    pub(super) contact: Vector3<f64>,
}

impl Moving {
    fn of(state: &State, along: Along, wheel: WheelPoints, radius: f64) -> Option<Self> {
        let points = match along {
            Along::Travel => state.travel.as_ref()?,
            Along::Steer => state.steer.as_ref()?,
        };
        let [inner, centre] = wheel.axis;
        let [at, rates] =
            [&points.value, &points.rate].map(|all| wheel.carrier.map(|point| all[point]));
        let axis = points.value[centre] - points.value[inner];
        let carrier = Carrier {
            centre: points.value[centre] + state.origin,
            velocity: points.rate[centre],
            omega: angular_velocity(&at, &rates)?,
        };
        Some(Self {
            contact: contact(&carrier.centre, &axis, radius),
            carrier,
            axis,
        })
    }

    /// The axis about which the carrier turns.
    pub(super) fn screw(&self) -> SteeringAxis<f64> {
        let Carrier {
            centre,
            velocity,
            omega,
        } = &self.carrier;
        SteeringAxis::of_screw(centre, velocity, omega)
    }

    /// How far the carrier moves along that axis for a radian about it.
    pub(super) fn pitch(&self) -> f64 {
        let Carrier {
            velocity, omega, ..
        } = &self.carrier;
        let upwards = omega.z.signum();
        upwards * omega.dot(velocity) / (omega.norm() * omega.norm())
    }

    /// Horizontal directions of the wheel.
    pub(super) fn heading(&self) -> Heading<f64> {
        Heading::of(&self.axis)
    }
}

/// The drive by which a mechanism moves, the others held.
#[derive(Clone, Copy)]
pub(super) enum Along {
    Travel,
    Steer,
}

/// A number of the carrier as it moves; `on_ground` where the wheel radius is needed.
pub(super) fn of_moving(
    names: &Names,
    along: Along,
    kind: Kind,
    on_ground: bool,
    value: fn(&Moving) -> f64,
) -> Vec<Reading> {
    let read = reader(names, along, on_ground).map(|read| Reading {
        has_derivatives: false,
        ..reading(kind, move |state| {
            alone(read(state).map_or(f64::NAN, |moving| value(&moving)))
        })
    });
    read.into_iter().collect()
}

/// Coordinates of a place that the carrier's motion tells.
pub(super) fn of_moving_place(
    names: &Names,
    along: Along,
    axes: &[Axis],
    place: fn(&Moving) -> Vector3<f64>,
) -> Vec<Reading> {
    let Some(read) = reader(names, along, false) else {
        return Vec::new();
    };
    vector(None, Kind::Length, axes, move |state| {
        let moving = read(state);
        moving.map_or_else(|| Vector3::repeat(f64::NAN), |moving| place(&moving))
    })
}

/// What reads the carrier off any state; `None` where the linkage or the file has no such thing.
fn reader(
    names: &Names,
    along: Along,
    on_ground: bool,
) -> Option<impl Fn(&State) -> Option<Moving> + Clone + use<>> {
    let vehicle = names.vehicle;
    match along {
        Along::Travel => vehicle.travel?,
        Along::Steer => vehicle.steer?,
    };
    let wheel = names.wheel?;
    let radius = if on_ground {
        vehicle.wheel_radius?
    } else {
        vehicle.wheel_radius.unwrap_or(f64::NAN)
    };
    Some(move |state: &State| Moving::of(state, along, wheel, radius))
}
