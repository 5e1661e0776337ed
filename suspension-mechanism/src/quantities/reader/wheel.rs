//! A wheel on the ground, and its carrier as one drive moves it.

use std::cell::OnceCell;

use nalgebra::Vector3;
use suspension_core::body::angular_velocity_of;
use suspension_core::wheel::{Carrier, Heading, InstantCentre, SteeringAxis, contact};

use crate::mechanism::{self, Coupling, Names, Pair, WheelPoints};
use crate::quantities::number::Number;
use crate::quantities::reader::iso_positions::IsoPositions;
use crate::quantities::reader::opposite_wheel::OppositeWheel;

/// The data of a wheel that are the same in every state.
#[derive(Clone, Copy)]
pub(crate) struct Rolling {
    /// Its number among the linkage's wheels.
    pub(crate) number: usize,
    pub(crate) points: WheelPoints,
    /// NaN if the file has none.
    pub(crate) radius: f64,
    pub(crate) travel: Option<usize>,
    pub(crate) steer: Option<usize>,
    /// The coupling of its travel with that of other wheels.
    pub(crate) coupling: Coupling,
    /// Whether the body that carries it carries another wheel on the other side of the vehicle.
    pub(crate) shares_its_carrier: bool,
    opposite: Option<OppositeWheel>,
    /// Its axis at the design position, in local coordinates.
    design: Option<[Vector3<f64>; 2]>,
}

impl Rolling {
    /// The wheels of a linkage, with their names.
    pub(crate) fn each(names: &Names) -> impl Iterator<Item = (&str, Self)> {
        let (wheels, pairs) = (&names.wheels, Pair::all(&names.wheels));
        wheels.iter().enumerate().map(move |(number, wheel)| {
            let rolling = Self {
                number,
                points: wheel.points,
                radius: wheel.radius.unwrap_or(f64::NAN),
                travel: wheel.travel,
                steer: wheel.steer,
                coupling: wheel.coupling,
                shares_its_carrier: mechanism::Wheel::shares_its_carrier(wheels, number),
                opposite: OppositeWheel::find(wheels, &pairs, number),
                design: wheel.design,
            };
            (wheel.name.as_str(), rolling)
        })
    }

    /// The wheel that is held at its height in travel, if travel takes the drives of both.
    pub(crate) fn held(&self) -> Option<&OppositeWheel> {
        let is_held = self.coupling.takes_both_drives;
        self.opposite.as_ref().filter(|_| is_held)
    }

    /// The wheel that rises as far in the side view, if one of the two moves the other.
    pub(crate) fn heaved(&self) -> Option<&OppositeWheel> {
        let is_heaved = self.coupling.is_coupled() || self.shares_its_carrier;
        self.opposite.as_ref().filter(|_| is_heaved)
    }

    /// Whether it stands in the middle of the vehicle at the design position.
    pub(crate) fn is_in_middle(&self, names: &Names) -> bool {
        names.wheels[self.number].is_in_middle
    }

    /// All wheels with the same drive of travel, including this one.
    pub(crate) fn moved_together(&self, names: &Names) -> Vec<Self> {
        let wheels = Self::each(names).map(|(_, wheel)| wheel);
        wheels.filter(|wheel| wheel.travel == self.travel).collect()
    }

    /// The drive that moves it, if the file names one.
    pub(crate) fn drive(&self, motion: CarrierMotion) -> Option<usize> {
        match motion {
            CarrierMotion::Travel | CarrierMotion::SideView => self.travel,
            CarrierMotion::Steer => self.steer,
        }
    }

    /// Whether its radius is known.
    pub(crate) fn is_on_ground(&self) -> bool {
        !self.radius.is_nan()
    }
}

/// A wheel in a state, in local coordinates and the axes of ISO 8855.
pub(crate) struct Wheel<N> {
    pub(crate) centre: Vector3<N>,
    pub(crate) axis: Vector3<N>,
    /// Not finite if the file has no wheel radius.
    pub(crate) contact: Vector3<N>,
    pub(crate) heading: Heading<N>,
}

