//! A wheel on the ground, and its carrier as one drive moves it.

use std::cell::OnceCell;

use nalgebra::Vector3;
use suspension_core::body::angular_velocity_of;
use suspension_core::wheel::{Carrier, Heading, InstantCentre, SteeringAxis, contact};

use crate::mechanism::{Coupling, Names, WheelPoints};
use crate::quantities::number::Number;
use crate::quantities::places::Places;

/// The data of a wheel that are the same in every state.
#[derive(Clone, Copy)]
pub(super) struct Rolling {
    /// Its number among the linkage's wheels.
    pub(super) number: usize,
    pub(super) points: WheelPoints,
    /// NaN if the file has none.
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

    /// Whether the body that carries it carries another wheel on the other side of the vehicle.
    pub(super) fn shares_its_carrier(&self, names: &Names) -> bool {
        let own = &names.wheels[self.number];
        let others = names.wheels.iter().enumerate();
        let mut others = others.filter(|(number, _)| *number != self.number);
        others.any(|(_, other)| other.is_across_on_one_body(own))
    }

    /// Whether it stands in the middle of the vehicle at the design position.
    pub(super) fn is_in_middle(&self, names: &Names) -> bool {
        names.wheels[self.number].is_in_middle
    }

    /// The coupling of its travel with that of other wheels.
    pub(super) fn coupling(&self, names: &Names) -> Coupling {
        names.wheels[self.number].coupling
    }

    /// All wheels with the same drive of travel, including this one.
    pub(super) fn moved_together(&self, names: &Names) -> Vec<Self> {
        let wheels = Self::each(names).map(|(_, wheel)| wheel);
        wheels.filter(|wheel| wheel.travel == self.travel).collect()
    }

    /// The drive that moves it, if the file names one.
    pub(super) fn drive(&self, along: Along) -> Option<usize> {
        match along {
            Along::Travel | Along::Held(_) | Along::Heave(_) => self.travel,
            Along::Steer => self.steer,
        }
    }

    /// Whether its radius is known.
    pub(super) fn is_on_ground(&self) -> bool {
        !self.radius.is_nan()
    }
}

/// A wheel in a state, in local coordinates and the axes of ISO 8855.
pub(super) struct Wheel<N> {
    pub(super) centre: Vector3<N>,
    pub(super) axis: Vector3<N>,
    /// Not finite if the file has no wheel radius.
    pub(super) contact: Vector3<N>,
    pub(super) heading: Heading<N>,
}

/// A wheel's share of a force along its height if one drive moves several wheels: each bears in proportion to its
/// rise per unit of the drive, `rise`, so that together the forces do the drive's work.
pub(super) fn share(together: &[Rolling], rolling: Rolling, rise: impl Fn(Rolling) -> f64) -> f64 {
    let squares: f64 = together.iter().map(|wheel| rise(*wheel).powi(2)).sum();
    rise(rolling).powi(2) / squares
}

impl<N: Number> Wheel<N> {
    pub(super) fn read(places: &Places<'_, N>, Rolling { points, radius, .. }: Rolling) -> Self {
        let [inner, centre] = points.axis.map(|end| places.at(end));
        Self::new(centre, centre - inner, radius)
    }

    /// The wheel at the design position, if that is known.
    pub(super) fn at_design(places: &Places<'_, N>, rolling: Rolling) -> Option<Self> {
        let [inner, centre] = rolling.design?.map(|end| places.still(end));
        Some(Self::new(centre, centre - inner, rolling.radius))
    }

    fn new(centre: Vector3<N>, axis: Vector3<N>, radius: f64) -> Self {
        Self {
            contact: contact(&centre, &axis, N::still(radius)),
            heading: Heading::of(&axis),
            centre,
            axis,
        }
    }
}

/// The drives that move a wheel's carrier, with all others held.
#[derive(Clone, Copy)]
pub(super) enum Along {
    /// The wheel's drive of travel.
    Travel,
    /// The drives of travel of both wheels of its axle, the given one being the other wheel, whose centre keeps its
    /// height.
    Held(Rolling),
    /// The same drives, with both centres rising by the same amount.
    Heave(Rolling),
    /// The wheel's drive of steering.
    Steer,
}

/// A carrier and its wheel when one drive moves them, or several, in the axes of ISO 8855, from the file's origin.
pub(super) struct Moving<N> {
    pub(super) carrier: Carrier<N>,
    pub(super) axis: Vector3<N>,
    /// Not finite if the file has no wheel radius.
    pub(super) contact: Vector3<N>,
    pub(super) heading: Heading<N>,
    screw: OnceCell<SteeringAxis<N>>,
}

impl<N: Number> Moving<N> {
    /// `None` if the mechanism locks.
    pub(super) fn compute(
        places: &Places<'_, N>,
        drive: usize,
        points: WheelPoints,
        wheel: &Wheel<N>,
    ) -> Option<Self> {
        let velocity = |point: usize| places.velocity(point, drive);
        let [first, second, third] = points.carrier;
        let at = points.carrier.map(|point| places.at(point));
        let rates = [velocity(first)?, velocity(second)?, velocity(third)?];
        let omega = angular_velocity_of(&at, &rates);
        let to_centre = wheel.centre - at[0];
        let origin = places.origin();
        Some(Self {
            contact: wheel.contact + origin,
            axis: wheel.axis,
            heading: wheel.heading,
            screw: OnceCell::new(),
            carrier: Carrier {
                centre: wheel.centre + origin,
                velocity: rates[0] + omega.cross(&to_centre),
                omega,
            },
        })
    }

    /// The same wheel with another motion of its carrier.
    pub(super) fn with(self, carrier: Carrier<N>) -> Self {
        Self {
            carrier,
            screw: OnceCell::new(),
            ..self
        }
    }

    /// Its instant centre in the front view, if it turns there.
    pub(super) fn front_view(&self) -> InstantCentre<N> {
        self.where_it_turns(0, self.carrier.front_view(&self.axis))
    }

    /// Its instant centre in the side view, if it turns there.
    pub(super) fn side_view(&self) -> InstantCentre<N> {
        self.where_it_turns(1, self.carrier.side_view())
    }

    /// An instant centre if the carrier turns about a line along an axis by more than rounding, otherwise none.
    fn where_it_turns(&self, axis: usize, centre: InstantCentre<N>) -> InstantCentre<N> {
        const ROUNDING: f64 = 1e-12;
        let values = |vector: Vector3<N>| vector.map(N::value);
        let omega = values(self.carrier.omega);
        let size = values(self.axis).norm();
        let largest = omega
            .amax()
            .max(values(self.carrier.velocity).norm() / size);
        if omega[axis].abs() > ROUNDING * largest {
            return centre;
        }
        InstantCentre {
            across: N::unknown(),
            z: N::unknown(),
            arm: N::unknown(),
        }
    }

    /// The axis about which the carrier turns.
    pub(super) fn screw(&self) -> &SteeringAxis<N> {
        let Carrier {
            centre,
            velocity,
            omega,
        } = &self.carrier;
        let screw = || SteeringAxis::of_screw(centre, velocity, omega);
        self.screw.get_or_init(screw)
    }

    /// How far the carrier moves along that axis per radian about it.
    pub(super) fn pitch(&self) -> N {
        let Carrier {
            velocity, omega, ..
        } = &self.carrier;
        omega.dot(velocity) / omega.dot(omega)
    }
}
