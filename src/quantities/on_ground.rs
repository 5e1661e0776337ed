//! Readings of a wheel on the ground, and of its carrier in travel and in steering.

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_core::body::angular_velocity_and_rates;
use suspension_core::signal::Number as _;
use suspension_core::wheel::{Carrier, Heading, SteeringAxis, contact};

use crate::mechanism::{Names, State, WheelPoints};
use crate::quantities::kind::Kind;
use crate::quantities::quantity::{Axis, Number, Reading};
use crate::quantities::readings::{alone, at, components, from_to, place, reading};

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
    pub(super) carrier: Carrier<Number>,
    pub(super) axis: Vector3<Number>,
    /// Not finite where the file has no wheel radius.
    pub(super) contact: Vector3<Number>,
}

impl Moving {
    fn of(state: &State, along: Along, wheel: WheelPoints, radius: f64) -> Option<Self> {
        let velocities = match along {
            Along::Travel => state.travel.as_ref()?,
            Along::Steer => state.steer.as_ref()?,
        };
        let of_carrier = |all: &Vec<Vector3<f64>>| wheel.carrier.map(|point| all[point]);
        let (points, rates) = (state.points.map(of_carrier), velocities.map(of_carrier));
        let omega = angular_velocity_and_rates(&points, &rates)?.components();
        let [first, _, _] = wheel.carrier;
        let velocity = velocities
            .map(|all: &Vec<Vector3<f64>>| all[first])
            .components();
        let mut of_wheel = Wheel::of(state, wheel);
        let velocity = velocity + omega.cross(&(of_wheel.centre - at(state, first)));
        of_wheel.centre += state.origin.map(Signal::still);
        Some(Self {
            contact: of_wheel.contact(radius),
            axis: of_wheel.axis,
            carrier: Carrier {
                centre: of_wheel.centre,
                velocity,
                omega,
            },
        })
    }

    /// The axis about which the carrier turns.
    pub(super) fn screw(&self) -> SteeringAxis<Number> {
        let Carrier {
            centre,
            velocity,
            omega,
        } = &self.carrier;
        SteeringAxis::of_screw(centre, velocity, omega)
    }

    /// How far the carrier moves along that axis for a radian about it.
    pub(super) fn pitch(&self) -> Number {
        let Carrier {
            velocity, omega, ..
        } = &self.carrier;
        let pitch = omega.dot(velocity) / omega.dot(omega);
        if omega.z.is_below_zero() {
            -pitch
        } else {
            pitch
        }
    }

    /// Horizontal directions of the wheel.
    pub(super) fn heading(&self) -> Heading<Number> {
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
    value: impl Fn(&Moving) -> Number + 'static,
) -> Vec<Reading> {
    let read = reader(names, along, on_ground).map(|read| {
        reading(kind, move |state| {
            read(state).map_or(alone(f64::NAN), |moving| value(&moving))
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
    let Some(read) = reader(names, along, false) else {
        return Vec::new();
    };
    components(None, Kind::Length, axes, move |state| {
        let moving = read(state);
        moving.map_or_else(|| Vector3::repeat(alone(f64::NAN)), |moving| place(&moving))
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