/// A wheel's share of a force along its height if one drive moves several wheels: each bears in proportion to its
/// rise per unit of the drive, `rise`, so that together the forces do the drive's work.
pub(crate) fn share(together: &[Rolling], rolling: Rolling, rise: impl Fn(Rolling) -> f64) -> f64 {
    let squares: f64 = together.iter().map(|wheel| rise(*wheel).powi(2)).sum();
    rise(rolling).powi(2) / squares
}

impl<N: Number> Wheel<N> {
    pub(crate) fn read(
        positions: &IsoPositions<'_, N>,
        Rolling { points, radius, .. }: Rolling,
    ) -> Self {
        let [inner, centre] = points.axis.map(|end| positions.at(end));
        Self::new(centre, centre - inner, radius)
    }

    /// The wheel at the design position, if that is known.
    pub(crate) fn at_design(positions: &IsoPositions<'_, N>, rolling: Rolling) -> Option<Self> {
        let [inner, centre] = rolling.design?.map(|end| positions.still(end));
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

/// The motion of a wheel's carrier, with all drives held that have no part in it.
#[derive(Clone, Copy)]
pub(crate) enum CarrierMotion {
    /// Up or down, with the other wheel of its axle held at its height.
    Travel,
    /// The same, or heave if one wheel of the axle moves the other: both centres then rise by the same amount.
    SideView,
    /// By the drive of steering.
    Steer,
}

/// A carrier and its wheel when one drive moves them, or several, in the axes of ISO 8855, from the file's origin.
pub(crate) struct MovingWheel<N> {
    pub(crate) carrier: Carrier<N>,
    pub(crate) axis: Vector3<N>,
    /// Not finite if the file has no wheel radius.
    pub(crate) contact: Vector3<N>,
    pub(crate) heading: Heading<N>,
    screw: OnceCell<SteeringAxis<N>>,
}

/// The carrier of a wheel when a drive moves it, in local coordinates; `None` if the mechanism locks.
pub(crate) fn carrier<N: Number>(
    positions: &IsoPositions<'_, N>,
    drive: usize,
    points: WheelPoints,
) -> Option<Carrier<N>> {
    let at = points.carrier.map(|point| positions.at(point));
    let [first, second, third] = points.carrier.map(|point| positions.velocity(point, drive));
    let rates = [first?, second?, third?];
    let omega = angular_velocity_of(&at, &rates);
    let [_, centre] = points.axis.map(|end| positions.at(end));
    Some(Carrier {
        centre,
        velocity: rates[0] + omega.cross(&(centre - at[0])),
        omega,
    })
}

impl<N: Number> MovingWheel<N> {
    /// `None` if the mechanism locks.
    pub(crate) fn compute(
        positions: &IsoPositions<'_, N>,
        drive: usize,
        points: WheelPoints,
        wheel: &Wheel<N>,
    ) -> Option<Self> {
        let carrier = carrier(positions, drive, points)?;
        let origin = positions.origin();
        Some(Self {
            contact: wheel.contact + origin,
            axis: wheel.axis,
            heading: wheel.heading,
            screw: OnceCell::new(),
            carrier: Carrier {
                centre: carrier.centre + origin,
                ..carrier
            },
        })
    }

    /// The same wheel with another motion of its carrier.
    pub(crate) fn with(self, carrier: Carrier<N>) -> Self {
        Self {
            carrier,
            screw: OnceCell::new(),
            ..self
        }
    }

    /// Its instant centre in the front view, if it turns there.
    pub(crate) fn front_view(&self) -> InstantCentre<N> {
        self.where_it_turns(0, self.carrier.front_view(&self.axis))
    }

    /// Its instant centre in the side view, if it turns there.
    pub(crate) fn side_view(&self) -> InstantCentre<N> {
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
    pub(crate) fn screw(&self) -> &SteeringAxis<N> {
        let Carrier {
            centre,
            velocity,
            omega,
        } = &self.carrier;
        let screw = || SteeringAxis::of_screw(centre, velocity, omega);
        self.screw.get_or_init(screw)
    }

    /// How far the carrier moves along that axis per radian about it.
    pub(crate) fn pitch(&self) -> N {
        let Carrier {
            velocity, omega, ..
        } = &self.carrier;
        omega.dot(velocity) / omega.dot(omega)
    }
}
