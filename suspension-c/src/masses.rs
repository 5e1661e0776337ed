//! Weight and inertia of parts, as forces at their points.

use suspension_core::body::pose;
use suspension_core::inertia::{RigidBody, rod};
use suspension_core::nalgebra::{Matrix3, Vector3};
use suspension_core::{Real, Signal};

use crate::shared::{Mass, Masses};
use crate::status::Status;
use crate::values::{Rates, Values};

/// The position of a point where the masses are stated, and its motion.
type Place<T> = (Vector3<T>, Signal<Vector3<T>>);

/// Calls `add` with the force of weight and inertia at each point.
///
/// # Errors
///
/// [`Status::Argument`] for a mass that is not valid, [`Status::NoDirection`] if the three points of a body
/// are in line, [`Status::Overflow`] if a force is not finite, and the errors of `place`.
pub fn each_force<T: Real>(
    masses: &Masses<T>,
    place: impl Fn(usize) -> Result<Place<T>, Status>,
    mut add: impl FnMut(usize, Vector3<T>),
) -> Result<(), Status> {
    let gravity = Vector3::from(masses.gravity());
    for mass in masses.get()? {
        for (point, force) in mass.forces(&gravity, &place)?.into_iter().flatten() {
            if !force.iter().all(|part| part.is_finite()) {
                return Err(Status::Overflow);
            }
            add(point, force);
        }
    }
    Ok(())
}

/// Adds a force at a point.
pub fn add_at<T: Real>(forces: &mut [[T; 3]], point: usize, force: Vector3<T>) {
    if let Some(at) = forces.get_mut(point) {
        *at = (Vector3::from(*at) + force).into();
    }
}

/// Returns the position and motion of a point by its number.
pub fn place<T: Real, const COUNT: usize>(
    design: &Values<[T; 3], COUNT>,
    points: &Rates<Values<[T; 3], COUNT>>,
    point: usize,
) -> Result<Place<T>, Status> {
    let at = |all: &Values<[T; 3], COUNT>| {
        let found = all.values.get(point).copied();
        found.map(Vector3::from).ok_or(Status::Absent)
    };
    let stated = at(design)?;
    let moving = Signal {
        value: at(&points.value)?,
        rate: at(&points.rate)?,
        second_rate: at(&points.second_rate)?,
    };
    Ok((stated, moving))
}

type AtPoints<T> = [Option<(usize, Vector3<T>)>; 3];

impl<T: Real> Mass<T> {
    fn forces(
        &self,
        gravity: &Vector3<T>,
        place: impl Fn(usize) -> Result<Place<T>, Status>,
    ) -> Result<AtPoints<T>, Status> {
        let of_body = self.centre.iter().chain(&self.inertia);
        let is_mass = self.mass.is_finite() && self.mass >= T::zero();
        if !(is_mass && of_body.into_iter().all(|number| number.is_finite())) {
            return Err(Status::Argument);
        }
        let [a, b, c] = self.points.map(|point| point as usize);
        let at = |point: usize| place(point).map(|(_, at)| at);
        Ok(match self.count {
            1 => {
                let force = (gravity - at(a)?.second_rate) * self.mass;
                [Some((a, force)), None, None]
            }
            2 => {
                let ends = [at(a)?.second_rate, at(b)?.second_rate];
                let [of_a, of_b] = rod(self.mass, ends, gravity);
                [Some((a, of_a)), Some((b, of_b)), None]
            }
            3 => {
                let [of_a, of_b, of_c] =
                    self.of_body(gravity, [place(a)?, place(b)?, place(c)?])?;
                [Some((a, of_a)), Some((b, of_b)), Some((c, of_c))]
            }
            _ => return Err(Status::Argument),
        })
    }

    fn of_body(
        &self,
        gravity: &Vector3<T>,
        held: [Place<T>; 3],
    ) -> Result<[Vector3<T>; 3], Status> {
        let [xx, yy, zz, xy, yz, zx] = self.inertia;
        let body = RigidBody {
            points: held.map(|(stated, _)| stated),
            mass: self.mass,
            centre: self.centre.into(),
            inertia: Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz),
        };
        let at = Signal {
            value: held.map(|(_, at)| at.value),
            rate: held.map(|(_, at)| at.rate),
            second_rate: held.map(|(_, at)| at.second_rate),
        };
        let is_located = pose(&body.points, &at.value).is_some();
        body.forces(&at, gravity).ok_or(if is_located {
            Status::Overflow
        } else {
            Status::NoDirection
        })
    }
}
