//! Conversion of the core's results to C.

use core::mem::MaybeUninit;

use suspension_core::nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion, Vector3};
use suspension_core::solve::assemble;
use suspension_core::{Real, Signal, wheel};

use crate::shared::{Assembly, CarrierRotation, Kingpin, Report, RigidMotion, Wheel, WheelRates};
use crate::status::Status;
use crate::values::{Rates, Values};

/// Writes a result if C asks for it.
#[inline(always)]
pub fn fill<A, B: From<A>>(place: Option<&mut MaybeUninit<B>>, found: A) {
    if let Some(place) = place {
        place.write(found.into());
    }
}

impl<T: Real> From<suspension_core::solve::report::Report<T>> for Report<T> {
    fn from(found: suspension_core::solve::report::Report<T>) -> Self {
        Self {
            iterations: found.iterations as u32,
            steps: found.steps as u32,
            residual: found.residual(),
            tolerance: found.tolerance(),
            error: found.error(),
            growth: found.growth(),
        }
    }
}

impl<T: Real> From<assemble::Assembly<T>> for Assembly<T> {
    fn from(found: assemble::Assembly<T>) -> Self {
        Self {
            distance: found.distance,
            next: found.next.unwrap_or(T::one() / T::zero()),
            residual: found.report.residual(),
            tolerance: found.report.tolerance(),
        }
    }
}

/// Computes the wheel on a spin axis.
pub fn wheel_of<T: Real>(axis: [Vector3<T>; 2]) -> Result<Wheel<T>, Status> {
    let found = wheel::Wheel::of(axis).ok_or(Status::NoDirection)?;
    Ok(wheel_with(&found, wheel::camber_to_ground(&found.axis)))
}

/// Computes the wheel on a spin axis with its derivatives.
pub fn wheel_rates_of<T: Real>(axis: &Signal<[Vector3<T>; 2]>) -> Result<WheelRates<T>, Status> {
    let found = wheel::Wheel::with_rates(axis).ok_or(Status::NoDirection)?;
    let along = axis.map(|[inner, centre]| centre - inner);
    let to_ground = wheel::camber_to_ground(&along.components());
    Ok(WheelRates {
        value: wheel_of(axis.value)?,
        rate: wheel_with(&found.rate, to_ground.rate),
        second_rate: wheel_with(&found.second_rate, to_ground.second_rate),
    })
}

fn wheel_with<T: Real>(found: &wheel::Wheel<T>, camber_to_ground: T) -> Wheel<T> {
    Wheel {
        centre: found.centre.into(),
        axis: found.axis.into(),
        camber: found.camber,
        camber_to_ground,
        toe: found.toe,
    }
}

/// Computes the rotation of the body that carries the wheel.
pub fn rotation_of<T: Real>(
    points: &Signal<[Vector3<T>; 3]>,
) -> Result<CarrierRotation<T>, Status> {
    let found = wheel::CarrierRotation::of(points).ok_or(Status::NoDirection)?;
    Ok(CarrierRotation {
        omega: found.omega.into(),
        alpha: found.alpha.into(),
    })
}

/// Computes the kingpin between two points, on the side of the wheel.
pub fn kingpin_of<T: Real>(
    [lower, upper]: [Vector3<T>; 2],
    axis: [Vector3<T>; 2],
) -> Result<Kingpin<T>, Status> {
    // The wheel determines which side is outboard.
    wheel_of(axis)?;
    check_direction((upper - lower).norm()).ok_or(Status::NoDirection)?;
    let found = wheel::Kingpin::of([lower, upper], axis);
    Ok(Kingpin {
        angle: found.angle,
        caster: found.caster,
    })
}

/// Returns `None` if a vector of this length has no direction.
fn check_direction<T: Real>(length: T) -> Option<()> {
    (length > T::zero() && length.is_finite()).then_some(())
}

impl<T: Real> RigidMotion<T> {
    /// Converts to the core's type.
    pub fn body(&self) -> Result<suspension_core::chassis::RigidMotion<T>, Status> {
        let [w, x, y, z] = self.rotation;
        let rotation = Quaternion::new(w, x, y, z);
        check_direction(rotation.norm()).ok_or(Status::Argument)?;
        Ok(suspension_core::chassis::RigidMotion {
            pose: Isometry3::from_parts(
                Translation3::from(Vector3::from(self.position)),
                UnitQuaternion::new_normalize(rotation),
            ),
            velocity: self.velocity.into(),
            omega: self.omega.into(),
            acceleration: self.acceleration.into(),
            alpha: self.alpha.into(),
        })
    }
}

impl<T: Real, const COUNT: usize> Rates<Values<[T; 3], COUNT>> {
    /// Transforms points that move in chassis axes to world axes.
    pub fn carried(&self, chassis: &RigidMotion<T>) -> Result<Self, Status> {
        let body = chassis.body()?;
        let mut carried = *self;
        let Rates {
            value,
            rate,
            second_rate,
        } = &mut carried;
        let rates = rate.values.iter_mut().zip(&mut second_rate.values);
        for (value, (rate, second_rate)) in value.values.iter_mut().zip(rates) {
            let found = body.carry(Signal {
                value: Vector3::from(*value),
                rate: Vector3::from(*rate),
                second_rate: Vector3::from(*second_rate),
            });
            *value = found.value.into();
            *rate = found.rate.into();
            *second_rate = found.second_rate.into();
        }
        Ok(carried)
    }
}
