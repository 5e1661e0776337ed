//! A wheel on the ground, and its carrier as one drive moves it.

use std::cell::OnceCell;

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_core::body::angular_velocity_and_rates;
use suspension_core::wheel::{Carrier, Heading, InstantCentre, SteeringAxis, contact};

use crate::mechanism::{Names, Points, State, WheelPoints};

/// A number with its derivatives along the rates of a state.
pub(super) type Number = Signal<f64>;

/// What does not exist, or is not known.
pub(super) const UNKNOWN: Number = Signal {
    value: f64::NAN,
    rate: f64::NAN,
    second_rate: f64::NAN,
};

/// A point in local coordinates, in the axes of ISO 8855.
pub(super) fn at(state: &State, point: usize) -> Vector3<Number> {
    let of = |points: &Points| state.axes.turned(points[point]);
    state.points.map(of).components()
}

/// From one point to another, in those axes.
pub(super) fn from_to(state: &State, [from, to]: [usize; 2]) -> Vector3<Number> {
    let between = |points: &Points| state.axes.turned(points[to] - points[from]);
    state.points.map(between).components()
}

/// The origin of local coordinates, in those axes.
pub(super) fn origin(state: &State) -> Vector3<Number> {
    state.axes.turned(state.origin).map(Signal::still)
}

/// What is known of a wheel in every state.
#[derive(Clone, Copy)]
pub(super) struct Rolling {
    /// Its number among the linkage's.
    pub(super) number: usize,
    pub(super) points: WheelPoints,
    /// NaN where the file has none.
    pub(super) radius: f64,
    pub(super) travel: Option<usize>,
    pub(super) steer: Option<usize>,
    /// Its axis at the design position, in local coordinates.
    design: Option<[Vector3<f64>; 2]>,
}

impl Rolling {
    /// The wheels of a linkage, with their names.
    pub(super) fn each(names: &Names) -> impl Iterator<Item = (&str, Self)> {
        let wheels = names.wheels.iter().enumerate();
        wheels.map(|(number, wheel)| {
            let rolling = Self {
                number,
                points: wheel.points,
                radius: wheel.radius.unwrap_or(f64::NAN),
                travel: wheel.travel,
                steer: wheel.steer,
                design: wheel.design,
            };
            (wheel.name.as_str(), rolling)
        })
    }

    /// Whether the body that carries it carries no other wheel, and its travel moves none.
    pub(super) fn is_alone(&self, names: &Names) -> bool {
        let carrier = self.points.carrier;
        if names.wheels[self.number].moves_another {
            return false;
        }
        let others = names.wheels.iter().enumerate();
        let mut others = others.filter(|(number, _)| *number != self.number);
        !others.any(|(_, other)| other.points.carrier == carrier)
    }

    /// The drive that moves it, where the file names one.
    pub(super) fn drive(&self, along: Along) -> Option<usize> {
        match along {
            Along::Travel => self.travel,
            Along::Steer => self.steer,
        }
    }

    /// Whether its radius is known.
    pub(super) fn is_on_ground(&self) -> bool {
        !self.radius.is_nan()
    }
}

/// A wheel in a state, in local coordinates and the axes of ISO 8855.
pub(super) struct Wheel {
    pub(super) centre: Vector3<Number>,
    pub(super) axis: Vector3<Number>,
    /// Not finite where the file has no wheel radius.
    pub(super) contact: Vector3<Number>,
    pub(super) heading: Heading<Number>,
}

impl Wheel {
    pub(super) fn of(state: &State, Rolling { points, radius, .. }: Rolling) -> Self {
        let [_, centre] = points.axis;
        Self::with(at(state, centre), from_to(state, points.axis), radius)
    }

    /// The same at the design position, where that is known.
    pub(super) fn at_design(state: &State, rolling: Rolling) -> Option<Self> {
        let ends = rolling.design?.map(|end| state.axes.turned(end));
        let [inner, centre] = ends.map(|end| end.map(Signal::still));
        Some(Self::with(centre, centre - inner, rolling.radius))
    }

    fn with(centre: Vector3<Number>, axis: Vector3<Number>, radius: f64) -> Self {
        Self {
            contact: contact(&centre, &axis, Signal::still(radius)),
            heading: Heading::of(&axis),
            centre,
            axis,
        }
    }
}

/// The drive by which a mechanism moves, the others held.
#[derive(Clone, Copy)]
pub(super) enum Along {
    Travel,
    Steer,
}

/// A carrier and its wheel as one drive moves them, in the axes of ISO 8855, from the file's origin.
pub(super) struct Moving {
    pub(super) carrier: Carrier<Number>,
    pub(super) axis: Vector3<Number>,
    /// Not finite where the file has no wheel radius.
    pub(super) contact: Vector3<Number>,
    pub(super) heading: Heading<Number>,
    screw: OnceCell<SteeringAxis<Number>>,
}

impl Moving {
    /// `None` where the mechanism locks.
    pub(super) fn of(
        state: &State,
        drive: usize,
        points: WheelPoints,
        wheel: &Wheel,
    ) -> Option<Self> {
        let velocities = state.moved_by(drive)?;
        let of = |all: &Points, point: usize| state.axes.turned(all[point]);
        let [first, second, third] = points.carrier;
        let of_carrier = |all: &Points| [of(all, first), of(all, second), of(all, third)];
        let (places, rates) = (state.points.map(of_carrier), velocities.map(of_carrier));
        let omega = angular_velocity_and_rates(&places, &rates)?.components();
        let of_first = |all: &Points| of(all, first);
        let to_centre = wheel.centre - at(state, first);
        let origin = origin(state);
        Some(Self {
            contact: wheel.contact + origin,
            axis: wheel.axis,
            heading: wheel.heading,
            screw: OnceCell::new(),
            carrier: Carrier {
                centre: wheel.centre + origin,
                velocity: velocities.map(of_first).components() + omega.cross(&to_centre),
                omega,
            },
        })
    }

    /// Its instant centre in the front view, where it turns there.
    pub(super) fn front_view(&self) -> InstantCentre<Number> {
        self.where_it_turns(0, self.carrier.front_view(&self.axis))
    }

    /// The same in the side view.
    pub(super) fn side_view(&self) -> InstantCentre<Number> {
        self.where_it_turns(1, self.carrier.side_view())
    }

    /// An instant centre where the carrier turns about a line along an axis by more than rounding, else none.
    fn where_it_turns(&self, axis: usize, centre: InstantCentre<Number>) -> InstantCentre<Number> {
        const ROUNDING: f64 = 1e-12;
        let values = |vector: Vector3<Number>| vector.map(|component| component.value);
        let omega = values(self.carrier.omega);
        let size = values(self.axis).norm();
        let largest = omega
            .amax()
            .max(values(self.carrier.velocity).norm() / size);
        if omega[axis].abs() > ROUNDING * largest {
            return centre;
        }
        InstantCentre {
            across: UNKNOWN,
            z: UNKNOWN,
            arm: UNKNOWN,
        }
    }

    /// The axis about which the carrier turns.
    pub(super) fn screw(&self) -> &SteeringAxis<Number> {
        let Carrier {
            centre,
            velocity,
            omega,
        } = &self.carrier;
        let screw = || SteeringAxis::of_screw(centre, velocity, omega);
        self.screw.get_or_init(screw)
    }

    /// How far the carrier moves along that axis for a radian about it.
    pub(super) fn pitch(&self) -> Number {
        let Carrier {
            velocity, omega, ..
        } = &self.carrier;
        omega.dot(velocity) / omega.dot(omega)
    }
}
